// A virtual gamepad of SDL in the real window.
#include "exhibits/jobs.h"
#include "tests/ui/gamepad/virtual_pad.h"
#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/gamepad/gamepad_control.h"
#include "ui/gamepad/stick.h"
#include "ui/window/window_dialogs.h"

#include <QDialog>
#include <QFile>
#include <QPointer>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

/// Returns whether a library of this name is loaded in the process.
bool isLoaded(const char* library)
{
    QFile maps("/proc/self/maps");
    return maps.open(QIODevice::ReadOnly) && maps.readAll().contains(library);
}

}  // namespace

class GamepadTest : public test::OpenWindow {
    Q_OBJECT

    std::unique_ptr<test::VirtualPad> pad_;

    [[nodiscard]] GamepadControl& control() { return *window_->findChild<GamepadControl*>(); }
    [[nodiscard]] render::Camera camera() { return window_->history().sceneState().camera; }
    void plugIn()
    {
        QApplication::setActiveWindow(window_.get());  // Under Xvfb there is no window manager.
        QTRY_VERIFY(window_->isActiveWindow());
        control().open();
        pad_ = std::make_unique<test::VirtualPad>();
        QVERIFY2(pad_->works(), SDL_GetError());
        QTRY_VERIFY(control().connected());
    }
    /// Presses and releases a button and waits until both are noticed and the sticks are idle.
    void press(SDL_GameControllerButton button)
    {
        QTRY_VERIFY(control().interval() != 16);
        pad_->button(button, true);
        QTRY_COMPARE(control().interval(), 16);
        pad_->button(button, false);
        QTRY_VERIFY(control().interval() != 16);
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup()
    {
        pad_.reset();
        finish();
    }

    void longWithoutAGamepadNothingIsOpenedAndNothingIsAsked()
    {
        if (padIsPlugged()) QSKIP("A gamepad is plugged into this machine.");
        QTest::qWait(2500);  // The search begins two seconds after the start.
        QVERIFY(!control().opened());
        QCOMPARE(control().interval(), 0);
        QVERIFY(!isLoaded("libvitrine_gamepad"));
        control().open();
        QVERIFY(isLoaded("libvitrine_gamepad"));
        QTRY_COMPARE(control().interval(), 1000);  // Opened, without a connected gamepad.
        QVERIFY(!control().connected());
    }

    void aStickRestsInItsMiddleAndSetsInSmoothly()
    {
        QCOMPARE(pushOf(0.2, -0.1), Push());
        QCOMPARE(pullOf(0.1), 0.0);
        for (const double angle : {0.0, 0.7, 2.0, -2.9}) {
            const double x = std::cos(angle), y = std::sin(angle);
            double before = 0, slopeBefore = 0;
            for (double way = 0; way <= 1.4; way += 0.001) {
                const Push push = pushOf(way * x, way * y);
                const double length = std::hypot(push.x, push.y);
                QVERIFY(length >= before - 1e-12 && length <= 1 + 1e-12);  // Except for rounding at the edge.
                const double slope = (length - before) / 0.001;
                // No jump of the slope up to the edge.
                QVERIFY(way > stickIsFull || std::abs(slope - slopeBefore) < 0.01);
                if (length > 0) QVERIFY(std::abs(push.x * y - push.y * x) < 1e-12);  // The direction is kept.
                before = length;
                slopeBefore = slope;
            }
            QCOMPARE(before, 1.0);
        }
    }

    void theWayOfAStickDoesNotDependOnHowTimeIsCut()
    {
        WalkKeys keys;
        keys.ahead = 0.6;
        keys.aside = -0.2;
        const auto walked = [&](int steps) {
            CameraControl visitor;
            visitor.jumpTo({{0, 1.65, 5}, {0, 1.65, 0}, 0.9});
            for (int i = 0; i < steps; ++i) visitor.advance(0.4 / steps, keys);
            return visitor.camera().eye;
        };
        QVERIFY(glm::distance(walked(1), walked(37)) < 1e-12);
        WalkKeys look;
        look.yaw = 1.5;
        CameraControl visitor;
        visitor.jumpTo({{0, 1.65, 5}, {0, 1.65, 0}, 0.9});
        for (int i = 0; i < 10; ++i) visitor.advance(0.1, look);
        QVERIFY(std::abs(headingOf(visitor.camera().target - visitor.camera().eye).yaw - 1.5) < 1e-9);
        // Full deflection is as fast as a key, half of it slower.
        WalkKeys full, key;
        full.ahead = 1;
        key.forward = true;
        CameraControl a, b;
        for (CameraControl* each : {&a, &b}) each->jumpTo({{0, 1.65, 5}, {0, 1.65, 0}, 0.9});
        a.advance(0.3, full);
        b.advance(0.3, key);
        QCOMPARE(a.camera().eye.z, b.camera().eye.z);
    }

    void longTheLeftStickWalksAndWhoPullsThePlugStops()
    {
        plugIn();
        const double before = camera().eye.z;
        pad_->stick(SDL_CONTROLLER_AXIS_LEFTY, -1);
        QTRY_VERIFY(camera().eye.z < before - 0.05);
        pad_.reset();  // Removed while the stick is deflected.
        QTRY_VERIFY(!control().connected());
        QTRY_COMPARE(control().interval(), 1000);
        settle();
        const render::Camera after = camera();
        QTest::qWait(300);
        QVERIFY(camera() == after);
        QCOMPARE(window_->history().stack().count(), 0);
    }

    void longTheTriggerRunsAndTheRightStickLooks()
    {
        plugIn();
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTX, 0.8);
        QTRY_VERIFY(headingOf(camera().target - camera().eye).yaw > 0.2);
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTX, 0.1);  // Within the dead zone.
        QTRY_VERIFY(!window_->viewport().input().sticks().moves());
        // Outside of the dead zone, the length of both axes together counts.
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTX, 0);
        settle();
        const double yaw = headingOf(camera().target - camera().eye).yaw;
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTY, -0.8);
        QTRY_VERIFY(camera().target.y > 1.8);
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTY, 0);
        QTRY_VERIFY(!window_->viewport().input().sticks().moves());
        settle();
        QCOMPARE(headingOf(camera().target - camera().eye).yaw, yaw);
        const WalkKeys& held = window_->viewport().input().sticks();
        pad_->stick(SDL_CONTROLLER_AXIS_LEFTY, -1);
        QTRY_VERIFY(held.ahead > 0.99);
        QVERIFY(!held.run);
        pad_->trigger(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
        QTRY_VERIFY(held.run);
        pad_->trigger(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 0);
        QTRY_VERIFY(!held.run);
        pad_->button(SDL_CONTROLLER_BUTTON_LEFTSTICK, true);
        QTRY_VERIFY(held.run);
        pad_->button(SDL_CONTROLLER_BUTTON_LEFTSTICK, false);
        pad_->stick(SDL_CONTROLLER_AXIS_LEFTY, 0);
        QTRY_VERIFY(!held.moves());
    }

    void longButtonsVisitPressGoBackAndWalkOn()
    {
        plugIn();
        QSignalSpy pressed(&window_->viewport().interaction(), &Interaction::pressed);
        const render::Camera before = camera();
        press(SDL_CONTROLLER_BUTTON_A);  // The exhibit is in the middle of the first picture.
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        QCOMPARE(window_->chosen(), std::size_t{1});
        press(SDL_CONTROLLER_BUTTON_X);
        QCOMPARE(pressed.count(), 1);
        const double far = glm::distance(camera().eye, camera().target);
        pad_->trigger(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
        QTRY_VERIFY(glm::distance(camera().eye, camera().target) < far * 0.9);
        pad_->trigger(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 0);
        const double x = camera().eye.x;
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTX, 1);
        QTRY_VERIFY(camera().eye.x < x - 0.05);  // Like a drag to the right.
        pad_->stick(SDL_CONTROLLER_AXIS_RIGHTX, 0);
        press(SDL_CONTROLLER_BUTTON_Y);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::walk);
        QVERIFY(camera() == before);
        press(SDL_CONTROLLER_BUTTON_A);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        press(SDL_CONTROLLER_BUTTON_B);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::walk);
        // Within reach of a button, A presses it.
        window_->viewport().visitor().jumpTo(test::PaintedGallery::towardsButton(1.2));
        press(SDL_CONTROLLER_BUTTON_A);
        QCOMPARE(pressed.count(), 2);
        QCOMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::walk);
    }

    void longShouldersVisitTheNextExhibitAndStartStopsTheClock()
    {
        plugIn();
        press(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
        QCOMPARE(window_->chosen(), std::size_t{1});
        press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
        QCOMPARE(window_->chosen(), std::size_t{0});
        press(SDL_CONTROLLER_BUTTON_START);
        QVERIFY(window_->viewport().clock().paused());
        press(SDL_CONTROLLER_BUTTON_START);
        QVERIFY(!window_->viewport().clock().paused());
    }

    void longTheCrossChoosesARowAndChangesItInOneStep()
    {
        plugIn();
        window_->choose(1);
        press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        auto* row = window_->panel().row("roughness");
        for (int i = 0; i < 40 && !row->isAncestorOf(QApplication::focusWidget()); ++i)
            press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        QCOMPARE(QApplication::focusWidget(), in<ValueSlider>("roughness"));
        const double before = roughness();
        pad_->button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, true);
        QTRY_VERIFY(roughness() > before + 0.05);  // It repeats while it is held ...
        pad_->button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, false);
        QTRY_VERIFY(control().interval() != 16);
        QCOMPARE(window_->history().stack().count(), 1);  // ... as one undo step.
        window_->history().stack().undo();
        QCOMPARE(roughness(), before);
        QWidget* now = QApplication::focusWidget();
        press(SDL_CONTROLLER_BUTTON_DPAD_UP);
        QVERIFY(QApplication::focusWidget() != now);
        // The sticks walk all the same.
        const double z = camera().eye.z;
        pad_->stick(SDL_CONTROLLER_AXIS_LEFTY, -1);
        QTRY_VERIFY(camera().eye.z < z - 0.02);
    }

    void inADialogTheCrossMovesAndBCloses()
    {
        plugIn();
        const render::Camera before = camera();
        window_->dialogs().openJob(*jobs::findJob("render"));
        QPointer<QWidget> dialog = window_->findChild<QDialog*>();
        QVERIFY(dialog);
        QVERIFY(QTest::qWaitForWindowExposed(dialog, test::patience));
        QApplication::setActiveWindow(dialog);
        QWidget* first = QApplication::focusWidget();
        press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
        QVERIFY(QApplication::focusWidget() && QApplication::focusWidget() != first);
        QVERIFY(dialog->isAncestorOf(QApplication::focusWidget()));
        pad_->stick(SDL_CONTROLLER_AXIS_LEFTY, -1);  // The dialog keeps the input from the picture.
        press(SDL_CONTROLLER_BUTTON_B);
        pad_->stick(SDL_CONTROLLER_AXIS_LEFTY, 0);
        QTRY_VERIFY(!dialog || !dialog->isVisible());
        QVERIFY(camera() == before);
    }
};

VITRINE_UI_TEST(GamepadTest)

#include "gamepad_test.moc"
