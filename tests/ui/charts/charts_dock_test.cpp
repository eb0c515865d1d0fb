// Dock of charts, over an exhibit with charts and one without. No GL.

#include "tests/exhibits/study/known_law.h"
#include "tests/ui/ui_main.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/museum/museum.h"
#include "ui/charts/charts_dock.h"
#include "ui/kit/theme.h"
#include "ui/model/history.h"

#include <qcustomplot.h>

#include <QAccessible>
#include <QApplication>
#include <QSignalSpy>
#include <QtTest>

#include <atomic>
#include <thread>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

std::atomic<int> made{0};
std::thread::id madeOn;

/// Exhibit whose charts show the value of `steps`.
class Charted final : public Exhibit, public HasCharts {
public:
    [[nodiscard]] std::string_view name() const override { return "charted"; }
    [[nodiscard]] std::string_view title() const override { return "Charted"; }
    [[nodiscard]] std::string_view summary() const override { return "Has charts."; }
    [[nodiscard]] int place() const override { return 8; }
    [[nodiscard]] const test::KnownTable& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {glm::dvec3(-1), glm::dvec3(1)}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return 1e9; }
    void plan(const PlanContext&, render::FramePlan&) const override {}
    [[nodiscard]] std::vector<Chart> charts(const ParameterValues& values) const override
    {
        madeOn = std::this_thread::get_id();
        ++made;
        const double steps = values[table_.steps];
        const ChartCurve line{"now", {1, 10, 100}, {steps, 2 * steps, 0}};
        return {{"Plain", "x", "y", false, {line, {"then", {1, 10, 100}, {1, 1, 1}}}},
                {"Decades", "x", "y", true, {line}}};
    }

private:
    test::KnownTable table_;
};

std::vector<std::unique_ptr<Exhibit>> twoExhibits()
{
    std::vector<std::unique_ptr<Exhibit>> all;
    all.push_back(std::make_unique<Charted>());
    all.push_back(std::make_unique<test::KnownExhibit>(test::sumOfParts()));
    return all;
}

}  // namespace

class ChartsDockTest final : public QObject {
    Q_OBJECT

    std::unique_ptr<Museum> museum_;
    std::unique_ptr<History> history_;
    std::unique_ptr<ChartsDock> dock_;

    void setSteps(std::size_t exhibit, int steps)
    {
        const std::size_t row = *museum_->subject(exhibit).parameters().find("steps");
        history_->set(exhibit, row, static_cast<double>(steps), 0);
    }
    [[nodiscard]] double firstValue() const { return dock_->charts().empty() ? -1 : dock_->charts()[0].curves[0].y[0]; }

private slots:
    void initTestCase() { applyTheme(*qApp, darkTheme()); }
    void init()
    {
        made = 0;
        museum_ = std::make_unique<Museum>(twoExhibits());
        history_ = std::make_unique<History>(museum_->initialSceneState());
        dock_ = std::make_unique<ChartsDock>(*museum_, *history_);
        dock_->setSubject(*museum_->find("charted"));
    }
    void cleanup()
    {
        dock_.reset();
        history_.reset();
        museum_.reset();
    }

    void chartsAreMadeBesideTheWindowAndOnlyWhileTheyAreSeen()
    {
        setSteps(*museum_->find("charted"), 5);
        QTest::qWait(400);
        QCOMPARE(made.load(), 0);
        dock_->show();
        QTRY_COMPARE(firstValue(), 5.0);
        QVERIFY(madeOn != std::this_thread::get_id());
        QVERIFY(dock_->note().isEmpty());
    }

    void curvesFollowTheValuesAndAnswerManyEditsOnce()
    {
        dock_->show();
        QTRY_COMPARE(firstValue(), 8.0);
        const int before = made.load();
        for (int steps = 10; steps <= 30; ++steps) setSteps(*museum_->find("charted"), steps);
        QTRY_COMPARE(firstValue(), 30.0);
        QVERIFY(made.load() <= before + 2);
        QCOMPARE(dock_->plots()[0]->graph(0)->data()->at(0)->value, 30.0);
        QCOMPARE(dock_->plots()[0]->graphCount(), 2);
    }

    void whatIsNotAboveZeroIsLeftOutOfDecades()
    {
        dock_->show();
        QTRY_COMPARE(dock_->plots().size(), 2U);
        QCOMPARE(dock_->plots()[0]->graph(0)->dataCount(), 3);
        QCOMPARE(dock_->plots()[1]->graph(0)->dataCount(), 2);
        QVERIFY(dock_->plots()[1]->yAxis->range().lower > 0);
        QCOMPARE(dock_->plots()[1]->accessibleName(), QStringLiteral("Decades"));
    }

    void aChartSaysItsAxesAndWhereItsCurvesGo()
    {
        dock_->show();
        QTRY_COMPARE(dock_->plots().size(), 2U);
        const QAccessibleInterface* chart = QAccessible::queryAccessibleInterface(dock_->plots()[0]);
        QCOMPARE(chart->role(), QAccessible::Chart);
        QCOMPARE(chart->text(QAccessible::Name), QStringLiteral("Plain"));
        QCOMPARE(chart->text(QAccessible::Description),
                 QStringLiteral("y over x. now: from 0 at 100 to 16 at 10. then: from 1 at 1 to 1 at 100."));
    }

    void anExhibitWithoutChartsSaysSo()
    {
        dock_->show();
        QTRY_COMPARE(dock_->plots().size(), 2U);
        dock_->setSubject(*museum_->find("known"));
        QTRY_VERIFY(dock_->note().contains(QLatin1String("no charts")));
        QVERIFY(dock_->plots().empty());
        dock_->setSubject(*museum_->find("charted"));
        QTRY_COMPARE(dock_->plots().size(), 2U);
    }
};

VITRINE_UI_TEST(ChartsDockTest)
#include "charts_dock_test.moc"
