// Groups of one kind in the real window: edited together and copied to each other; each edit is one undo step.

#include "tests/support/balls.h"
#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/parameters/motion_dialog.h"

#include <QClipboard>
#include <QMenu>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::parameterOf;

class GroupEditsTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t balls = 2;
    test::BallsExhibit* exhibit_ = nullptr;

    std::unique_ptr<Exhibit> anotherExhibit() override
    {
        auto exhibit = std::make_unique<test::BallsExhibit>();
        exhibit_ = exhibit.get();
        return exhibit;
    }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[balls]; }
    [[nodiscard]] double number(const char* row)
    {
        return std::get<double>(parameterOf(values(), row).value_or(Value(-1.0)));
    }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    [[nodiscard]] QAbstractButton* heading(const char* title)
    {
        for (auto* button : window_->panel().findChildren<QAbstractButton*>())
            if (button->text() == QString::fromUtf8(title)) return button;
        return nullptr;
    }
    /// Returns the menu of a widget, which `choose` closes.
    [[nodiscard]] QMenu* menuOf(QWidget* widget)
    {
        QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(4, 4), widget->mapToGlobal(QPoint(4, 4)));
        QApplication::sendEvent(widget, &event);
        return window_->panel().findChild<QMenu*>();
    }
    [[nodiscard]] static QAction* entry(QMenu* menu, const char* text)
    {
        for (QAction* each : menu->actions())
            if (each->text() == QString::fromUtf8(text)) return each;
        return nullptr;
    }
    void choose(QWidget* widget, const char* text)
    {
        QMenu* menu = menuOf(widget);
        QVERIFY(menu);
        QAction* found = entry(menu, text);
        QVERIFY2(found && found->isEnabled(), text);
        found->trigger();
        delete menu;
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        const std::string file = home_->filePath("three.json").toStdString();
        test::writeBalls(file, {{"red", 0.5}, {"blue", 2}, {"green", 3}});
        window_->choose(balls);
        window_->history().set(balls, *exhibit_->parameters().find("scene"), file, newGesture());
        QTRY_VERIFY(window_->panel().row("greenRadius"));
    }
    void cleanup() { finish(); }

    void aChangeToOneRowChangesThoseOfAllInOneStep()
    {
        QVERIFY(heading("Ball red")->accessibleDescription().isEmpty());
        choose(heading("Ball red"), "Edit all 3 together");
        for (const char* title : {"Ball red", "Ball blue", "Ball green"})
            QVERIFY2(heading(title)->accessibleDescription().contains("all 3 groups"), title);
        const int before = stack().count();
        drag("blueRadius", 80);
        QVERIFY(number("blueRadius") != 2);
        QCOMPARE(number("redRadius"), number("blueRadius"));
        QCOMPARE(number("greenRadius"), number("blueRadius"));
        QCOMPARE(number("redRings"), 8.0);
        QCOMPARE(number("spin"), 1.0);
        QCOMPARE(stack().count(), before + 1);
        stack().undo();
        QCOMPARE(number("redRadius"), 0.5);
        QCOMPARE(number("blueRadius"), 2.0);
        QCOMPARE(number("greenRadius"), 3.0);
        choose(heading("Ball blue"), "Edit all 3 together");
        QVERIFY(heading("Ball red")->accessibleDescription().isEmpty());
        drag("blueRadius", 80);
        QCOMPARE(number("redRadius"), 0.5);
    }

    void resetPasteAndMotionsGoToAllOfThem()
    {
        choose(heading("Ball red"), "Edit all 3 together");
        QApplication::clipboard()->setText("7");
        choose(window_->panel().row("redRadius"), "Paste");
        for (const char* row : {"redRadius", "blueRadius", "greenRadius"}) QCOMPARE(number(row), 7.0);
        window_->panel().row("greenRadius")->reset();
        QCOMPARE(number("redRadius"), 0.5);
        QCOMPARE(number("blueRadius"), 2.0);
        QCOMPARE(number("greenRadius"), 3.0);
        stack().undo();
        QCOMPARE(number("redRadius"), 7.0);

        const int before = stack().index();
        choose(window_->panel().row("redRadius"), "Animate…");
        auto* dialog = window_->panel().findChild<MotionDialog*>();
        QVERIFY(dialog);
        dialog->accept();
        const auto motion = [&](const char* row) { return values().motion(*values().table().find(row)); };
        for (const char* row : {"redRadius", "blueRadius", "greenRadius"}) QVERIFY2(motion(row), row);
        QVERIFY(*motion("blueRadius") == *motion("redRadius"));
        QCOMPARE(stack().index(), before + 1);
        choose(window_->panel().row("blueRadius"), "Stop here");
        for (const char* row : {"redRadius", "blueRadius", "greenRadius"}) QVERIFY2(!motion(row), row);
        QCOMPARE(stack().index(), before + 2);
    }

    void aGroupIsCopiedToTheOthersAndFromOne()
    {
        drag("greenRadius", 120);
        const double green = number("greenRadius");
        choose(heading("Ball red"), "Copy from Ball green");
        QCOMPARE(number("redRadius"), green);
        QCOMPARE(number("blueRadius"), 2.0);
        QMenu* menu = menuOf(heading("Ball red"));
        QVERIFY2(!entry(menu, "Copy from Ball green")->isEnabled(), "it is as that one already");
        QVERIFY(entry(menu, "Copy from Ball blue")->isEnabled());
        delete menu;
        const int before = stack().count();
        choose(heading("Ball blue"), "Copy to the others");
        for (const char* row : {"redRadius", "blueRadius", "greenRadius"}) QCOMPARE(number(row), 2.0);
        QCOMPARE(stack().count(), before + 1);
        stack().undo();
        QCOMPARE(number("greenRadius"), green);
    }

    void theDotsOfAHeadingOpenItsMenuAndDoNotFoldIt()
    {
        QAbstractButton* red = heading("Ball red");
        QTest::mouseClick(red, Qt::LeftButton, {}, QPoint(red->width() - 33, red->height() / 2));
        auto* menu = window_->panel().findChild<QMenu*>();
        QVERIFY(menu);
        QVERIFY(red->isChecked());
        QVERIFY(entry(menu, "Edit all 3 together"));
        delete menu;
        QTest::mouseClick(red, Qt::LeftButton, {}, QPoint(30, red->height() / 2));
        QVERIFY2(!red->isChecked(), "elsewhere a click folds it");
        window_->choose(1);
        menu = menuOf(heading("Surface"));
        QVERIFY(menu);
        QVERIFY2(!entry(menu, "Copy to the others"), "it is the only one of its kind");
        delete menu;
    }
};

VITRINE_WINDOW_TEST(GroupEditsTest)
#include "group_edits_test.moc"
