#include "tests/ui/study/small_studies.h"
#include "tests/ui/ui_main.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/museum/museum.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/measure/clock.h"
#include "tests/ui/open_museum.h"
#include "ui/charts/charts_dock.h"
#include "ui/export/picture_export.h"
#include "ui/kit/message_strip.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/value_slider.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/preset_list.h"
#include "ui/print/print_dialog.h"
#include "ui/report/frame_report_dock.h"
#include "ui/report/frame_report_view.h"
#include "ui/study/study_dock.h"
#include "ui/viewport/pixel_inspector.h"
#include "ui/viewport/viewport.h"
#include "ui/window/file_opener.h"
#include "ui/window/main_window.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QDockWidget>
#include <QEventLoop>
#include <QListWidget>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

using namespace vitrine;
using namespace vitrine::ui;

/// The window over the real museum with the real renderer.
class MuseumWindowTest : public vitrine::test::OpenMuseum {
    Q_OBJECT

    std::size_t exhibit_ = 0;

    void openWindow()
    {
        makeWindow({.samples = 2});
        showWindow({1000, 560});  // Small enough for a software renderer.
        QTRY_VERIFY(window_->viewport().pictures().shown().pictures() > 0);
    }
    void settle() { QTRY_VERIFY(window_->viewport().pictures().schedule().still()); }
    [[nodiscard]] QImage picture()
    {
        settle();
        return window_->viewport().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    }
    /// Returns the picture once the viewport has its final size: docks appear and disappear over several turns of the
    /// event loop.
    [[nodiscard]] QImage pictureAtRest()
    {
        QImage last = picture();
        for (int equal = 0; equal < 3;) {
            QTest::qWait(50);
            QImage now = picture();
            equal = now.size() == last.size() ? equal + 1 : 0;
            last = std::move(now);
        }
        return last;
    }
    /// Returns the mean difference per channel, 0 to 255.
    [[nodiscard]] static double difference(const QImage& a, const QImage& b)
    {
        if (a.size() != b.size()) return 255;
        double sum = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) {
                const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
                sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
            }
        return sum / (3.0 * a.width() * a.height());
    }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[exhibit_]; }
    void dragMorph(int pixels)
    {
        auto* slider = window_->panel().row("morph")->findChild<ValueSlider*>();
        const QPoint from(12, slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        for (int x = 0; x <= pixels; x += 4) QTest::mouseMove(slider, from + QPoint(x, 0));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(pixels, 0));
    }

    void setPrint(PrintDialog& dialog, const char* row, double value)
    {
        ParameterValues values = dialog.values();
        values.setParameter(*values.table().find(row), value);
        dialog.setValues(values);
    }

private slots:
    void initTestCase()
    {
        prepare();
        try {
            museum_ = std::make_unique<Museum>(allExhibits());
        } catch (const std::exception& failure) {
            QFAIL(failure.what());
        }
        exhibit_ = museum_->find("sdf_morph").value();
    }
    void init()
    {
        makeHome();
        if (QTest::currentTestFunction() != QByteArray("longLabelsAreReadWholeInAWindowOfTheFirstSize")) openWindow();
    }
    void cleanup() { closeWindow(); }

    void longLabelsAreReadWholeInAWindowOfTheFirstSize()
    {
        makeWindow({});
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), vitrine::test::patience));
        QStringList cut;
        int read = 0;
        for (std::size_t i = 0; i < museum_->subjects().size(); ++i) {
            window_->choose(i);
            for (const ParameterInfo& info : window_->panel().values().table().rows())
                window_->panel().reveal(info.name);
            QTest::qWait(20);
            for (ParameterRow* row : window_->panel().findChildren<ParameterRow*>()) {
                const auto* label = row->findChild<RowLabel*>();
                if (!row->isVisible() || row->idle()) continue;  // An idle row has a mark beside its label.
                ++read;
                if (label->fontMetrics().horizontalAdvance(label->text()) > label->width()) cut << label->text();
            }
        }
        QVERIFY(read > 200);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(", ")));
        QVERIFY2(window_->viewport().width() * 10 > window_->width() * 4, "the picture keeps its room");
    }

    void longAPrintOfWhatIsShownIsRenderedAndCancelLeavesNothing()
    {
        window_->dialogs().openPrint();
        window_->dialogs().openPrint();
        QCOMPARE(window_->findChildren<PrintDialog*>().size(), 1);
        auto* dialog = window_->findChild<PrintDialog*>();
        for (const auto& [row, value] : std::initializer_list<std::pair<const char*, double>>{{"views", 2},
                                                                                              {"viewWidth", 96},
                                                                                              {"samples", 2},
                                                                                              {"width", 0.03},
                                                                                              {"height", 0.02},
                                                                                              {"dotsPerInch", 300}})
            setPrint(*dialog, row, value);
        const QDir home(home_->path());
        dialog->setPath(home.filePath("print.png"));
        QTRY_VERIFY(dialog->settled());
        dialog->startExport();
        QVERIFY(dialog->exporting());
        dialog->stopExport();
        QVERIFY(!dialog->exporting());
        QVERIFY(!QFile::exists(home.filePath("print.png")));
        dialog->startExport();
        QTRY_VERIFY(!dialog->exporting());
        const QImage print(home.filePath("print.png"));
        QCOMPARE(print.width(), 354);
        QFile json(home.filePath("print.png.json"));
        QVERIFY(json.open(QIODevice::ReadOnly));
        QVERIFY(json.readAll().contains("\"scene\""));  // The rendered scene state.
        // The hall has many colors, and a blank picture has not.
        QSet<QRgb> colors;
        for (int y = 0; y < print.height(); ++y)
            for (int x = 0; x < print.width(); ++x) colors << print.pixel(x, y);
        QVERIFY2(colors.size() > 500, qPrintable(QString::number(colors.size())));
        dialog->close();
        QTRY_VERIFY(!window_->findChild<PrintDialog*>());
    }

    void aSliderChangesThePictureUndoRestoresItAndAPresetBringsItBackInTheNextSession()
    {
        window_->visit(exhibit_);
        const QImage before = picture();
        dragMorph(10);
        const ParameterValues changed = values();
        const QImage after = picture();
        // The object fills a large part of the picture, so another shape changes it by more than rounding.
        QVERIFY2(difference(before, after) > 1, qPrintable(QString::number(difference(before, after))));
        window_->history().stack().undo();
        // Equal inputs give equal pictures; the mean of two samples has half floats.
        QVERIFY2(difference(before, picture()) < 0.5, qPrintable(QString::number(difference(before, picture()))));
        window_->history().stack().redo();
        window_->presetController().saveUnder("Half melted");
        window_->history().stack().undo();
        closeWindow();

        openWindow();
        auto* list = window_->findChild<PresetList*>()->findChild<QListWidget*>();
        const auto items = list->findItems("Half melted", Qt::MatchExactly);
        QCOMPARE(items.size(), 1);
        window_->presetController().load(items.first()->data(Qt::UserRole).toString());
        QVERIFY(values() == changed);
        QVERIFY2(difference(after, picture()) < 0.5, qPrintable(QString::number(difference(after, picture()))));
    }

    void longAPictureCarriesTheLookAndBringsItBackWhenDropped()
    {
        window_->visit(exhibit_);
        settle();
        dragMorph(60);
        const SceneState shown = window_->history().sceneState();
        ExportRequest exportRequest;
        exportRequest.path = home_->filePath("picture.png").toStdString();
        exportRequest.size = {160, 90};
        exportRequest.samples = 2;
        settle();
        const long long drawn = window_->viewport().pictures().shown().pictures();
        auto* work = new PictureExport(*window_, exportRequest, window_.get());
        QSignalSpy finished(work, &PictureExport::finished), failed(work, &PictureExport::failed);
        work->start();
        QTRY_VERIFY(finished.count() + failed.count() == 1);
        QVERIFY2(failed.isEmpty(), failed.isEmpty() ? "" : qPrintable(failed[0][0].toString()));
        QCOMPARE(window_->viewport().pictures().shown().pictures(),
                 drawn);  // The viewport and its picture are left alone.
        QVERIFY(render::embeddedPreset(exportRequest.path).has_value());
        window_->history().stack().undo();
        window_->files().open(QString::fromStdString(exportRequest.path.string()));
        QVERIFY(window_->history().sceneState() == shown);
    }

    void longTenSecondsOfIdlingDrawNothingAndUseNoProcessor()
    {
        window_->visit(exhibit_);
        settle();
        QTest::qWait(1000);  // For the status line and other work after the last picture.
        const long long drawn = window_->viewport().pictures().shown().pictures();
        // qWait wakes up every 10 ms, which costs half a percent.
        const double cpu = render::processCpuSeconds();
        QEventLoop idle;
        QTimer::singleShot(10000, &idle, &QEventLoop::quit);
        idle.exec();
        QCOMPARE(window_->viewport().pictures().shown().pictures(), drawn);
        const double share = (render::processCpuSeconds() - cpu) / 10;
        QVERIFY2(share < 0.005, qPrintable(QStringLiteral("%1 % of a processor").arg(100 * share)));
    }

    void longTheFrameReportsSwitchRunsEverythingAndChangesNoPixel()
    {
        // All effects of all exhibits are drawn.
        vitrine::test::drawCheaply(*window_, {.scale = 0.25});
        window_->visit(exhibit_);
        window_->findChild<QDockWidget*>("frame-report")->show();
        const QImage before = pictureAtRest();
        auto* frameReport = window_->findChild<FrameReportDock*>();
        frameReport->runEverything().setChecked(true);
        settle();
        QCOMPARE(difference(before, picture()), 0.0);
        QVERIFY(frameReport->view().costs().of("sdf_morph/march") >= 0);
        frameReport->runEverything().setChecked(false);
        settle();
        QTRY_VERIFY(frameReport->reasonText().startsWith("Done ("));
    }

    void longAStudyInTheWindowLeavesThePictureAloneUntilAPointIsClicked()
    {
        vitrine::test::drawCheaply(*window_, {.samples = 2, .scale = 1});  // The study draws at this scale, too.
        window_->visit(exhibit_);
        const QImage before = pictureAtRest();
        StudyDock& study = window_->docks().study();
        vitrine::test::setEffort(study, {64, 36}, 2);
        window_->findChild<QDockWidget*>("study")->show();
        QSignalSpy finished(&study, &StudyDock::finished);
        const auto row = window_->museum().subject(exhibit_).parameters().find("hitTolerance");
        emit window_->panel().accuracyAsked(*row);
        QVERIFY(study.running());
        QTRY_VERIFY(finished.count() == 1);
        QVERIFY(study.result().points.size() >= 5);
        QCOMPARE(study.result().costName, std::string("evaluations"));
        QCOMPARE(window_->history().stack().count(), 0);
        window_->findChild<QDockWidget*>("study")->hide();
        const QImage after = pictureAtRest();
        QCOMPARE(after.size(), before.size());
        const double change = difference(before, after);
        QVERIFY2(change < 0.5, qPrintable(QString::number(change)));
    }

    void longChartsOfAnExhibitFollowItsValuesAndLeaveThePictureAlone()
    {
        std::size_t charted = 0;
        for (std::size_t i = 0; i < museum_->subjects().size(); ++i)
            if (capability<HasCharts>(museum_->subject(i)) != nullptr) charted = i;
        QVERIFY(charted != 0);
        auto* charts = window_->findChild<ChartsDock*>();
        window_->visit(charted);
        window_->docks().showCharts();
        QTRY_VERIFY(!charts->charts().empty());
        QCOMPARE(charts->plots().size(), charts->charts().size());
        const ChartCurve before = charts->charts()[0].curves[0];
        const std::size_t seed = *museum_->subject(charted).parameters().find("seed");
        window_->history().set(charted, seed, 77.0, newGesture());
        QTRY_VERIFY(charts->charts()[0].curves[0].y != before.y);
        const QImage shown = pictureAtRest();
        QTest::qWait(300);
        QCOMPARE(difference(shown, picture()), 0.0);
        window_->visit(exhibit_);
        QTRY_VERIFY(charts->charts().empty());
        QVERIFY(!charts->note().isEmpty());
    }

    void longTheKeyIShowsWhatIsAtAPixelWhileItIsHeld()
    {
        Viewport& viewport = window_->viewport();
        (void)pictureAtRest();
        viewport.setFocus();
        const auto* inspector = window_->findChild<PixelInspector*>();
        QVERIFY(inspector->text().isEmpty());
        QTest::keyPress(&viewport, Qt::Key_I);
        QTRY_VERIFY2_WITH_TIMEOUT(inspector->text().contains("Distance"), qPrintable(inspector->text()),
                                  vitrine::test::patience);
        // The point lies on the ray through the middle of the picture, which is the pixel without a pointer.
        const QRegularExpression form(R"(Position  (\S+)  (\S+)  (\S+) m\n(?s:.*)Distance  (\S+) m)");
        const QRegularExpressionMatch found = form.match(inspector->text());
        QVERIFY2(found.hasMatch(), qPrintable(inspector->text()));
        const glm::dvec3 point(found.captured(1).toDouble(), found.captured(2).toDouble(),
                               found.captured(3).toDouble());
        const double distance = found.captured(4).toDouble();
        const render::View view = viewport.scene().view();
        QVERIFY(distance > 0.2);
        const QPointF middle = viewport.rect().center();
        const glm::dvec2 ndc(2 * middle.x() / viewport.width() - 1, 1 - 2 * middle.y() / viewport.height());
        QVERIFY(glm::length(point - view.eye - glm::normalize(view.direction(ndc)) * distance) < 0.003);
        // As some X servers repeat a key that is held.
        for (int k = 0; k < 20; ++k) {
            QTest::keyRelease(&viewport, Qt::Key_I);
            QTest::keyPress(&viewport, Qt::Key_I);
            QTest::qWait(20);
            QVERIFY(!inspector->text().isEmpty());
        }
        QTest::keyRelease(&viewport, Qt::Key_I);
        QTRY_VERIFY(inspector->text().isEmpty());
    }

    void longACanceledExportLeavesNoFile()
    {
        ExportRequest exportRequest;
        exportRequest.path = home_->filePath("never.png").toStdString();
        exportRequest.size = {640, 360};
        exportRequest.samples = 64;
        auto* work = new PictureExport(*window_, exportRequest, window_.get());
        QSignalSpy progressed(work, &PictureExport::progressed);
        work->start();
        QTRY_VERIFY(progressed.count() >= 2);
        work->cancel();
        QTest::qWait(200);
        QCOMPARE(QDir(home_->path()).entryList({"*never*"}, QDir::Files | QDir::Hidden), QStringList());
    }
};

VITRINE_UI_TEST(MuseumWindowTest)

#include "museum_window_test.moc"
