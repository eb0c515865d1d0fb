#include "tests/ui/preferences/open_preferences.h"
#include "tests/ui/ui_main.h"

#include "ui/compare/compare_bar.h"
#include "ui/window/search_dialog.h"
#include "ui/window/shortcut_sheet.h"

#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeWidget>

using namespace vitrine;
using namespace vitrine::ui;

/// Changed shortcuts of commands, entered in the dialog by pressing them.
class KeysWindowTest : public test::OpenPreferences {
    Q_OBJECT

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
    void wipeIsReset()
    {
        QTreeWidgetItem* wipe = command("Wipe");
        wipe->treeWidget()->setCurrentItem(wipe);
        QTest::mouseClick(button("Reset"), Qt::LeftButton);
        QVERIFY(button("Reassign it")->isVisible());
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup()
    {
        finish();
        lookLikeNothingWasChosen();
    }

    void longACommandGetsAnotherShortcutThatWorksIsShownEverywhereAndKept()
    {
        QVERIFY(openDialog("Keys"));
        auto* find = control<QLineEdit>("Find a command");
        QTest::keyClicks(find, "search");
        QVERIFY(command("Quit")->isHidden());
        QTreeWidgetItem* search = command("Search");
        QVERIFY(search && !search->isHidden());
        search->treeWidget()->setCurrentItem(search);
        pressInKeyEdit(Qt::Key_J, Qt::ControlModifier);
        QTRY_COMPARE(action("Search…")->shortcut(), QKeySequence("Ctrl+J"));
        QCOMPARE(command("Search")->text(1), QString("Ctrl+J"));
        window_->findChild<PreferencesDialog*>()->close();
        closeWindow();
        openWindow();
        QApplication::setActiveWindow(window_.get());
        QTest::keyClick(window_.get(), Qt::Key_F, Qt::ControlModifier);
        QVERIFY(!window_->findChild<SearchDialog*>());
        QTest::keyClick(window_.get(), Qt::Key_J, Qt::ControlModifier);
        QTRY_VERIFY(window_->findChild<SearchDialog*>());
        window_->findChild<SearchDialog*>()->close();
        action("Keyboard, mouse and gamepad")->trigger();
        const auto* sheet = window_->findChild<ShortcutSheet*>()->findChild<QTreeWidget*>();
        QVERIFY(!sheet->findItems("Ctrl+J", Qt::MatchExactly).isEmpty());
        QVERIFY(sheet->findItems("Ctrl+F, Ctrl+K", Qt::MatchExactly).isEmpty());
    }

    void longTooltipsOfButtonsNameTheNewShortcut()
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

    void longAShortcutThatSomebodyHasIsTakenOnlyWhenOneSaysSo()
    {
        QVERIFY(openDialog("Keys"));
        QTreeWidgetItem* record = command("Record");
        record->treeWidget()->setCurrentItem(record);
        const auto press = [this] {
            pressInKeyEdit(Qt::Key_W, Qt::ControlModifier);
            QTRY_VERIFY(button("Reassign it")->isVisible());
        };
        press();
        bool said = false;
        for (const QLabel* label : window_->findChild<PreferencesDialog*>()->findChildren<QLabel*>())
            said = said || label->text() == "Ctrl+W is already used by “Wipe”. Reassign it?";
        QVERIFY(said);
        QTest::mouseClick(button("Leave it"), Qt::LeftButton);
        QCOMPARE(action("Wipe")->shortcut(), QKeySequence("Ctrl+W"));
        QCOMPARE(action("Record…")->shortcut(), QKeySequence("Shift+F12"));
        press();
        QTest::keyClick(button("Reassign it"), Qt::Key_Space);
        QVERIFY(action("Wipe")->shortcut().isEmpty());
        QCOMPARE(action("Record…")->shortcut(), QKeySequence("Ctrl+W"));
        // Restoring a shortcut also asks, and all can be restored at once.
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
        QTRY_VERIFY(reason().startsWith("W alone is used for typing and walking."));
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
        for (const char* id : {"open", "screenshot", "undo", "panel-frame-report", "visit-sdf_morph", "set-bookmark-3",
                               "compare-wipe", "lesson-start"})
            QVERIFY2(ids.contains(id),
                     qPrintable(QString("%1 is not among %2").arg(id, QStringList(ids.values()).join(" "))));
    }
};

VITRINE_ADD_TEST(KeysWindowTest, &test::runWithBus<KeysWindowTest>)

#include "keys_window_test.moc"
