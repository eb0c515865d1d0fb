#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "render/failure.h"
#include "ui/controllers/controllers.h"
#include "ui/gamepad/gamepad_control.h"
#include "ui/window/kiosk.h"
#include "ui/window/kiosk_panel.h"
#include "ui/window/window_preferences.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QSignalSpy>
#include <QStatusBar>

using namespace vitrine;
using namespace vitrine::ui;

/// Window of an exhibition.
class KioskTest : public test::OpenWindow {
    Q_OBJECT

    std::unique_ptr<Kiosk> kiosk_;

    void begin(const KioskOptions& options) { kiosk_ = std::make_unique<Kiosk>(*window_, options); }
    [[nodiscard]] ParameterRow* row(const char* name) const
    {
        for (auto* each : window_->findChildren<KioskPanel*>().value(0)->findChildren<ParameterRow*>())
            if (each->info().name == name) return each;
        return nullptr;
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup()
    {
        kiosk_.reset();
        finish();
    }

    void onlyThePictureAndTheAllowedParametersAreShown()
    {
        begin({.parameters = {"sdf_morph.roughness"}});
        QTRY_VERIFY(window_->isFullScreen());
        QVERIFY(!window_->menuBar()->isVisible());
        QVERIFY(!window_->statusBar()->isVisible());
        for (const QDockWidget* dock : window_->findChildren<QDockWidget*>()) QVERIFY(!dock->isVisible());
        auto* panel = window_->findChild<KioskPanel*>();
        QVERIFY(panel);
        QVERIFY2(!panel->isVisible(), "the hall has none");
        window_->visit(1);
        QTRY_VERIFY(panel->isVisible());
        QVERIFY(window_->viewport().rect().contains(panel->geometry()));
        QVERIFY(row("roughness")->isVisible());
        QCOMPARE(panel->findChildren<ParameterRow*>().size(), 1);
        // It follows the value, and changes it.
        SceneState next = window_->history().sceneState();
        next.values[1].set(gallery_->table().roughness, 0.9);
        window_->history().change("another", next);
        auto* slider = row("roughness")->findChild<ValueSlider*>();
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, slider->height() / 2));
        QTRY_VERIFY(std::abs(roughness() - 0.5) < 0.1);
        for (const QDockWidget* dock : window_->findChildren<QDockWidget*>()) QVERIFY(!dock->isVisible());
    }

    void controllersMoveTheAllowedParametersAlone()
    {
        PreferenceValues wanted = window_->preferences().values().values();
        wanted.controllers = {{"sdf_morph/roughness", "cc 1 21"}, {"sdf_morph/morph", "cc 1 22"}};
        window_->preferences().values().set(wanted);
        auto* controllers = window_->findChild<Controllers*>();
        QVERIFY(controllers && controllers->isControlled("sdf_morph/morph"));
        QVERIFY(controllers->mayLearn("sdf_morph/morph"));
        begin({.parameters = {"sdf_morph.roughness"}});
        QVERIFY(!controllers->mayLearn("sdf_morph/roughness"));
        const SceneState before = window_->history().sceneState();
        const auto sweep = [&](unsigned char control) {
            for (const int value : {0, 32, 64, 96, 127})
                controllers->take({{{}, {}, {0xb0, control, static_cast<unsigned char>(value)}}});
        };
        sweep(22);
        QVERIFY(window_->history().sceneState() == before);
        sweep(21);
        QVERIFY(!(window_->history().sceneState() == before));
        QCOMPARE(roughness(), 1.0);
    }

    void commandsShortcutsAndMenusDoNothing()
    {
        begin({});
        window_->activateWindow();
        QTRY_VERIFY(window_->isFullScreen());
        window_->viewport().setFocus();
        QAction* undo = action("Undo");
        QVERIFY(undo);
        window_->history().set(1, gallery_->table().roughness.row, 0.75, 0);
        const std::size_t dialogs = static_cast<std::size_t>(QApplication::topLevelWidgets().size());
        for (const Qt::Key key :
             {Qt::Key_Z, Qt::Key_O, Qt::Key_P, Qt::Key_F, Qt::Key_K, Qt::Key_L, Qt::Key_Q, Qt::Key_Comma})
            for (const Qt::KeyboardModifiers modifiers :
                 {Qt::KeyboardModifiers(Qt::ControlModifier), Qt::ControlModifier | Qt::ShiftModifier})
                QTest::keyClick(&window_->viewport(), key, modifiers);
        for (const Qt::Key key : {Qt::Key_F1, Qt::Key_F4, Qt::Key_F11, Qt::Key_F12, Qt::Key_Question, Qt::Key_Space})
            QTest::keyClick(&window_->viewport(), key);
        QTest::mouseClick(&window_->viewport(), Qt::RightButton);
        QCoreApplication::processEvents();
        QCOMPARE(roughness(), 0.75);
        QVERIFY(window_->isVisible());
        QVERIFY(window_->isFullScreen());
        QVERIFY(!window_->menuBar()->isVisible());
        QVERIFY(!window_->viewport().clock().paused());
        QCOMPARE(static_cast<std::size_t>(QApplication::topLevelWidgets().size()), dialogs);
        // Nor do the commands of a gamepad.
        auto* gamepad = window_->findChild<GamepadControl*>();
        emit gamepad->parameterRequested(1);
        emit gamepad->pauseAsked();
        QVERIFY(window_->bare());
        QVERIFY(!window_->viewport().clock().paused());
        // A walk goes on.
        const render::Camera before = window_->history().sceneState().camera;
        QTest::keyPress(&window_->viewport(), Qt::Key_W);
        QTRY_VERIFY(!(window_->history().sceneState().camera == before));
        QTest::keyRelease(&window_->viewport(), Qt::Key_W);
    }

    void longIdleMinutesBringTheStartBack()
    {
        const SceneState start = window_->history().sceneState();
        begin({.minutes = 0.02, .parameters = {"sdf_morph.roughness", "hall.exposure"}});
        QTRY_VERIFY(window_->isFullScreen());
        auto* panel = window_->findChild<KioskPanel*>();
        QVERIFY2(panel->isVisible(), "the hall has one");
        window_->visit(1);
        window_->history().set(1, gallery_->table().roughness.row, 0.75, 0);
        QTRY_VERIFY(!(window_->history().sceneState().camera == start.camera));
        // Input keeps it as it is.
        for (int i = 0; i < 8; ++i) {
            QTest::mouseMove(&window_->viewport(), QPoint(100 + i, 100));
            QTest::qWait(250);
            QCOMPARE(roughness(), 0.75);
        }
        QTRY_COMPARE_WITH_TIMEOUT(window_->chosen(), hallIndex, test::patience);
        QVERIFY(window_->history().sceneState() == start);
        QCOMPARE(window_->history().stack().count(), 0);
        QCoreApplication::processEvents();
        QVERIFY2(!kiosk_->isWaiting(), "beginning anew is no input");
        QVERIFY(!row("roughness")->isVisible());
        QVERIFY(row("exposure")->isVisible());
    }

    void onlyItsKeysCloseIt()
    {
        begin({});
        QTRY_VERIFY(window_->isFullScreen());
        window_->close();
        QVERIFY(window_->isVisible());
        window_->viewport().setFocus();
        QTest::keyClick(&window_->viewport(), Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!window_->isVisible());
    }

    void whatCannotBeAllowedIsNamed()
    {
        for (const auto& [name, part] :
             {std::pair("sdf_morph.roughnes", "did you mean roughness?"),
              std::pair("sdf_morf.roughness", "did you mean sdf_morph?"), std::pair("roughness", "exhibit.parameter"),
              std::pair("sdf_morph.environment", "files")})
            try {
                begin({.parameters = {name}});
                QFAIL(name);
            } catch (const Failure& failure) {
                QVERIFY2(std::string(failure.what()).find(part) != std::string::npos, failure.what());
            }
        QVERIFY2(!window_->bare(), "a refused kiosk changes nothing");
    }
};

VITRINE_UI_TEST(KioskTest)

#include "kiosk_test.moc"
