// The study dock: what it shows, applies and leaves alone, over an exhibit whose law is known. No GL.

#include "tests/ui/point_at.h"
#include "tests/ui/study/known_gallery.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/theme.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_dock.h"
#include "ui/study/study_pictures.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QJsonDocument>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <thread>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

class StudyDockTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<test::KnownGallery> gallery_;
    std::unique_ptr<History> history_;
    std::unique_ptr<RenderThread> thread_;
    std::unique_ptr<StudyDock> dock_;

    [[nodiscard]] std::size_t row(const char* name) const { return *gallery_->table.find(name); }
    [[nodiscard]] double valueNow(const char* name) const
    {
        return std::get<double>(history_->sceneState().values[1].row(row(name)));
    }
    void finish()
    {
        QSignalSpy finished(dock_.get(), &StudyDock::finished);
        QVERIFY(finished.wait(20000));
    }
    void clickOn(std::size_t point)
    {
        dock_->chart().replot();
        QTest::mouseClick(&dock_->chart(), Qt::LeftButton, {}, dock_->chart().placeOf(point).toPoint());
    }

private slots:
    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        gallery_ = std::make_unique<test::KnownGallery>();
        history_ = std::make_unique<History>(gallery_->museum.initialSceneState());
        thread_ = std::make_unique<RenderThread>(*gallery_);
        dock_ =
            std::make_unique<StudyDock>(gallery_->museum, *gallery_, *history_, *thread_, test::storeIn(home_->path()));
        dock_->setEffort({16, 9}, 3);
        dock_->setSubject(1);
        dock_->resize(1000, 320);
        dock_->show();
    }
    void cleanup()
    {
        dock_.reset();
        thread_.reset();
        history_.reset();
        gallery_.reset();
    }

    void pointsAppearWhileItMeasures()
    {
        dock_->ask(1, row("steps"));
        QVERIFY(dock_->running());
        bool someBeforeAll = false;
        while (dock_->running()) {
            QTest::qWait(1);
            const auto& points = dock_->result().points;
            const auto drawn =
                std::count_if(points.begin(), points.end(), [](const StudyPoint& p) { return p.cost > 0; });
            someBeforeAll = someBeforeAll || (drawn > 0 && static_cast<std::size_t>(drawn) < points.size());
        }
        QVERIFY(someBeforeAll);
        QCOMPARE(dock_->chart().points().size(), dock_->result().points.size());
        QVERIFY(!dock_->result().front.empty());
    }

    void theWindowsThreadMeasuresNothing()
    {
        dock_->ask(1, row("steps"));
        finish();
        QVERIFY(gallery_->measuredOn != std::thread::id());
        QVERIFY(gallery_->measuredOn != std::this_thread::get_id());
        QCOMPARE(gallery_->measuredOn, thread_->id());
    }

    void aClickAppliesTheValueAndUndoTakesItBack()
    {
        dock_->ask(1, row("steps"));
        finish();
        QCOMPARE(valueNow("steps"), 8.0);
        const auto& points = dock_->chart().points();
        std::size_t other = 0;
        while (points[other].present || !(points[other].error > 0)) ++other;
        clickOn(other);
        QVERIFY(valueNow("steps") != 8.0);
        QVERIFY(dock_->chart().points()[other].present);
        history_->stack().undo();
        QCOMPARE(valueNow("steps"), 8.0);
        QVERIFY(!dock_->chart().points()[other].present);
    }

    void arrowsChooseAPointEnterAppliesItAndTheChartSaysSo()
    {
        StudyChart& chart = dock_->chart();
        const auto said = [&chart] {
            return QAccessible::queryAccessibleInterface(&chart)->text(QAccessible::Description);
        };
        QCOMPARE(QAccessible::queryAccessibleInterface(&chart)->role(), QAccessible::Chart);
        dock_->ask(1, row("steps"));
        finish();
        QVERIFY2(said().contains("Present: 8, error"), qPrintable(said()));
        QVERIFY(!said().contains("Chosen"));
        const auto cost = [&](double value) {
            for (const ChartPoint& each : chart.points())
                if (each.text.toDouble() == value) return each.cost;
            return -1.0;
        };
        QTest::keyClick(&chart, Qt::Key_Right);
        QVERIFY2(said().contains("Chosen: "), qPrintable(said()));
        const QString cheapest = said();
        QTest::keyClick(&chart, Qt::Key_Left);  // There is none below it.
        QCOMPARE(said(), cheapest);
        QTest::keyClick(&chart, Qt::Key_Return);
        const double applied = valueNow("steps");
        for (const ChartPoint& each : chart.points())
            if (each.cost > 0) QVERIFY(cost(applied) <= each.cost);
        QVERIFY(applied != 8.0);
        QCOMPARE(history_->stack().count(), 1);
        QTest::keyClick(&chart, Qt::Key_Right);
        QTest::keyClick(&chart, Qt::Key_Return);
        QVERIFY(cost(valueNow("steps")) >= cost(applied) && valueNow("steps") != applied);
        QCOMPARE(history_->stack().count(), 2);
    }

    void cancellingLeavesTheSettingsAndTheUndoStackAsTheyWere()
    {
        const SceneState before = history_->sceneState();
        dock_->ask(1, row("rays"));
        for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
        QVERIFY(dock_->running());
        dock_->stop();
        QVERIFY(!dock_->running());
        QVERIFY(history_->sceneState() == before);
        QCOMPARE(history_->stack().count(), 0);
    }

    void theCheapestWithinAnErrorIsAppliedAsOneStep()
    {
        auto* field = dock_->findChildren<QLineEdit*>().front();
        field->setText(QStringLiteral("0.05"));
        emit field->returnPressed();
        finish();
        QVERIFY(dock_->result().choice);
        QVERIFY(dock_->result().choice->holds);
        QCOMPARE(history_->stack().count(), 1);
        const StudyPoint& chosen = dock_->result().points[dock_->result().choice->point];
        QVERIFY(chosen.worstError <= 0.05);
        history_->stack().undo();
        QVERIFY(history_->sceneState() == gallery_->museum.initialSceneState());
    }

    void aLimitThatIsNoNumberIsSaidAndMeasuresNothing()
    {
        auto* field = dock_->findChildren<QLineEdit*>().front();
        for (const char* text : {"soup", "-1", "", "0"}) {
            field->setText(QLatin1String(text));
            emit field->returnPressed();
            QVERIFY(!dock_->running());
        }
    }

    void onlyQualityParametersAreOffered()
    {
        const auto* combo = dock_->findChildren<QComboBox*>().front();
        QCOMPARE(combo->count(), 1 + 4);
        QCOMPARE(combo->findText(QStringLiteral("Hue")), -1);
    }

    void hoveringShowsAPointsPictureAndTheWipeFollowsThePointer()
    {
        dock_->ask(1, row("steps"));
        finish();
        auto* pictures = dock_->findChild<StudyPictures*>();
        QVERIFY(pictures);
        dock_->chart().replot();
        const QImage before = pictures->grab().toImage();
        emit dock_->chart().hovered(0);
        QVERIFY(pictures->grab().toImage() != before);
        vitrine::test::pointAt(*pictures, QPoint(3, 3));
        QVERIFY(pictures->wipe() < 0.2);
    }

    void thePointOnShowStaysWhileThePointerGoesToItsPicture()
    {
        dock_->ask(1, row("steps"));
        finish();
        StudyChart& chart = dock_->chart();
        chart.replot();
        std::size_t other = 0;
        while (chart.points()[other].present) ++other;
        vitrine::test::pointAt(chart, chart.placeOf(other).toPoint());
        auto* pictures = dock_->findChild<StudyPictures*>();
        const QImage hovered = pictures->grab().toImage();
        vitrine::test::pointAt(chart, chart.rect().topRight() + QPoint(-3, 3));  // Over the empty part of the chart ...
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&chart, &leave);  // ... and out of it.
        QCOMPARE(pictures->grab().toImage(), hovered);
        QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.rect().topRight() + QPoint(-3, 3));
        QVERIFY(pictures->grab().toImage() != hovered);  // A press beside all points: the present one again.
    }

    void anEmptyChartShowsNoScale()
    {
        QVERIFY(!dock_->chart().xAxis->visible());
        QVERIFY(!dock_->chart().yAxis->visible());
        dock_->ask(1, row("steps"));
        finish();
        QVERIFY(dock_->chart().xAxis->visible());
        QVERIFY(dock_->chart().yAxis->visible());
    }

    void labelsOfTheChartDoNotLieOverEachOther()
    {
        for (const char* parameter : {"steps", "rays", "method"}) {
            dock_->ask(1, row(parameter));
            finish();
            StudyChart& chart = dock_->chart();
            chart.setPoints(std::vector<ChartPoint>(chart.points()));
            chart.replot();
            std::vector<QRectF> places;
            for (int i = 0; i < chart.itemCount(); ++i) {
                auto* label = qobject_cast<QCPItemText*>(chart.item(i));
                if (!label || label->text() == QStringLiteral("exact")) continue;
                const QRectF place(label->topLeft->pixelPosition(), label->bottomRight->pixelPosition());
                for (const QRectF& other : places)
                    QVERIFY2(!place.adjusted(1, 1, -1, -1).intersects(other), qPrintable(label->text()));
                places.push_back(place);
            }
            QVERIFY(!places.empty());
        }
    }

    void theFormerResultStaysUntilTheNextOneHasAPoint()
    {
        dock_->ask(1, row("steps"));
        finish();
        const std::size_t before = dock_->result().points.size();
        const QString words = dock_->chart().points().front().text;
        dock_->ask(1, row("rays"));
        QVERIFY(dock_->running());
        QCOMPARE(dock_->result().points.size(), before);
        QCOMPARE(dock_->chart().points().front().text, words);
        dock_->stop();  // Before it has a point.
        QCOMPARE(dock_->result().points.size(), before);
        QVERIFY(!dock_->result().front.empty());
        dock_->ask(1, row("rays"));
        finish();
        QCOMPARE(dock_->chart().points().size(), dock_->result().points.size());
    }

    void whatWasMeasuredIsCopiedAndSaved()
    {
        const auto button = [&](const char* text) {
            for (QToolButton* each : dock_->findChildren<QToolButton*>())
                if (each->text() == QLatin1String(text)) return each;
            return static_cast<QToolButton*>(nullptr);
        };
        QVERIFY(!button("Copy")->isEnabled());
        dock_->ask(1, row("steps"));
        finish();
        QVERIFY(button("Copy")->isEnabled());
        button("Copy")->click();
        const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(static_cast<std::size_t>(lines.size()),
                 1 + dock_->result().points.size() * dock_->result().views.size());
        QVERIFY(lines[0].contains("steps"));
        QVERIFY(QJsonDocument::fromJson(dock_->exported("json")).isObject());
        QVERIFY(dock_->exported("svg").contains("<svg"));
        QCOMPARE(QImage::fromData(dock_->exported("png")).size(), QSize(1920, 1200));
    }

    void theHeatMapHasAScale()
    {
        auto* pictures = dock_->findChild<StudyPictures*>();
        QImage gray(64, 36, QImage::Format_RGB888);
        gray.fill(Qt::gray);
        pictures->show(gray, gray, gray, QString());
        const QImage without = pictures->grab().toImage();
        pictures->show(gray, gray, gray, QStringLiteral("0.031"));
        QVERIFY(pictures->grab().toImage() != without);
        QSet<QRgb> colors;
        const QImage seen = pictures->grab().toImage();
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) colors << seen.pixel(x, y);
        QVERIFY(colors.size() > 60);  // A ramp, not a few tones of gray and text.
    }

    void theChartIsOfTheThemeInUse()
    {
        dock_->ask(1, row("method"));
        finish();
        for (const Theme& each : {lightTheme(), darkTheme()}) {
            applyTheme(*qApp, each);
            dock_->chart().applyColors();
            QCOMPARE(dock_->chart().picture({400, 240}, 1).pixelColor(2, 2), each.base);
            QVERIFY(dock_->chart().svg({400, 240}).contains(each.accent.name().toLatin1()));
        }
    }
};

}  // namespace

VITRINE_UI_TEST(StudyDockTest)
#include "study_dock_test.moc"
