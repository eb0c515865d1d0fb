// Picture of B in the real window: when it is drawn, its camera, its use, and its cost.

#include "tests/ui/compare/open_comparison.h"
#include "tests/ui/ui_main.h"

#include "render/failure.h"
#include "render/image/image_io.h"
#include "ui/compare/compare_bar.h"
#include "ui/report/frame_report_dock.h"
#include "ui/report/frame_report_view.h"
#include "ui/window/window_docks.h"

#include <QDockWidget>
#include <QSet>
#include <QSignalSpy>

using namespace vitrine;
using namespace vitrine::ui;

class ComparePictureTest : public test::OpenComparison {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        mostSamples_ = asTheHallRequests;
        prepare();
    }
    void init() { start(); }
    void cleanup() { finish(); }

    void longBIsSeenByTheSameCameraAtTheSameMomentAndRefinedAtRest()
    {
        compare();
        dragInPicture(0.2, 0.3);
        rest();
        const FrameRequest a = gallery_->requests().back(), b = gallery_->otherRequests().back();
        QVERIFY(a.camera == b.camera);
        QCOMPARE(a.time, b.time);
        QCOMPARE(a.seed, b.seed);
        QVERIFY(a.raster.size == b.raster.size);
        QCOMPARE(a.sample, 15);
        QCOMPARE(b.sample, 15);
        QCOMPARE(b.samples, 16);
        QCOMPARE(gallery_->strangers, 0);
        const std::size_t drawn = gallery_->otherRequests().size();
        QTest::qWait(500);
        QCOMPARE(gallery_->otherRequests().size(), drawn);  // While idle neither A nor B is drawn.
        dragRoughness(40);
        rest();
        QVERIFY(roughness() != 0.8);
        QCOMPARE(gallery_->otherRequests().size(), drawn);  // An edit of A does not draw B.
    }

    void longAnEditOfAAfterARestDrawsNothingOfB()
    {
        compare();
        QTRY_VERIFY_WITH_TIMEOUT(view().scene().request().idle, test::patience);
        dragInPicture(0.2, 0.3);
        rest();
        QVERIFY2(gallery_->requests().back().idle, "a control: A was drawn as idle");
        QVERIFY(!gallery_->otherRequests().back().idle);
        const std::size_t drawn = gallery_->otherRequests().size();
        gallery_->unfinishedFrames = 2;
        const std::size_t before = gallery_->requests().size();
        setRoughness(0.6);
        rest();
        QVERIFY2(!gallery_->requests()[before].idle, "a control: A is drawn as changed");
        QCOMPARE(gallery_->unfinishedFrames, 0);
        QCOMPARE(gallery_->otherRequests().size(), drawn);
        QVERIFY(isB(0.6));
    }

    void longABThatCannotBeDrawnIsNotShownAsTheFormerOne()
    {
        for (QDockWidget* dock : window_->docks().all())
            if (dock->objectName() == "frame-report") dock->show();
        compare();
        QVERIFY2(isB(0.6), "a control: there is a former B");
        const QSignalSpy failed(&controller().picture(), &PictureB::failed);
        gallery_->otherThrown = std::make_exception_ptr(Failure(ErrorKind::check, "out of paint"));
        action("Hold the current settings as B")->trigger();
        QVERIFY(!controller().picture().upToDate());
        QTRY_VERIFY(!controller().picture().failure().isEmpty());
        QVERIFY(isA(0.3));
        QVERIFY(isA(0.6));
        QCOMPARE(failed.count(), 1);
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("out of paint"));
        QTRY_VERIFY(window_->docks().frameReport().sumsText().contains("B: cannot be drawn"));
        dragInPicture(0.2, 0.3);
        settle();
        QCOMPARE(failed.count(), 1);
        action("Hold the current settings as B")->trigger();
        QTRY_COMPARE(failed.count(), 2);  // A new B reports its failure again.
        settle();
        gallery_->otherThrown = nullptr;
        setRoughness(0.2);
        action("Hold the current settings as B")->trigger();
        rest();
        QVERIFY(controller().picture().upToDate() && controller().picture().failure().isEmpty());
        setRoughness(0.8);
        rest();
        QVERIFY(isA(0.3));
        QVERIFY(isB(0.6));
    }

    void longAFileThatBAloneNamesIsWatched()
    {
        const QString path = home_->filePath("sky.png");
        const auto write = [&](int width) {
            render::writePicture(path.toStdString(), render::Image(width, 4, 3, 0.5F), render::PictureFormat::png8);
        };
        write(4);
        window_->choose(1);
        const std::size_t row = gallery_->table().environment.row;
        window_->history().set(1, row, path.toStdString(), newGesture());
        settle();
        action("Hold the current settings as B")->trigger();
        window_->history().set(1, row, std::string(), newGesture());
        rest();
        // Control: without a change of files, nothing is drawn for longer than the interval of checks. On a busy
        // machine, a specialized program or a picture of another size may come first.
        std::size_t drawn = 0;
        for (int turn = 0; turn < 10 && drawn != gallery_->otherRequests().size(); ++turn) {
            drawn = gallery_->otherRequests().size();
            QTest::qWait(1200);
        }
        QCOMPARE(gallery_->otherRequests().size(), drawn);
        write(8);
        QTRY_VERIFY(gallery_->otherRequests().size() > drawn);
        QCOMPARE(controller().other().name(), QString("Snapshot of A"));
    }

    void longOfBNothingIsDrawnThatNothingShowsAndTheFrameReportSaysSo()
    {
        for (QDockWidget* dock : window_->docks().all())
            if (dock->objectName() == "frame-report") dock->show();
        compare();
        action("Wipe")->trigger();
        QTRY_COMPARE(gallery_->othersForgotten, 1);
        const std::size_t drawn = gallery_->otherRequests().size();
        setRoughness(0.6);
        rest();
        QCOMPARE(gallery_->otherRequests().size(), drawn);
        FrameReportDock& frameReport = window_->docks().frameReport();
        QTRY_VERIFY2(frameReport.sumsText().contains("B: not drawn"), qPrintable(frameReport.sumsText()));
        action("A/B flicker")->trigger();
        rest();
        QVERIFY2(gallery_->otherRequests().size() > drawn, "a control: a mode that needs B draws it");
        QTRY_VERIFY2(frameReport.sumsText().contains("B: 2 steps, 17.80 ms"), qPrintable(frameReport.sumsText()));
    }

    void longTheFrameReportShowsWhatBothCostAndWhatOnlyOneRuns()
    {
        for (QDockWidget* dock : window_->docks().all())
            if (dock->objectName() == "frame-report") dock->show();
        FrameReportView& frameReport = window_->docks().frameReport().view();
        settle();
        QVERIFY(frameReport.isColumnHidden(5));
        compare();
        const auto line = [&](const QString& step) {
            for (int i = 0; i < frameReport.topLevelItemCount(); ++i)
                if (frameReport.topLevelItem(i)->toolTip(0) == step) return frameReport.topLevelItem(i);
            return static_cast<QTreeWidgetItem*>(nullptr);
        };
        QTRY_VERIFY(line("fur/shells") && line("draws"));
        QVERIFY(!frameReport.isColumnHidden(5));
        QCOMPARE(line("hall/walls")->text(2), QString("12.25"));
        QCOMPARE(line("hall/walls")->text(5), QString("10.50"));
        QCOMPARE(line("sdf_morph/march")->text(5), QString("–"));
        QCOMPARE(line("fur/shells")->text(2), QString("–"));
        QCOMPARE(line("fur/shells")->text(5), QString("7.25"));
        QVERIFY(line("fur/shells")->text(4).startsWith("only B"));
        QCOMPARE(line("draws")->text(5), QString("2"));
        action("End the comparison")->trigger();
        QTRY_VERIFY(!line("fur/shells"));
        QVERIFY(frameReport.isColumnHidden(5));
    }

    void differencesAreMultipliedByTheSlider()
    {
        window_->resize(800, 480);  // FLIP of a large picture takes a while.
        compare();
        setRoughness(0.22);
        action("Signed difference")->trigger();
        rest();
        ValueSlider& gain = controller().bar().gain();
        QVERIFY(gain.isVisible());
        // B's red is 51 of 255 and A's is 56: half of the difference of the codes, times the gain, below the middle.
        for (const auto& [key, times] : {std::pair{Qt::Key_Home, 1}, {Qt::Key_PageUp, 0}, {Qt::Key_End, 64}}) {
            QTest::keyClick(&gain, key);
            if (times != 0) QCOMPARE(controller().overlay().gain(), times);
            const double expected = 127.5 + 0.5 * (51 - 56) * controller().overlay().gain();
            QTRY_VERIFY2(std::abs(shownAt(0.4).red() - std::max(expected, 0.0)) <= 1,
                         qPrintable(QString("%1: %2, not %3").arg(times).arg(shownAt(0.4).red()).arg(expected)));
            QVERIFY2(std::abs(shownAt(0.4).green() - 127.5) <= 1, "there the two are equal");
        }
        action("FLIP")->trigger();
        QTRY_VERIFY2(!controller().overlay().difference().isNull() && shownAt(0.4).red() > 60,
                     "a difference is bright");
        setRoughness(0.2);
        QTRY_VERIFY2(shownAt(0.4).red() < 10 && shownAt(0.4).green() < 10, "none is black");
    }

    void longDifferencesAreOfPicturesOfOneMoment()
    {
        window_->resize(800, 480);
        gallery_->greenIsTheClock = true;
        compare();
        action("Signed difference")->trigger();
        controller().overlay().setGain(64);
        rest();
        gallery_->exhibit().moves = true;
        view().scene().change();
        QSet<qint64> seen;
        const double first = view().pictures().shown().request().time;
        double farthest = 0;
        const auto look = [&] {
            const QImage& difference = controller().overlay().difference();
            if (difference.isNull()) return;
            seen.insert(difference.cacheKey());
            const QColor color = difference.pixelColor(difference.width() / 2, difference.height() / 2);
            farthest = std::max(farthest, std::abs(color.green() - 127.5));
        };
        const QMetaObject::Connection looks = connect(&view().pictures(), &ViewportPictures::drawn, this, look);
        QTRY_VERIFY(seen.size() >= 8);
        disconnect(looks);
        QVERIFY2(view().pictures().shown().request().time > first + 0.1, "a control: the clock ran, and green with it");
        QVERIFY2(farthest <= 1, qPrintable(QString::number(farthest)));
        gallery_->exhibit().moves = false;
    }
};

VITRINE_UI_TEST(ComparePictureTest)

#include "compare_picture_test.moc"
