#include "tests/ui/ui_main.h"

#include "exhibits/museum/picture_settings.h"
#include "ui/viewport/camera_control.h"
#include "ui/viewport/picture_place.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vitrine::ui;
using vitrine::render::Camera;

namespace {

/// Collision test of a room without walls.
glm::dvec3 room(const glm::dvec3&, const glm::dvec3& to)
{
    return {std::clamp(to.x, -4.0, 4.0), to.y, std::clamp(to.z, -3.0, 3.0)};
}

Camera entrance()
{
    return {{0, 1.65, 0}, {0, 1.65, -5}, 0.96};
}

WalkKeys forward()
{
    WalkKeys keys;
    keys.forward = true;
    return keys;
}

double walked(double seconds, double frame, const WalkKeys& keys)
{
    Walker walker;
    walker.place(entrance());
    for (double t = 0; t < seconds - 1e-9; t += frame) walker.advance(std::min(frame, seconds - t), keys, {});
    return glm::distance(walker.camera().eye, entrance().eye);
}

}  // namespace

class CameraControlTest : public QObject {
    Q_OBJECT

private slots:
    void aPictureOfAnotherSizeLiesWhereTheNextOneWillShowTheSame()
    {
        // Position of a direction in the picture, by the pinhole formula.
        const auto place = [](const glm::dvec2& tangent, const QSizeF& size) {
            const double focal = size.height() / 2 / std::tan(widened({}, size.width() / size.height()).fovY / 2);
            return QPointF(size.width() / 2 + tangent.x * focal, size.height() / 2 - tangent.y * focal);
        };
        const QList<QSize> sizes{{1200, 800}, {1200, 400}, {700, 800}, {300, 900}, {1920, 300}};
        for (const QSize& before : sizes)
            for (const QSize& now : sizes) {
                const QRectF lies = pictureIn(before, QRectF(QPointF(0, 0), QSizeF(now)));
                QVERIFY(std::abs(lies.width() / lies.height() - double(before.width()) / before.height()) < 1e-9);
                for (const glm::dvec2& tangent : {glm::dvec2(0, 0), glm::dvec2(0.2, -0.1), glm::dvec2(-0.3, 0.25)}) {
                    const QPointF old = place(tangent, before);
                    const QPointF shown(lies.x() + old.x() * lies.width() / before.width(),
                                        lies.y() + old.y() * lies.height() / before.height());
                    const QPointF off = shown - place(tangent, now);
                    QVERIFY2(std::hypot(off.x(), off.y()) < 1e-6 * now.height(), qPrintable(QString::number(off.x())));
                }
            }
    }

    void aHeadingGoesThereAndBack()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> angle(-1.4, 1.4);
        for (int i = 0; i < 1000; ++i) {
            const Heading h{2 * angle(random), angle(random)};
            const Heading back = headingOf(directionOf(h));
            QVERIFY(std::abs(back.yaw - h.yaw) < 1e-12 && std::abs(back.pitch - h.pitch) < 1e-12);
        }
        QVERIFY(std::abs(headingOf({0, 0, -1}).yaw) < 1e-12);
        QVERIFY(headingOf({1, 0, 0}).yaw > 0);
    }

    void walkingCoversTheSameWayAtAnyFrameRate()
    {
        // The differential equation is solved exactly, so only rounding may differ.
        const double fine = walked(2, 1.0 / 240, forward());
        for (const double frame : {1.0 / 120, 1.0 / 60, 1.0 / 17, 0.1, 0.25, 0.5})
            QVERIFY(std::abs(walked(2, frame, forward()) - fine) < 1e-9);
        // 2 s at 1.4 m/s, minus the soft start: speed × response.
        QVERIFY(std::abs(fine - (1.4 * 2 - 1.4 * Walker::response)) < 1e-6);
    }

    void runningIsFasterAndDiagonalIsNot()
    {
        WalkKeys run = forward();
        run.run = true;
        QVERIFY(std::abs(walked(2, 0.01, run) / walked(2, 0.01, forward()) - 2.5) < 1e-6);
        WalkKeys diagonal = forward();
        diagonal.left = true;
        QVERIFY(std::abs(walked(2, 0.01, diagonal) - walked(2, 0.01, forward())) < 1e-9);
    }

    void stoppingIsSoftAndEnds()
    {
        Walker walker;
        walker.place(entrance());
        for (int i = 0; i < 60; ++i) walker.advance(1.0 / 60, forward(), {});
        const glm::dvec3 released = walker.camera().eye;
        int frames = 0;
        while (walker.moving() && frames < 1000) {
            walker.advance(1.0 / 60, {}, {});
            ++frames;
        }
        QVERIFY(frames > 10 && frames < 120);
        QVERIFY(glm::distance(walker.camera().eye, released) < 0.2);
        const glm::dvec3 stands = walker.camera().eye;
        walker.advance(1, {}, {});
        QCOMPARE(walker.camera().eye.z, stands.z);
    }

    void aVisitorNeverPassesAWall()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> seconds(0.001, 0.6), turn(-1, 1);
        Walker walker;
        walker.place(entrance());
        for (int i = 0; i < 5000; ++i) {
            WalkKeys keys;
            keys.forward = random() % 2;
            keys.left = random() % 2;
            keys.right = random() % 3 == 0;
            keys.run = random() % 2;
            walker.turn(turn(random), turn(random));
            walker.advance(seconds(random), keys, room);
            const glm::dvec3 eye = walker.camera().eye;
            QVERIFY(std::abs(eye.x) <= 4 && std::abs(eye.z) <= 3);
            QCOMPARE(eye.y, 1.65);
        }
    }

    void aThinWallStopsARunnerWithASlowMachine()
    {
        // Like a careless collision test, this one stops only steps that end inside of the wall.
        const Walkable thin = [](const glm::dvec3& from, const glm::dvec3& to) {
            return to.z < -2 && to.z > -2.2 ? from : to;
        };
        Walker walker;
        walker.place(entrance());
        WalkKeys run = forward();
        run.run = true;
        for (int i = 0; i < 20; ++i) walker.advance(0.5, run, thin);
        QVERIFY(walker.camera().eye.z >= -2);
    }

    void aWallTakesTheSpeedIntoIt()
    {
        Walker walker;
        walker.place(entrance());
        for (int i = 0; i < 300; ++i) walker.advance(1.0 / 60, forward(), room);
        QCOMPARE(walker.camera().eye.z, -3.0);
        WalkKeys back;
        back.back = true;
        walker.advance(0.1, back, room);
        QVERIFY(walker.camera().eye.z > -3.0);
    }

    void lookingUpAndDownEndsBeforeTheVertical()
    {
        Walker walker;
        walker.place(entrance());
        for (int i = 0; i < 100; ++i) walker.turn(0.1, 0.3);
        const Camera up = walker.camera();
        QVERIFY(std::abs(glm::normalize(up.target - up.eye).y) < 0.9999);
    }

    void orbitKeepsDistanceAndLimits()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> turn(-2, 2);
        Orbit orbit;
        const Camera start{{0, 1.6, 3}, {0, 1.2, 0}, 0.9};
        orbit.start(start);
        QVERIFY(orbit.camera() == start);
        const double distance = glm::distance(start.eye, start.target);
        for (int i = 0; i < 2000; ++i) {
            orbit.turn(turn(random), turn(random));
            const Camera c = orbit.camera();
            QVERIFY(std::abs(glm::distance(c.eye, c.target) - distance) < 1e-9);
            QVERIFY(c.eye.y >= Orbit::lowestEye - 1e-9);
            QVERIFY(c.target == start.target);
        }
        for (int i = 0; i < 100; ++i) orbit.zoom(5);
        QVERIFY(std::abs(glm::distance(orbit.camera().eye, start.target) - distance * Orbit::nearestPart) < 1e-9);
        for (int i = 0; i < 100; ++i) orbit.zoom(-5);
        QVERIFY(std::abs(glm::distance(orbit.camera().eye, start.target) - distance * Orbit::farthestPart) < 1e-9);
    }

    void whatIsDraggedFollowsTheHand()
    {
        CameraControl control;
        control.jumpTo(entrance());
        control.visit({{0, 1.6, 3}, {0, 1.2, 0}, 0.9});
        while (control.mode() == CameraControl::Mode::glide) control.advance(0.1, {});
        control.turn(0.2, 0);
        QVERIFY(control.camera().eye.x < 0);
    }

    void aGlideEndsExactlyAndNeverJumps()
    {
        const Camera from{{-3, 1.65, 8}, {-3, 1.65, 3}, 0.96}, to{{2, 1.2, -4}, {2.5, 1.1, -1}, 0.7};
        Glide glide;
        glide.start(from, to);
        QVERIFY(glm::distance(glide.camera().eye, from.eye) < 1e-12);
        glm::dvec3 before = from.eye;
        while (!glide.finished()) {
            glide.advance(0.01);
            QVERIFY(glm::distance(glide.camera().eye, before) < 0.4);
            before = glide.camera().eye;
        }
        QVERIFY(glide.camera() == to);
    }

    void aVisitGlidesOrbitsAndWalksOn()
    {
        CameraControl control;
        control.setWalkable(room);
        control.jumpTo(entrance());
        const Camera best{{0, 1.1, 2}, {0, 1, 0}, 0.8};
        control.visit(best);
        QCOMPARE(control.mode(), CameraControl::Mode::glide);
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        QCOMPARE(control.mode(), CameraControl::Mode::orbit);
        QVERIFY(control.camera() == best);
        control.zoom(2);
        QVERIFY(control.camera().eye.z < 2);
        control.walkOn();
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        QCOMPARE(control.mode(), CameraControl::Mode::walk);
        QCOMPARE(control.camera().eye.y, Walker::eyeHeight);
        QVERIFY(!control.moving());
    }

    void walkingOnKeepsLookingAtWhatWasVisited()
    {
        CameraControl control;
        control.setWalkable(room);
        control.jumpTo(entrance());
        control.visit({{0.4, 2.6, 2}, {0, 1, 0}, 0.8});  // From above: at eye height the same direction misses it.
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        control.turn(0.3, -0.4);
        control.walkOn();
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        const Camera c = control.camera();
        const glm::dvec3 sceneState = glm::normalize(c.target - c.eye),
                         there = glm::normalize(glm::dvec3(0, 1, 0) - c.eye);
        QVERIFY2(glm::distance(sceneState, there) < 1e-9,
                 qPrintable(QString::number(glm::distance(sceneState, there))));
    }

    void theWayBackEndsWhereOneStood()
    {
        CameraControl control;
        control.setWalkable(room);
        control.jumpTo(entrance());
        const CameraControl::Standpoint before = control.standpoint();
        control.visit({{0, 1.1, 2}, {0, 1, 0}, 0.8});
        control.advance(0.05, {});
        QVERIFY(control.standpoint().camera.eye == glm::dvec3(0, 1.1, 2));  // The end of the glide counts.
        QCOMPARE(control.standpoint().mode, CameraControl::Mode::orbit);
        control.glideTo(before);
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        QVERIFY(control.camera() == before.camera);
        QCOMPARE(control.mode(), CameraControl::Mode::walk);
    }

    void aNarrowPictureShowsAsMuchFromSideToSide()
    {
        const Camera camera{{0, 1, 2}, {0, 1, 0}, 0.8};
        for (const double aspect : {1.5, 16.0 / 9, 3.0}) QVERIFY(widened(camera, aspect) == camera);
        for (const double aspect : {1.4, 1.0, 0.6}) {
            const Camera wide = widened(camera, aspect);
            QVERIFY(std::abs(std::tan(wide.fovY / 2) * aspect - std::tan(camera.fovY / 2) * 1.5) < 1e-12);
            QVERIFY(wide.eye == camera.eye && wide.target == camera.target);
        }
        for (const double aspect : {1e-3, 0.0, -1.0, std::nan("")}) QVERIFY(widened(camera, aspect).fovY < 2.7);
    }

    void aJumpIsExactAndOrbitsWhereNobodyCanStand()
    {
        CameraControl control;
        const Camera standing{{1, 1.65, 2}, {0.3, 1.1, -4.7}, 0.8}, flying{{1, 3, 2}, {0, 1, 0}, 0.8};
        control.jumpTo(standing);
        QVERIFY(control.camera() == standing);
        QCOMPARE(control.mode(), CameraControl::Mode::walk);
        control.jumpTo(flying);
        QVERIFY(control.camera() == flying);
        QCOMPARE(control.mode(), CameraControl::Mode::orbit);
        control.walkOn();
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        QCOMPARE(control.camera().eye.y, Walker::eyeHeight);
    }

    void walkingOnFromInsideAWallGoesBackToWhereTheVisitBegan()
    {
        CameraControl control;
        control.setWalkable(room);
        control.jumpTo(entrance());
        control.visit({{6, 1.1, 0}, {0, 1, 0}, 0.8});
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        control.walkOn();
        for (int i = 0; i < 20; ++i) control.advance(0.05, {});
        QVERIFY(glm::distance(control.camera().eye, entrance().eye) < 1e-9);
    }
};

VITRINE_UI_TEST(CameraControlTest)

#include "camera_control_test.moc"
