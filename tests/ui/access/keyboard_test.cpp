// The whole window used by keyboard only.
#include "tests/ui/access/every_part.h"
#include "tests/ui/access/keyboard_walk.h"
#include "tests/ui/ui_main.h"

#include "ui/compare/compare_controller.h"
#include "ui/compare/compare_overlay.h"
#include "ui/window/dock_title.h"
#include "ui/window/window_docks.h"

#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QStatusBar>

#include <functional>

using namespace vitrine;
using namespace vitrine::ui;

class KeyboardTest : public test::EveryPart {
    Q_OBJECT

    /// Returns the letter after the single ampersand; null: none.
    [[nodiscard]] static QChar mnemonic(const QString& text)
    {
        for (qsizetype i = 0; i + 1 < text.size(); ++i) {
            if (text[i] != QLatin1Char('&')) continue;
            if (text[i + 1] != QLatin1Char('&')) return text[i + 1].toLower();
            ++i;
        }
        return {};
    }
    static void checkMenu(const QString& where, const QList<QAction*>& actions, QStringList& complaints)
    {
        QMap<QChar, QString> taken;
        for (QAction* each : actions) {
            const QChar key = mnemonic(each->text());
            if (each->isSeparator() || !each->isVisible()) continue;
            if (!key.isNull() && taken.contains(key))
                complaints << QStringLiteral("%1: %2 and %3").arg(where, taken[key], each->text());
            taken[key] = each->text();
            if (each->menu()) checkMenu(where + QLatin1Char('/') + each->text(), each->menu()->actions(), complaints);
        }
    }
    [[nodiscard]] QDockWidget* dockWithFocus()
    {
        for (QDockWidget* dock : window_->docks().all())
            if (dock->isAncestorOf(QApplication::focusWidget())) return dock;
        return nullptr;
    }
    void pressF6(Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, modifiers);
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        activate(window_.get());
    }
    void cleanup() { finish(); }

    void longTabGoesThroughEveryPanelInOrderAndIsSeen()
    {
        QStringList complaints;
        int stops = 0;
        forEveryDock([&](QDockWidget& dock) {
            const test::KeyboardWalk walk = test::walkByTab(dock);
            stops += static_cast<int>(walk.stops.size());
            for (const QString& each : walk.complaints) complaints << dock.objectName() + QLatin1String(": ") + each;
        });
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
        QVERIFY2(stops > 60, qPrintable(QString::number(stops)));
    }

    void longTabGoesThroughEveryDialogInOrderAndEscClosesIt()
    {
        QStringList complaints;
        int stops = 0;
        forEveryDialog([&](const QString& name, QWidget& dialog) {
            const test::KeyboardWalk walk = test::walkByTab(dialog);
            stops += static_cast<int>(walk.stops.size());
            for (const QString& each : walk.complaints) complaints << name + QLatin1String(": ") + each;
            // Enter on a control without a meaning for it activates one default button, or nothing by design.
            QStringList defaults, byThemselves;
            for (const QPushButton* each : dialog.findChildren<QPushButton*>()) {
                if (each->isVisible() && each->isDefault()) defaults << each->text();
                if (each->isVisible() && each->autoDefault()) byThemselves << each->text();
            }
            if (defaults.size() > 1 || (defaults.isEmpty() && !byThemselves.isEmpty()))
                complaints << QStringLiteral("%1: Enter presses %2 of %3")
                                  .arg(name, defaults.join('|'), byThemselves.join('|'));
            // In a field with typed text, the first Esc restores its value.
            const QPointer<QWidget> before = &dialog;
            for (int i = 0; i < 2 && before && before->isVisible(); ++i) {
                QWidget* focus = QApplication::focusWidget();
                QTest::keyClick(focus && dialog.isAncestorOf(focus) ? focus : &dialog, Qt::Key_Escape);
                QTest::qWait(0);
            }
            if (before && before->isVisible()) complaints << name + QLatin1String(": Esc does not close it");
        });
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
        QVERIFY2(stops > 60, qPrintable(QString::number(stops)));
    }

    void f6GoesRoundTheWindowAndShiftF6Back()
    {
        window_->choose(1);
        window_->viewport().setFocus();
        QStringList round;
        pressF6();
        while (!window_->viewport().hasFocus() && round.size() < 20) {
            round << (dockWithFocus()                                                   ? dockWithFocus()->objectName()
                      : window_->statusBar()->isAncestorOf(QApplication::focusWidget()) ? "status"
                                                                                        : "?");
            pressF6();
        }
        QCOMPARE(round, QStringList({"exhibits", "presets", "parameters", "status"}));
        pressF6(Qt::ShiftModifier);
        pressF6(Qt::ShiftModifier);
        QCOMPARE(dockWithFocus(), window_->findChild<QDockWidget*>("parameters"));
        // A panel that had the focus before focuses the same control again.
        auto* slider = in<ValueSlider>("roughness");
        slider->setFocus();
        pressF6();
        pressF6(Qt::ShiftModifier);
        QVERIFY(slider->hasFocus());
        // Messages, the comparison and newly opened panels are included.
        window_->say(MessageStrip::Mood::problem, "Something went wrong.");
        window_->comparison().setToCurrent();
        auto* report = window_->findChild<QDockWidget*>("frame-report");
        report->show();
        QTRY_VERIFY(!report->visibleRegion().isEmpty());
        window_->viewport().setFocus();
        int parts = 1;
        for (pressF6(); !window_->viewport().hasFocus() && parts < 20; pressF6()) ++parts;
        QCOMPARE(parts, 8);
    }

    void panelsAreMovedAndResizedFromTheMenuOfTheirTitle()
    {
        auto* presets = window_->findChild<QDockWidget*>("presets");
        const auto entry = [presets](const char* name) {
            for (QAction* each : presets->findChild<DockTitle*>()->menu().actions())
                if (each->text().remove('&') == QLatin1String(name)) return each;
            return static_cast<QAction*>(nullptr);
        };
        auto* list = presets->findChild<QListWidget*>();
        list->setFocus();
        entry("To the right")->trigger();
        QCOMPARE(window_->dockWidgetArea(presets), Qt::RightDockWidgetArea);
        QVERIFY(list->hasFocus());
        entry("To the left")->trigger();
        QCOMPARE(window_->dockWidgetArea(presets), Qt::LeftDockWidgetArea);
        const int width = presets->width();
        entry("Wider")->trigger();
        QTRY_VERIFY(presets->width() > width);
        entry("Narrower")->trigger();
        QTRY_COMPARE(presets->width(), width);
        entry("Float or dock")->trigger();
        QVERIFY(presets->isFloating());
        entry("Float or dock")->trigger();
        QVERIFY(!presets->isFloating());
    }

    void theMenusAreShort()
    {
        int entries = 0;
        const std::function<void(const QMenu&)> count = [&](const QMenu& menu) {
            for (const QAction* each : menu.actions()) {
                if (each->isSeparator() || !each->isVisible()) continue;
                ++entries;
                if (each->menu()) count(*each->menu());
            }
        };
        for (const QAction* top : window_->menuBar()->actions()) count(*top->menu());
        QVERIFY2(entries > 40 && entries <= 70, qPrintable(QString::number(entries)));
        QVERIFY(window_->findChildren<DockTitle*>().size() <= 7);
    }

    void keysOfMenusAreUniqueWithinEachMenu()
    {
        QStringList complaints;
        for (QAction* top : window_->menuBar()->actions())
            QVERIFY2(!mnemonic(top->text()).isNull(), qPrintable(top->text()));
        checkMenu("menu bar", window_->menuBar()->actions(), complaints);
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
    }

    void theMenuKeyAndShiftF10OpenTheMenuOfARow()
    {
        window_->choose(1);
        for (const auto& [key, modifiers] : {std::pair(Qt::Key_F10, Qt::ShiftModifier)}) {
            in<ValueSlider>("roughness")->setFocus();
            QTest::keyClick(QApplication::focusWidget(), key, modifiers);
            QTRY_VERIFY(QApplication::activePopupWidget());
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            QVERIFY(menu->actions().front()->text().startsWith("Reset to"));
            menu->close();
        }
    }

    void longTheHeadTurnsTheWipeMovesAndEnterVisits()
    {
        Viewport& viewport = window_->viewport();
        viewport.setFocus();
        const auto yaw = [this] {
            const render::Camera& camera = window_->history().sceneState().camera;
            return headingOf(camera.target - camera.eye).yaw;
        };
        const double before = yaw();
        QTest::keyPress(&viewport, Qt::Key_Right, Qt::ControlModifier);
        QTRY_VERIFY(yaw() > before + 0.1);
        QTest::keyRelease(&viewport, Qt::Key_Right);
        settle();
        const double after = yaw();
        QTest::keyPress(&viewport, Qt::Key_Left, Qt::ControlModifier);
        QTRY_VERIFY(yaw() < after - 0.05);
        QTest::keyRelease(&viewport, Qt::Key_Left, Qt::ControlModifier);
        viewport.visitor().jumpTo(gallery_->museum().initialSceneState().camera);
        QTest::keyClick(&viewport, Qt::Key_Return);
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::orbit);
        QCOMPARE(window_->chosen(), std::size_t{1});
        const auto far = [this] {
            const render::Camera& camera = window_->history().sceneState().camera;
            return glm::distance(camera.eye, camera.target);
        };
        const double was = far();
        QTest::keyClick(&viewport, Qt::Key_Plus);
        QVERIFY(std::abs(far() - 0.9 * was) < 1e-9);
        QTest::keyClick(&viewport, Qt::Key_Minus);
        QVERIFY(std::abs(far() - was) < 1e-9);
        window_->comparison().setToCurrent();
        CompareOverlay& overlay = window_->comparison().overlay();
        QTRY_VERIFY(overlay.isVisible());
        for (int i = 0; i < 3; ++i) QTest::keyClick(&viewport, Qt::Key_Comma);
        QVERIFY(std::abs(overlay.wipe() - 0.44) < 1e-9);
        QTest::keyClick(&viewport, Qt::Key_Period);
        QVERIFY(std::abs(overlay.wipe() - 0.46) < 1e-9);
    }
};

VITRINE_UI_TEST(KeyboardTest)

#include "keyboard_test.moc"
