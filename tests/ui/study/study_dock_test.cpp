// Study dock over an exhibit with a known law: what it shows and applies. No GL.

#include "tests/ui/point_at.h"
#include "tests/ui/study/known_gallery.h"
#include "tests/ui/study/small_studies.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/theme.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/study/both_settings_button.h"
#include "ui/study/comparison_dialog.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_dock.h"
#include "ui/study/study_pictures.h"
#include "ui/study/study_view.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
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
        QVERIFY(finished.wait(test::patience));
    }
    void clickMeasure()
    {
        for (QPushButton* each : dock_->findChildren<QPushButton*>())
            if (each->accessibleName() == QLatin1String("Measure, or stop measuring")) each->click();
    }
    void measureAsSet()
    {
        clickMeasure();
        finish();
    }
    /// Slows the next studies down, so that the test sees them under way.
    void measureSlowly() { gallery_->frame = std::chrono::milliseconds(5); }
    void clickOn(std::size_t point)
    {
        dock_->chart().replot();
        QTest::mouseClick(&dock_->chart(), Qt::LeftButton, {}, dock_->chart().placeOf(point).toPoint());
    }

private slots:
    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        qputenv("XDG_STATE_HOME", home_->path().toLocal8Bit());
        gallery_ = std::make_unique<test::KnownGallery>();
        history_ = std::make_unique<History>(gallery_->museum.initialSceneState());
        thread_ = std::make_unique<RenderThread>(*gallery_);
        dock_ =
            std::make_unique<StudyDock>(gallery_->museum, *gallery_, *history_, *thread_, test::storeIn(home_->path()));
        test::setEffort(*dock_, {16, 9}, 3);
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
        measureSlowly();
        dock_->ask(1, row("steps"));
        QVERIFY(dock_->running());
        bool someBeforeAll = false;
        while (dock_->running()) {
            QTest::qWait(1);
            const auto& points = dock_->result().points;
            const auto drawn =
                std::count_if(points.begin(), points.end(), [](const study::StudyPoint& p) { return p.cost > 0; });
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
        QTRY_VERIFY(dock_->chart().points()[other].present);
        history_->stack().undo();
        QCOMPARE(valueNow("steps"), 8.0);
        QTRY_VERIFY(!dock_->chart().points()[other].present);
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
        QTest::keyClick(&chart, Qt::Key_Left);  // There is no point below it.
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
        measureSlowly();
        const SceneState before = history_->sceneState();
        dock_->ask(1, row("rays"));
        for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
        QVERIFY(dock_->running());
        dock_->stop();
        QVERIFY(!dock_->running());
        QVERIFY(history_->sceneState() == before);
        QCOMPARE(history_->stack().count(), 0);
    }

    void longTheCheapestWithinAnErrorIsAppliedAsOneStep()
    {
        auto* field = dock_->findChildren<QLineEdit*>().front();
        field->setText(QStringLiteral("0.05"));
        emit field->returnPressed();
        finish();
        QVERIFY(dock_->result().choice);
        QVERIFY(dock_->result().choice->holds);
        QCOMPARE(history_->stack().count(), 1);
        const study::StudyPoint& chosen = dock_->result().points[dock_->result().choice->point];
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

    void theSettingsChooseMetricViewsSizeAndValues()
    {
        const study::StudyTable& t = study::studyTable();
        const auto& metrics = study::studyMetrics();
        ParameterValues values = dock_->setup().values();
        values.set(t.varied, std::string("steps"));
        values.set(t.values, std::string("2,32"));
        values.set(t.metric, static_cast<int>(std::find(metrics.begin(), metrics.end(), "max") - metrics.begin()));
        values.set(t.views, 2);
        values.set(t.width, 24);
        dock_->setup().change(QString(), values);
        measureAsSet();
        const study::StudyResult& result = dock_->result();
        QCOMPARE(result.views.size(), std::size_t{2});
        QCOMPARE(result.references.front().width, 24);
        QCOMPARE(result.points.size(), std::size_t{2});
        for (const study::StudyPoint& point : result.points) {
            double largest = 0;
            for (const study::StudyShot& shot : point.shots)
                largest = std::max(largest, shot.errors.at(render::Metric::max));
            QCOMPARE(point.error, largest);
        }
    }

    void theRowsOfTheJobAreThePanelsAndTwoParametersAreASurface()
    {
        for (const ParameterInfo& parameter : study::studyTable().rows())
            QVERIFY(dock_->settings().row(parameter.name));
        auto* box = dock_->settings().row("parameters")->findChild<QComboBox*>();
        QCOMPARE(box->count(), 4);
        box->setEditText(QStringLiteral("method; shortcut"));
        emit box->lineEdit()->editingFinished();
        QCOMPARE(dock_->setup().values()[study::studyTable().varied], std::string("method\nshortcut"));
        QCOMPARE(box->currentText(), QString("method; shortcut"));
        QCOMPARE(dock_->findChildren<QComboBox*>().front()->currentIndex(), -1);
        measureAsSet();
        QCOMPARE(dock_->result().points.size(), std::size_t{6});
    }

    void theSettingsAreRememberedButNotWhatIsMeasured()
    {
        const study::StudyTable& t = study::studyTable();
        ParameterValues values = dock_->setup().values();
        values.set(t.views, 5);
        values.set(t.varied, std::string("rays"));
        dock_->setup().change(QString(), values);
        dock_.reset();
        dock_ =
            std::make_unique<StudyDock>(gallery_->museum, *gallery_, *history_, *thread_, test::storeIn(home_->path()));
        dock_->setSubject(1);
        QCOMPARE(dock_->setup().values()[t.views], 5);
        QCOMPARE(dock_->setup().values()[t.varied], std::string("steps"));
    }

    void whatCannotBeStudiedIsSaid()
    {
        ParameterValues values = dock_->setup().values();
        values.set(study::studyTable().values, std::string("2,soup"));
        dock_->setup().change(QString(), values);
        clickMeasure();
        QVERIFY(!dock_->running());
        const auto labels = dock_->view().findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](QLabel* each) { return each->text().contains("soup"); }));
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
        QApplication::sendEvent(&chart, &leave);  // ... and out of the chart.
        QCOMPARE(pictures->grab().toImage(), hovered);
        QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.rect().topRight() + QPoint(-3, 3));
        QVERIFY(pictures->grab().toImage() != hovered);  // A click beside all points shows the present setting again.
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
                if (!label || label->text().startsWith(QStringLiteral("exact"))) continue;
                const QRectF place(label->topLeft->pixelPosition(), label->bottomRight->pixelPosition());
                for (const QRectF& other : places)
                    QVERIFY2(!place.adjusted(1, 1, -1, -1).intersects(other), qPrintable(label->text()));
                places.push_back(place);
            }
            QVERIFY(!places.empty());
        }
    }

    void longTheAxisIsDecidedBeforeTheFirstPointAndOnlyTheUserChangesIt()
    {
        measureSlowly();
        StudyChart& chart = dock_->chart();
        auto* cost = dock_->view().findChild<QComboBox*>("cost");
        QVERIFY(cost != nullptr);
        dock_->ask(1, row("steps"));
        QStringList titles;
        while (dock_->running()) {
            QTest::qWait(1);
            if (dock_->result().points.empty()) continue;
            if (titles.isEmpty() || titles.back() != chart.costTitle()) titles << chart.costTitle();
            for (std::size_t i = 0; i < chart.points().size(); ++i) {
                // At the position of its time, or not shown yet.
                const study::StudyPoint& point = dock_->result().points[i];
                QCOMPARE(chart.points()[i].cost, point.time ? point.time->median : 0.0);
            }
        }
        QCOMPARE(titles, QStringList{"milliseconds of a picture"});
        for (const ChartPoint& point : chart.points())
            QVERIFY(point.costLow <= point.cost && point.cost <= point.costHigh);

        cost->setCurrentIndex(1);
        emit cost->activated(1);
        QCOMPARE(chart.costTitle(), QString("work in all views"));
        for (std::size_t i = 0; i < chart.points().size(); ++i)
            QCOMPARE(chart.points()[i].cost, static_cast<double>(dock_->result().points[i].counters.at("work")));
        // The choice is kept for the next study.
        dock_->ask(1, row("rays"));
        finish();
        QCOMPARE(chart.costTitle(), QString("work in all views"));
        dock_->view().chooseCostAxis(study::CostAxis::time);
        QCOMPARE(chart.costTitle(), QString("milliseconds of a picture"));
    }

    void aClockThatIsNotTrustedMakesTheAxisWork()
    {
        measureSlowly();
        gallery_->clockTrusted = false;
        dock_->ask(1, row("steps"));
        QStringList titles;
        while (dock_->running()) {
            QTest::qWait(1);
            if (!dock_->result().points.empty() && (titles.isEmpty() || titles.back() != dock_->chart().costTitle()))
                titles << dock_->chart().costTitle();
        }
        titles.removeAll(QString("counted work"));  // Title of the empty chart, before all settings are drawn.
        QCOMPARE(titles, QStringList{"work in all views"});
        dock_->view().chooseCostAxis(study::CostAxis::time);
        QVERIFY(dock_->chart().costTitle().contains("not trusted"));
    }

    void whatIsNotMeasuredYetHasNeitherNumbersNorAPicture()
    {
        const auto* pictures = dock_->findChild<StudyPictures*>();
        QVERIFY(!pictures->isVisible());
        study::StudyRequest request;
        request.sceneState = history_->sceneState();
        request.axes = {*study::studyAxis(request.sceneState, 1, row("steps"), 8)};
        request.size = {16, 9};
        request.runs = 3;
        test::KnownBackend backend;
        study::Study study(gallery_->museum, backend, request);
        ui::StudyView& view = dock_->view();
        const auto caption = [&view] {
            for (const QLabel* label : view.findChildren<QLabel*>())
                if (label->isVisible() && label->text().startsWith("Steps")) return label->text();
            return QString();
        };
        while (!isDrawn(study.result().points.front())) QVERIFY(study.step());
        view.showMeasured(request, study.result(), render::Json::object(), true);
        // The present setting is measured later.
        QCOMPARE(caption(), QString("Steps 8 is not measured yet."));
        QVERIFY(!pictures->isVisible());
        QVERIFY(!view.chart().xAxis->visible());
        // The setting that is the reference is drawn with it, before all others.
        const std::vector<study::StudyPoint>& points = study.result().points;
        const auto drawn = std::count_if(points.begin(), points.end(), study::isDrawn);
        QVERIFY(drawn > 0 && drawn < static_cast<std::ptrdiff_t>(points.size()));
        QVERIFY2(view.chart().emptyText().startsWith(QString("%1 of ").arg(drawn)),
                 qPrintable(view.chart().emptyText()));
        emit view.chart().hovered(0);
        QVERIFY2(caption().startsWith("Steps 1: error ") && !caption().contains(" ms"), qPrintable(caption()));
        QVERIFY2(!caption().contains("everything exact"), qPrintable(caption()));
        QVERIFY(pictures->isVisible());
        emit view.chart().hovered(-1);
        QVERIFY(!pictures->isVisible());
        while (study.step()) {
        }
        view.showMeasured(request, study.result(), render::Json::object(), false);
        QVERIFY2(caption().startsWith("Steps 8: error ") && caption().contains(" ms") && caption().contains(" work") &&
                     caption().contains("against everything exact"),
                 qPrintable(caption()));
        QVERIFY(pictures->isVisible());
        QVERIFY(view.chart().xAxis->visible());
    }

    void equalPicturesHaveASentenceInPlaceOfABlackHeatMap()
    {
        auto* pictures = dock_->findChild<StudyPictures*>();
        pictures->resize(520, 200);
        QImage gray(64, 36, QImage::Format_RGB888);
        gray.fill(Qt::gray);
        QImage black(64, 36, QImage::Format_RGB888);
        black.fill(Qt::black);
        pictures->show(gray, gray, {}, QString());
        const QImage seen = pictures->grab().toImage();
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x)
                QVERIFY(seen.pixelColor(x, y) != Qt::black || theme().text == QColor(Qt::black));
    }

    void theSecondLineIsTheErrorAgainstEverythingExact()
    {
        dock_->ask(1, row("steps"));
        finish();
        const StudyChart& chart = dock_->chart();
        QVERIFY(chart.legend->visible());
        for (std::size_t i = 0; i < chart.points().size(); ++i) {
            QVERIFY(chart.points()[i].modelError);
            QCOMPARE(*chart.points()[i].modelError, *dock_->result().points[i].modelError);
            QVERIFY(*chart.points()[i].modelError > chart.points()[i].error);
        }
        bool found = false;
        for (int i = 0; i < chart.graphCount(); ++i) {
            const QCPGraph& graph = *chart.graph(i);
            if (graph.name() != QString("against everything exact")) continue;
            found = true;
            QCOMPARE(static_cast<std::size_t>(graph.dataCount()),
                     std::size_t(std::count_if(chart.points().begin(), chart.points().end(),
                                               [](const ChartPoint& p) { return p.onFront; })));
        }
        QVERIFY(found);
    }

    void longTheFormerResultStaysUntilTheNextOneHasAPoint()
    {
        dock_->ask(1, row("steps"));
        finish();
        measureSlowly();
        const std::size_t before = dock_->result().points.size();
        const QString words = dock_->chart().points().front().text;
        dock_->ask(1, row("rays"));
        QVERIFY(dock_->running());
        QCOMPARE(dock_->result().points.size(), before);
        QCOMPARE(dock_->chart().points().front().text, words);
        dock_->stop();  // Before its first point.
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
        StudyPictures alone(nullptr);
        StudyPictures* const pictures = &alone;
        pictures->resize(520, 200);
        QImage gray(64, 36, QImage::Format_RGB888);
        gray.fill(Qt::gray);
        QImage other = gray;
        other.fill(Qt::darkGray);
        pictures->show(gray, other, gray, QString());
        const QImage without = pictures->grab().toImage();
        pictures->show(gray, other, gray, QStringLiteral("0.031"));
        QVERIFY(pictures->grab().toImage() != without);
        QSet<QRgb> colors;
        const QImage seen = pictures->grab().toImage();
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) colors << seen.pixel(x, y);
        QVERIFY(colors.size() > 60);  // A color ramp, and not a few tones of gray and text.
    }

    void theChartIsOfTheThemeInUseAndItsFilesAreForPaper()
    {
        dock_->ask(1, row("method"));
        finish();
        StudyChart& chart = dock_->chart();
        chart.setFocusPolicy(Qt::NoFocus);
        for (const Theme& each : {lightTheme(), darkTheme()}) {
            applyTheme(*qApp, each);
            chart.applyColors();
            QCOMPARE(chart.grab().toImage().pixelColor(2, 2), each.base);
            const QRect before = chart.axisRect()->rect();
            QCOMPARE(chart.picture({400, 240}, 1).pixelColor(2, 2), QColor(Qt::white));
            QVERIFY(chart.svg({400, 240}).contains(paperTheme().accent.name().toLatin1()));
            QCOMPARE(chart.axisRect()->rect(), before);
            QCOMPARE(chart.grab().toImage().pixelColor(2, 2), each.base);
        }
    }

    void theChartNamesWhatWasMeasuredAndUnderWhichConditions()
    {
        dock_->ask(1, row("steps"));
        finish();
        const QByteArray svg = dock_->exported("svg");
        QVERIFY2(svg.contains(
                     QString("%1: Steps").arg(QString::fromUtf8(gallery_->museum.subject(1).title().data())).toUtf8()),
                 svg.constData());
        QVERIFY(svg.contains("16 × 9"));
        const QByteArray pdf = dock_->exported("pdf");
        QVERIFY(pdf.startsWith("%PDF-"));
        // The page is as large as the chart: 960 x 600 pixels of 1/96 inch are 720 x 450 points.
        QVERIFY2(pdf.contains("/MediaBox [0 0 720.000000 450.000000]"),
                 pdf.mid(pdf.indexOf("/MediaBox"), 60).constData());
    }

    void longBothSettingsAreMeasuredIntoOneChart()
    {
        SettingsB other(*history_);
        dock_->offerBoth(other);
        auto* button = dock_->findChild<BothSettingsButton*>();
        QVERIFY(button && !button->isVisibleTo(dock_.get()));
        SceneState b = history_->sceneState();
        b.values[1].setParameter(row("rays"), 64.0);
        other.set(b, QStringLiteral("Many rays"));
        QVERIFY(button->isVisibleTo(dock_.get()));
        dock_->ask(1, row("steps"));
        finish();
        button->click();
        QVERIFY(dock_->running());
        finish();
        finish();
        auto* dialog = dock_->window()->findChild<ComparisonDialog*>();
        QVERIFY(dialog != nullptr);
        const QByteArray csv = dialog->exported(QStringLiteral("csv"));
        QVERIFY2(csv.contains("B: Many rays"), csv.constData());
        dialog->close();
        // A study that is stopped is followed by none.
        gallery_->frame = std::chrono::milliseconds(5);
        button->click();
        dock_->stop();
        gallery_->frame = {};
        dock_->ask(1, row("steps"));
        finish();
        QTest::qWait(50);
        QVERIFY(!dock_->running());
    }
};

}  // namespace

VITRINE_UI_TEST(StudyDockTest)
#include "study_dock_test.moc"
