#include "tests/ui/few_samples.h"
#include "tests/ui/open_window.h"
#include "tests/ui/preferences/fake_portal.h"
#include "tests/ui/ui_main.h"

#include "ui/compare/compare_bar.h"
#include "ui/kit/appearance.h"
#include "ui/kit/message_strip.h"
#include "ui/preferences/key_bindings.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/window/command_palette.h"
#include "ui/window/copies.h"
#include "ui/window/ledger_dock.h"
#include "ui/window/recent_files.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_preferences.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTreeWidget>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using namespace vitrine;
using namespace vitrine::ui;

/// Every preference, set in the dialog with keys and clicks, and what the window makes of it.
class PreferencesWindowTest : public test::OpenWindow {
    Q_OBJECT

    std::unique_ptr<test::PrivateBus> bus_;

    [[nodiscard]] const PreferenceValues& values() { return window_->preferences().values().values(); }
    PreferencesDialog* openDialog(const char* tab = "Window")
    {
        QApplication::setActiveWindow(window_.get());
        QTest::keyClick(window_.get(), Qt::Key_Comma, Qt::ControlModifier);
        auto* dialog = window_->findChild<PreferencesDialog*>();
        if (!dialog || !QTest::qWaitForWindowExposed(dialog, test::patience)) return nullptr;
        auto* tabs = dialog->findChild<QTabWidget*>();
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == QLatin1String(tab)) tabs->setCurrentIndex(i);
        return dialog;
    }
    template <typename T> [[nodiscard]] T* control(const char* name)
    {
        for (T* each : window_->findChild<PreferencesDialog*>()->template findChildren<T*>())
            if (each->accessibleName() == QLatin1String(name)) return each;
        return nullptr;
    }
    /// As the arrow keys and Enter do it.
    void choose(const char* name, const char* item)
    {
        auto* box = control<QComboBox>(name);
        QVERIFY2(box && box->findText(item) >= 0, item);
        box->setFocus();
        while (box->currentIndex() < box->findText(item)) QTest::keyClick(box, Qt::Key_Down);
        while (box->currentIndex() > box->findText(item)) QTest::keyClick(box, Qt::Key_Up);
    }
    void type(const char* name, int value)
    {
        auto* box = control<QSpinBox>(name);
        QVERIFY2(box, name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QString::number(value));
        QTest::keyClick(box, Qt::Key_Return);
    }
    void reset(const char* name)
    {
        auto* dot = control<QAbstractButton>(name);
        QVERIFY2(dot && dot->isEnabled(), name);
        QTest::mouseClick(dot, Qt::LeftButton);
        QVERIFY(!dot->isEnabled());
    }
    /// How far dragging by so many pixels turns the visitor's look, radians: sideways and up.
    [[nodiscard]] glm::dvec2 turnOf(const QPoint& drag)
    {
        Viewport& viewport = window_->viewport();
        viewport.jumpTo({{1.35, 1.65, 10.2}, {1.35, 1.65, 0}, 0.96});
        const auto look = [this] {
            const render::Camera& camera = window_->history().sceneState().camera;
            return headingOf(camera.target - camera.eye);
        };
        const Heading before = look();
        const QPoint from(300, 200);
        QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
        QTest::mouseMove(&viewport, from + drag / 2);
        QTest::mouseMove(&viewport, from + drag);
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, from + drag);
        return {look().yaw - before.yaw, look().pitch - before.pitch};
    }
    [[nodiscard]] double zoomOf()
    {
        Viewport& viewport = window_->viewport();
        viewport.jumpTo({{0, 1.2, 6}, {0, 1, 0}, 0.96});
        const auto distance = [this] {
            const render::Camera& camera = window_->history().sceneState().camera;
            return glm::distance(camera.eye, camera.target);
        };
        const double before = distance();
        QWheelEvent turn(QPointF(200, 200), viewport.mapToGlobal(QPointF(200, 200)), {}, {0, 120}, {}, {},
                         Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport, &turn);
        return distance() / before;
    }
    [[nodiscard]] QTreeWidgetItem* command(const QString& name)
    {
        auto* list = window_->findChild<PreferencesDialog*>()->findChild<QTreeWidget*>();
        for (int i = 0; i < list->topLevelItemCount(); ++i)
            if (list->topLevelItem(i)->text(0) == name) return list->topLevelItem(i);
        return nullptr;
    }
    void pressInKeyEdit(int key, Qt::KeyboardModifiers modifiers)
    {
        auto* edit = window_->findChild<PreferencesDialog*>()->findChild<QKeySequenceEdit*>();
        edit->setFocus();
        QTest::keyClick(edit, static_cast<Qt::Key>(key), modifiers);
    }
    [[nodiscard]] QPushButton* button(const char* text)
    {
        for (QPushButton* each : window_->findChild<PreferencesDialog*>()->findChildren<QPushButton*>())
            if (each->text() == QLatin1String(text)) return each;
        return nullptr;
    }
    [[nodiscard]] QStringList said() { return window_->findChild<MessageStrip*>()->texts(); }
    void lookLikeNothingWasChosen()
    {
        applyAppearance(*qApp, {}, {});
        applyTheme(*qApp, darkTheme());
    }

private slots:
    void initTestCase()
    {
        // Before anyone asks for the session's bus.
        bus_ = std::make_unique<test::PrivateBus>();
        qputenv("DBUS_SESSION_BUS_ADDRESS", bus_->address().toLocal8Bit());
        prepare();
    }
    void init() { start(); }
    void cleanup()
    {
        finish();
        lookLikeNothingWasChosen();
    }

    void theThemeIsAppliedAtOnceKeptAndReset()
    {
        QVERIFY(openDialog());
        choose("Theme", "High contrast");
        QVERIFY(theme().highContrast);
        QCOMPARE(QApplication::palette().color(QPalette::WindowText), theme().text);
        QCOMPARE(Preferences::saved().theme, ThemeChoice::highContrast);
        QVERIFY(action("High contrast")->isChecked());  // The View menu says so, too.
        closeWindow();
        openWindow();
        QCOMPARE(values().theme, ThemeChoice::highContrast);
        QVERIFY(openDialog());
        reset("Reset Theme");
        QVERIFY(!theme().highContrast);
        QCOMPARE(Preferences::saved().theme, ThemeChoice::desktop);
    }

    void typeOfAnotherSizeIsEverywhereAtOnce()
    {
        PreferencesDialog* dialog = openDialog();
        QVERIFY(dialog);
        window_->choose(1);
        const double points = QApplication::font().pointSizeF();
        const int row = window_->panel().row("roughness")->height();
        const int label = dialog->findChild<QLabel*>()->fontMetrics().height();
        type("Size of type", 200);
        QCOMPARE(QApplication::font().pointSizeF(), 2 * points);
        QTRY_VERIFY(window_->panel().row("roughness")->height() >= 1.7 * row);
        QVERIFY(dialog->findChild<QLabel*>()->fontMetrics().height() >= 1.7 * label);
        QCOMPARE(Preferences::saved().typeSize, 200);
        reset("Reset Size of type");
        QCOMPARE(QApplication::font().pointSizeF(), points);
        QTRY_COMPARE(window_->panel().row("roughness")->height(), row);
    }

    void thePointerTurnsAsFastAndTheWayRoundThatIsPreferred()
    {
        QVERIFY(openDialog("Picture and mouse"));
        const glm::dvec2 usual = turnOf({60, 40});
        QVERIFY(usual.x != 0 && usual.y < 0);
        type("Speed of looking", 200);
        const glm::dvec2 fast = turnOf({60, 40});
        QVERIFY2(std::abs(fast.x / usual.x - 2) < 1e-6, qPrintable(QString::number(fast.x / usual.x)));
        auto* inverted = control<QCheckBox>("Dragging down looks up");
        QTest::mouseClick(inverted, Qt::LeftButton, {}, QPoint(8, inverted->height() / 2));
        QVERIFY(values().invertedLook);
        const glm::dvec2 other = turnOf({60, 40});
        QCOMPARE(other.x, fast.x);
        QVERIFY(std::abs(other.y + fast.y) < 1e-9);
        reset("Reset Speed of looking");
        reset("Reset Dragging down looks up");
        QVERIFY(std::abs(turnOf({60, 40}).y - usual.y) < 1e-9);
    }

    void theWheelGoesAsFarAsIsPreferred()
    {
        QVERIFY(openDialog("Picture and mouse"));
        const double usual = zoomOf();
        QVERIFY(usual < 1);
        type("Speed of the wheel", 300);
        QVERIFY2(std::abs(zoomOf() - std::pow(usual, 3)) < 1e-9, qPrintable(QString::number(zoomOf())));
    }

    void fewerSamplesAreDrawnAndStatusLedgerAndCommandLineSaySo()
    {
        test::takeFewSamples(*window_, 8);
        settle();
        QVERIFY(openDialog("Picture and mouse"));
        gallery_->forgetRequests();
        choose("Samples at rest", "2 at most");
        QCOMPARE(values().mostSamples, 2);
        QTRY_VERIFY(window_->viewport().schedule().still() && window_->viewport().schedule().samples() == 2);
        for (const FrameRequest& request : gallery_->requests()) QVERIFY(request.samples <= 2);
        const QString reason = window_->viewport().reason();
        QVERIFY2(reason.startsWith("still: refined 2 of 2") && reason.contains("the hall says 8") &&
                     reason.contains("no more than 2"),
                 qPrintable(reason));
        action("Ledger")->trigger();
        window_->viewport().sceneStateChanged();
        settle();
        QTRY_COMPARE(window_->docks().ledger().reasonText(), reason);
        QVERIFY2(commandLineOf(*window_).contains("--samples 2") || commandLineOf(*window_).contains("samples=2"),
                 qPrintable(commandLineOf(*window_)));
        // What the hall says stays what it says.
        QCOMPARE(
            window_->history().sceneState().values[0][*window_->museum().subject(0).parameters().find("supersamples")],
            Value(8.0));
        choose("Samples at rest", "As many as the hall says");
        QTRY_VERIFY(window_->viewport().schedule().still() && window_->viewport().schedule().samples() == 8);
        QVERIFY(!window_->viewport().reason().contains("preferences"));
    }

    void aPictureInMotionIsNeverCoarserThanIsPreferred()
    {
        QVERIFY(openDialog("Picture and mouse"));
        choose("Resolution in motion", "50 % at least");
        gallery_->beforeDrawing = [](const FrameRequest&, const auto&) { QThread::msleep(300); };  // A slow machine.
        gallery_->forgetRequests();
        Viewport& viewport = window_->viewport();
        viewport.setFocus();
        QTest::keyPress(&viewport, Qt::Key_A);
        QTRY_COMPARE(viewport.schedule().scaleWhileMoving(), 0.5);
        QTRY_VERIFY(gallery_->requests().size() >= 6);
        QTest::keyRelease(&viewport, Qt::Key_A);
        QCOMPARE(viewport.schedule().scaleWhileMoving(), 0.5);
        for (const FrameRequest& request : gallery_->requests())
            QVERIFY(request.raster.size.x >= viewport.width() / 2 - 1);
        settle();
        gallery_->beforeDrawing = {};
    }

    void reducedMotionCutsWhereTheCameraWouldGlideAndHoldsTheClock()
    {
        gallery_->exhibit().moves = true;
        QVERIFY(openDialog());
        choose("Motion", "Reduced");
        QVERIFY(reducedMotion() && !window_->isAnimated());
        QVERIFY(action("Pause clock")->isChecked());
        const double stood = window_->viewport().time();
        gallery_->forgetRequests();
        window_->visit(1);
        QCOMPARE(window_->viewport().mode(), CameraControl::Mode::orbit);  // At once.
        settle();
        QCOMPARE(window_->viewport().time(), stood);
        const std::vector<FrameRequest> drawn = gallery_->requests();
        QVERIFY(!drawn.empty());
        for (const FrameRequest& request : drawn) QVERIFY(request.camera == drawn.back().camera);
        QVERIFY(drawn.front().cut);  // Nothing of what was seen before is carried along.
        QTest::keyClick(&window_->viewport(), Qt::Key_Escape);
        QCOMPARE(window_->viewport().mode(), CameraControl::Mode::walk);
        window_->viewport().goBack();
        QCOMPARE(window_->viewport().mode(), CameraControl::Mode::orbit);
        // Whoever presses a button wants to see what it does.
        window_->viewport().press();
        QVERIFY(!action("Pause clock")->isChecked());
        QTRY_VERIFY(window_->viewport().time() > stood);
        gallery_->exhibit().moves = false;
        choose("Motion", "Full");
        QVERIFY(!reducedMotion() && window_->isAnimated());
        window_->visit(0);
        QCOMPARE(window_->viewport().mode(), CameraControl::Mode::glide);
    }

    void aClockThatTheVisitorStoppedIsNotStartedByFullMotion()
    {
        QVERIFY(openDialog());
        choose("Motion", "Reduced");
        QVERIFY(action("Pause clock")->isChecked());
        choose("Motion", "Full");
        QVERIFY(!action("Pause clock")->isChecked());  // It stood for that reason alone.
        action("Pause clock")->trigger();
        choose("Motion", "Reduced");
        choose("Motion", "Full");
        QVERIFY(action("Pause clock")->isChecked());
    }

    void theDesktopsWishesAreFollowedWhileTheWindowIsOpen()
    {
        if (bus_->address().isEmpty()) QSKIP("There is no dbus-daemon here.");
        closeWindow();
        test::FakePortal desktop(QDBusConnection::connectToBus(bus_->address(), "desktop"));
        desktop.settings[test::FakePortal::appearance] = {{"color-scheme", 2U}, {"contrast", 1U}};
        openWindow();
        QTRY_COMPARE(theme(), highContrastTheme(false));
        QVERIFY(!reducedMotion());
        desktop.change(test::FakePortal::gnome, "enable-animations", false);
        QTRY_VERIFY(reducedMotion());
        desktop.change(test::FakePortal::appearance, "color-scheme", 1U);
        QTRY_COMPARE(theme(), highContrastTheme(true));
        desktop.change(test::FakePortal::appearance, "contrast", 0U);
        QTRY_COMPARE(theme(), darkTheme());
        // The visitor's own choice goes before it.
        QVERIFY(openDialog());
        choose("Motion", "Full");
        QVERIFY(!reducedMotion());
        desktop.change(test::FakePortal::gnome, "enable-animations", true);
    }

    void aCommandGetsAnotherShortcutThatWorksIsShownEverywhereAndKept()
    {
        QVERIFY(openDialog("Keys"));
        auto* find = control<QLineEdit>("Find a command");
        QTest::keyClicks(find, "commands");
        QVERIFY(command("Quit")->isHidden());
        QTreeWidgetItem* palette = command("Commands");
        QVERIFY(palette && !palette->isHidden());
        palette->treeWidget()->setCurrentItem(palette);
        pressInKeyEdit(Qt::Key_K, Qt::ControlModifier);
        QTRY_COMPARE(action("Commands…")->shortcut(), QKeySequence("Ctrl+K"));
        QCOMPARE(command("Commands")->text(1), QString("Ctrl+K"));
        window_->findChild<PreferencesDialog*>()->close();
        closeWindow();
        openWindow();
        QApplication::setActiveWindow(window_.get());
        QTest::keyClick(window_.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!window_->findChild<CommandPalette*>());
        QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(window_->findChild<CommandPalette*>());
        window_->findChild<CommandPalette*>()->close();
        window_->openShortcutSheet();
        const auto* sheet = window_->findChild<ShortcutSheet*>()->findChild<QTreeWidget*>();
        QVERIFY(!sheet->findItems("Ctrl+K", Qt::MatchExactly).isEmpty());
        QVERIFY(sheet->findItems("Ctrl+Shift+P", Qt::MatchExactly).isEmpty());
    }

    void tooltipsOfButtonsNameTheNewShortcut()
    {
        QVERIFY(openDialog("Keys"));
        QTreeWidgetItem* wipe = command("Wipe");
        wipe->treeWidget()->setCurrentItem(wipe);
        pressInKeyEdit(Qt::Key_F7, {});
        QTRY_COMPARE(action("Wipe")->shortcut(), QKeySequence("F7"));
        bool shown = false;
        for (const QToolButton* each : window_->findChild<CompareBar*>()->findChildren<QToolButton*>())
            shown = shown || each->toolTip().endsWith("(F7)");
        QVERIFY(shown);
    }

    void aShortcutThatSomebodyHasIsTakenOnlyWhenOneSaysSo()
    {
        QVERIFY(openDialog("Keys"));
        QTreeWidgetItem* record = command("Record");
        record->treeWidget()->setCurrentItem(record);
        const auto press = [this] {
            pressInKeyEdit(Qt::Key_W, Qt::ControlModifier);
            QTRY_VERIFY(button("Take it")->isVisible());
        };
        press();
        bool said = false;
        for (const QLabel* label : window_->findChild<PreferencesDialog*>()->findChildren<QLabel*>())
            said = said || label->text() == "Ctrl+W belongs to “Wipe”. Take it from there?";
        QVERIFY(said);
        QTest::mouseClick(button("Leave it"), Qt::LeftButton);
        QCOMPARE(action("Wipe")->shortcut(), QKeySequence("Ctrl+W"));
        QCOMPARE(action("Record…")->shortcut(), QKeySequence("Shift+F12"));
        press();
        QTest::keyClick(button("Take it"), Qt::Key_Space);
        QVERIFY(action("Wipe")->shortcut().isEmpty());
        QCOMPARE(action("Record…")->shortcut(), QKeySequence("Ctrl+W"));
        // Giving it back asks as well, and all at once can be given back.
        wipeIsReset();
        QTest::mouseClick(button("Reset all"), Qt::LeftButton);
        QCOMPARE(action("Wipe")->shortcut(), QKeySequence("Ctrl+W"));
        QCOMPARE(action("Record…")->shortcut(), QKeySequence("Shift+F12"));
        QVERIFY(values().keys.isEmpty());
    }

    void aPlainLetterIsRefusedWithAReason()
    {
        QVERIFY(openDialog("Keys"));
        QTreeWidgetItem* record = command("Record");
        record->treeWidget()->setCurrentItem(record);
        pressInKeyEdit(Qt::Key_W, {});
        const auto reason = [this] {
            for (const QLabel* label : window_->findChild<PreferencesDialog*>()->findChildren<QLabel*>())
                if (label->accessibleName() == "About the shortcut") return label->text();
            return QString();
        };
        QTRY_VERIFY(reason().startsWith("W alone is for typing and for walking."));
        QCOMPARE(action("Record…")->shortcut(), QKeySequence("Shift+F12"));
    }

    void everyCommandHasAnIdOfItsOwn()
    {
        QSet<QString> ids;
        QVERIFY(openDialog("Keys"));
        auto* list = window_->findChild<PreferencesDialog*>()->findChild<QTreeWidget*>();
        int commands = 0;
        for (QAction* each : window_->findChildren<QAction*>()) {
            if (each->objectName().isEmpty() || !window_->actions().contains(each)) continue;
            QVERIFY2(!ids.contains(each->objectName()), qPrintable(each->objectName()));
            ids << each->objectName();
            ++commands;
        }
        QVERIFY(commands > 60);
        QVERIFY(list->topLevelItemCount() >= commands);
        for (QAction* each : window_->actions()) QVERIFY2(!each->objectName().isEmpty(), qPrintable(each->text()));
        for (const char* id : {"open", "screenshot", "undo", "panel-ledger", "visit-sdf_morph", "set-bookmark-3",
                               "compare-wipe", "lesson-start"})
            QVERIFY2(ids.contains(id), id);
    }

    void asManyRecentFilesAreKeptAsArePreferredAndTheListIsCleared()
    {
        for (int i = 0; i < 6; ++i) {
            QFile file(home_->filePath(QString("scene%1.json").arg(i)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            addRecentFile(file.fileName());
        }
        QCOMPARE(recentFiles().size(), 6);
        QVERIFY(openDialog("Files"));
        type("Recent files", 2);
        QCOMPARE(recentFiles().size(), 2);
        QVERIFY(recentFiles().front().endsWith("scene5.json"));
        addRecentFile(home_->filePath("scene0.json"));
        QCOMPARE(recentFiles().size(), 2);
        QVERIFY(recentFiles().front().endsWith("scene0.json"));
        QMenu* menu = nullptr;
        for (QMenu* each : window_->findChildren<QMenu*>())
            if (each->title() == "Open &recent") menu = each;
        QVERIFY(menu);
        emit menu->aboutToShow();
        QCOMPARE(menu->actions().back()->text(), QString("&Clear the list"));
        menu->actions().back()->trigger();
        QVERIFY(recentFiles().isEmpty());
        addRecentFile(home_->filePath("scene1.json"));
        QTest::mouseClick(button("Clear the list now"), Qt::LeftButton);
        QVERIFY(recentFiles().isEmpty());
        type("Recent files", 0);
        addRecentFile(home_->filePath("scene1.json"));
        QVERIFY(recentFiles().isEmpty());
    }

    void damagedPreferencesAreSaidOnceInTheWindow()
    {
        closeWindow();
        const QString path = home_->filePath("vitrine/window.ini");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("theme=plaid\ntypeSize=9000\n[keys]\nquit=Nonsense+9\n");
        file.close();
        openWindow();
        QVERIFY(values() == PreferenceValues());
        const QStringList told = said().filter("window.ini");
        QCOMPARE(told.size(), 1);
        for (const char* name : {"theme", "typeSize", "keys/quit"}) QVERIFY2(told.front().contains(name), name);
    }

private:
    void wipeIsReset()
    {
        QTreeWidgetItem* wipe = command("Wipe");
        wipe->treeWidget()->setCurrentItem(wipe);
        QTest::mouseClick(button("Reset"), Qt::LeftButton);
        QVERIFY(button("Take it")->isVisible());
    }
};

VITRINE_TEST_MAIN(PreferencesWindowTest)
#include "preferences_window_test.moc"
