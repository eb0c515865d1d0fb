#include "tests/ui/ui_main.h"

#include "ui/viewport/draw_schedule.h"
#include "ui/viewport/moving_region.h"

#include <QTest>

#include <cmath>

using namespace vitrine::ui;

namespace {

/// Draws until nothing is left, like a machine that needs `full` seconds for a picture at full resolution, of which
/// `fixed` do not depend on the resolution. Returns the number of pictures.
int drawAll(DrawSchedule& schedule, double& now, double full, double fixed = 0)
{
    int drawn = 0;
    while (std::isfinite(schedule.wait(now)) && drawn < 100) {
        now += schedule.wait(now) + 1e-6;
        const auto order = schedule.next(now);
        if (!order) continue;
        const double seconds = fixed + (full - fixed) * order->scale * order->scale;
        now += seconds;
        schedule.drawn(*order, seconds);
        ++drawn;
    }
    return drawn;
}

/// Returns a schedule whose opening is over.
DrawSchedule opened()
{
    DrawSchedule schedule;
    schedule.drawn(schedule.next(0).value(), 1);
    schedule.changed(0);
    return schedule;
}

}  // namespace

class DrawScheduleTest : public QObject {
    Q_OBJECT

private slots:
    void theVeryFirstPictureIsCoarseAndItsTimeSaysNothing()
    {
        DrawSchedule schedule;
        schedule.changed(0);
        const DrawOrder order = schedule.next(0).value();
        QCOMPARE(order, (DrawOrder{Opening::scale, 0, 1, false, 0}));
        schedule.begun(order);
        schedule.drawn(order, 60);  // As long as on the first start, when all programs are compiled.
        QCOMPARE(schedule.scaleWhileMoving(), 1.0);
        QVERIFY(!schedule.still());
        double now = 1;
        QCOMPARE(drawAll(schedule, now, 0.01), 16);
        schedule.changed(now);
        QCOMPARE(schedule.next(now).value(), (DrawOrder{1, 0, 16}));
    }

    void anOpeningMuseumShowsTheHallAndThenOneExhibitAfterTheOtherUntilThatIsQuick()
    {
        DrawSchedule slow;
        slow.setExhibits(3);
        for (int exhibits = 0; exhibits <= 3; ++exhibits) {
            const DrawOrder order = slow.next(0).value();
            QCOMPARE(order, (DrawOrder{Opening::scale, 0, 1, false, exhibits}));
            slow.drawn(order, 2);  // Its programs are compiled.
        }
        QCOMPARE(slow.next(0).value(), (DrawOrder{1, 0, 16}));

        DrawSchedule quick;
        quick.setExhibits(9);
        quick.drawn(quick.next(0).value(), 0.1);  // Its time has no meaning, because no exhibit was drawn.
        QCOMPARE(quick.next(0).value().mostExhibits, 1);
        quick.drawn(quick.next(0).value(), 0.1);
        QCOMPARE(quick.next(0).value(), (DrawOrder{1, 0, 16}));
        QCOMPARE(quick.scaleWhileMoving(), 1.0);

        DrawSchedule broken;
        broken.setExhibits(9);
        broken.drawn({1, 15, 16}, 0);  // Sent by the viewport after a failure.
        QVERIFY(!broken.next(100));    // Nothing is drawn again until something changes.
        broken.changed(100);
        QCOMPARE(broken.next(100).value().mostExhibits, 0);
    }

    void aStillPictureIsRefinedSixteenTimesAndThenLeftAlone()
    {
        DrawSchedule schedule = opened();
        double now = 0;
        schedule.changed(now);
        QCOMPARE(drawAll(schedule, now, 0.01), 16);
        QVERIFY(schedule.still());
        QVERIFY(!schedule.next(now + 1000));
        QVERIFY(std::isinf(schedule.wait(now)));
        QCOMPARE(schedule.reason(), QStringLiteral("Done (16 samples)"));
    }

    void whatChangesWhileAPictureIsDrawnIsDrawnAfterIt()
    {
        DrawSchedule schedule = opened();
        double now = 0;
        drawAll(schedule, now, 0.01);
        schedule.changed(now);
        const auto order = schedule.next(now);
        schedule.begun(*order);
        schedule.changed(now + 0.005);
        schedule.drawn(*order, 0.01);
        QVERIFY(!schedule.current());
        QCOMPARE(schedule.next(now + 0.01)->sample, 0);
    }

    void refinementThatIsOutOfDateIsGivenUpAndAQuickPictureNever()
    {
        DrawSchedule schedule = opened();
        schedule.changed(0);
        DrawOrder order = schedule.next(0).value();
        schedule.begun(order);
        schedule.changed(0.001);
        QVERIFY(!schedule.betterGivenUp());  // The quickest picture is shown during a long motion.
        schedule.drawn(order, 0.01);
        order = schedule.next(0.02).value();
        schedule.begun(order);
        schedule.drawn(order, 0.01);
        order = schedule.next(1).value();
        QCOMPARE(order.sample, 1);
        schedule.begun(order);
        QVERIFY(!schedule.betterGivenUp());
        schedule.changed(1.001);
        QVERIFY(schedule.betterGivenUp());
        schedule.givenUp();
        QCOMPARE(schedule.next(2)->sample, 0);
    }

    void everyChangeStartsOver()
    {
        DrawSchedule schedule = opened();
        double now = 0;
        drawAll(schedule, now, 0.01);
        schedule.changed(now);
        const auto order = schedule.next(now);
        QVERIFY(order);
        QCOMPARE(order->sample, 0);
        schedule.drawn(*order, 0.01);
        QVERIFY(!schedule.next(now + 0.01));  // Not yet settled.
        QVERIFY(schedule.wait(now + 0.01) > 0);
        QCOMPARE(schedule.next(now + 1)->sample, 1);
    }

    void aMovedCameraDrawsAMotionAndAChangedValueDoesNot()
    {
        DrawSchedule schedule = opened();
        schedule.setHistory(8);
        double now = 0;
        drawAll(schedule, now, 0.01);
        schedule.cameraMoved(now);
        DrawOrder order = schedule.next(now).value();
        QCOMPARE(order, (DrawOrder{1, 0, 1, true}));
        schedule.begun(order);
        schedule.drawn(order, 0.01);
        QVERIFY(!schedule.next(now + 0.01));  // Not yet settled.
        order = schedule.next(now + 1).value();
        QCOMPARE(order, (DrawOrder{1, 0, 16, false}));
        schedule.changed(now + 1);
        schedule.cameraMoved(now + 1);
        QVERIFY(!schedule.next(now + 1)->inMotion);
        // Without averaging, a camera move is like any other change.
        schedule.setHistory(1);
        drawAll(schedule, now, 0.01);
        schedule.cameraMoved(now);
        QCOMPARE(schedule.next(now).value(), (DrawOrder{1, 0, 16, false}));
    }

    void aSmoothMotionStaysOnTheScreenUntilFourSamplesAreThere()
    {
        DrawSchedule schedule = opened();
        schedule.setHistory(8);
        double now = 0;
        drawAll(schedule, now, 0.01);
        schedule.cameraMoved(now);
        const DrawOrder motion = schedule.next(now).value();
        QVERIFY(schedule.improves(motion));
        schedule.drawn(motion, 0.01);
        std::string shown;
        for (int i = 0; i < 6; ++i) {
            const DrawOrder order = schedule.next(now + 1 + i).value();
            shown += schedule.improves(order) ? '+' : '-';
            schedule.drawn(order, 0.01);
        }
        QCOMPARE(QString::fromStdString(shown), QStringLiteral("---+++"));
        // Other changes are shown at once.
        schedule.cameraMoved(now + 9);
        schedule.drawn(schedule.next(now + 9).value(), 0.01);
        schedule.changed(now + 9.1);
        QVERIFY(schedule.improves(schedule.next(now + 9.1).value()));
    }

    void aSlowMachineDrawsCoarserWhileMoving()
    {
        DrawSchedule schedule = opened();
        double now = 0;
        schedule.setMoving(true, now);
        for (int i = 0; i < 10; ++i) {
            const auto order = schedule.next(now);
            const double seconds = 0.4 * order->scale * order->scale;
            now += seconds;
            schedule.drawn(*order, seconds);
        }
        QCOMPARE(schedule.scaleWhileMoving(), 0.35);  // 0.4 s × 0.35² = 49 ms: within the target.
        schedule.setMoving(false, now);
        QCOMPARE(schedule.next(now)->scale, 0.35);  // Feedback comes first ...
        const int rest = drawAll(schedule, now, 0.4);
        QCOMPARE(rest, 17);  // ... and then sixteen samples at full resolution.
    }

    void theResolutionDoesNotSwing()
    {
        // Near all thresholds, for several shares of work that does not depend on the resolution.
        for (double full = 0.02; full < 2; full *= 1.07) {
            for (const double share : {0.0, 0.2, 0.5}) {
                DrawSchedule schedule = opened();
                double now = 0;
                schedule.setMoving(true, now);
                int changes = 0;
                double before = 0;
                for (int i = 0; i < 200; ++i) {
                    const auto order = schedule.next(now);
                    if (i > 40 && order->scale != before) ++changes;
                    before = order->scale;
                    const double seconds = full * share + full * (1 - share) * order->scale * order->scale;
                    now += seconds;
                    schedule.drawn(*order, seconds);
                }
                QVERIFY2(
                    changes <= 1,
                    qPrintable(QStringLiteral("full %1 s, share %2: %3 changes").arg(full).arg(share).arg(changes)));
            }
        }
    }

    void aFastMachineComesBackToFullResolution()
    {
        DrawSchedule schedule = opened();
        double now = 0;
        schedule.setMoving(true, now);
        for (int i = 0; i < 60; ++i) {
            const auto order = schedule.next(now);
            const double seconds = (i < 20 ? 0.5 : 0.01) * order->scale * order->scale;
            now += seconds;
            schedule.drawn(*order, seconds);
        }
        QCOMPARE(schedule.scaleWhileMoving(), 1.0);
    }

    void aMovingRegionRestsAfterEachDrawingAndShowsTheEndOfTheMotion()
    {
        MovingRegion region;
        region.set(vitrine::PictureRegion{{0, 0}, {8, 8}});
        QVERIFY(!region.isDue(0));
        region.passTick(true, false);
        QVERIFY(region.isDue(0));
        region.begun();
        QVERIFY(!region.isDue(0));
        region.drawn(1, 0.1);
        region.passTick(true, false);
        QVERIFY(!region.isDue(1.4) && region.isWaiting(false));
        QVERIFY(std::abs(region.wait(1.2) - 0.3) < 1e-9);
        QVERIFY(region.isDue(1.51));
        region.begun();
        region.passTick(false, false);
        QVERIFY(region.isDue(2));  // The final state.
        region.begun();
        region.passTick(false, false);
        QVERIFY(!region.isDue(3) && !region.isWaiting(false));
        region.passTick(false, true);
        QVERIFY(region.isDue(3));
        region.set({});
        QVERIFY(!region.isDue(3));
        region.set(vitrine::PictureRegion{{0, 0}, {8, 8}});
        QVERIFY(!region.isDue(3));
    }

    void theReasonIsThatOfThePictureOnTheScreen()
    {
        DrawSchedule schedule = opened();
        schedule.setMoving(true, 0);
        schedule.drawn(*schedule.next(0), 1.0);  // Far too slow: the next ones have a lower resolution.
        QVERIFY(schedule.scaleWhileMoving() < 1);
        QCOMPARE(schedule.reason(), QString("Rendering at 100 %"));
        schedule.drawn(*schedule.next(1), 0.05);
        QCOMPARE(schedule.reason(), QString("Rendering at %1 %").arg(schedule.scaleWhileMoving() * 100));
    }
};

VITRINE_UI_TEST(DrawScheduleTest)

#include "draw_schedule_test.moc"
