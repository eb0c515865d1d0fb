// Nine variations in the real window: drawn in the background, picked, varied further, with locked parameters kept.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/explore/explore_dock.h"
#include "ui/explore/variation_grid.h"
#include "ui/explore/variations.h"
#include "ui/parameters/panel_choices.h"
#include "ui/presets/preset_controller.h"
#include "ui/window/window_docks.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>

#include <semaphore>

using namespace vitrine;
using namespace vitrine::ui;

class VariationsTest : public test::OpenWindow {
    Q_OBJECT

    std::counting_semaphore<> may_{0};  // Permits to draw small pictures, in tests that delay them.

    [[nodiscard]] ExploreDock& dock() { return window_->docks().explore(); }
    [[nodiscard]] Variations& nine() { return dock().variations(); }
    [[nodiscard]] VariationGrid& grid() { return dock().grid(); }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[1]; }
    [[nodiscard]] double roughnessOf(int i) { return nine().values(i)[gallery_->table().roughness]; }
    void explore()
    {
        window_->choose(1);
        settle();
        action("Explore")->trigger();
        QTRY_VERIFY(grid().isVisible());
        drawn();
    }
    void drawn() { QTRY_COMPARE(nine().finished(), Variations::count); }
    void click(int i)
    {
        const QRect cell = grid().visualItemRect(grid().item(i / 3, i % 3));
        QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, cell.center());
    }
    void press(const char* text)
    {
        for (auto* button : dock().findChildren<QPushButton*>())
            if (button->text().remove('&') == QString::fromUtf8(text)) QTest::mouseClick(button, Qt::LeftButton);
    }
    [[nodiscard]] bool says(const char* words)
    {
        for (const auto* label : dock().findChildren<QLabel*>())
            if (label->text().contains(QString::fromUtf8(words))) return true;
        return false;
    }
    /// Chooses an entry of the menu of a group.
    void fromHeadingMenu(const char* heading, const char* entry)
    {
        window_->docks().showParameters();
        for (auto* button : window_->panel().findChildren<QAbstractButton*>())
            if (button->text() == QString::fromUtf8(heading)) {
                QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(30, 10),
                                        button->mapToGlobal(QPoint(30, 10)));
                QApplication::sendEvent(button, &event);
            }
        auto* menu = window_->panel().findChild<QMenu*>();
        QVERIFY(menu);
        QAction* found = nullptr;
        for (QAction* each : menu->actions())
            if (each->text() == QString::fromUtf8(entry)) found = each;
        QVERIFY2(found, entry);
        found->trigger();
        delete menu;
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup()
    {
        may_.release(1000);  // Needed if a test ended early.
        finish();
    }

    void theNineAreDrawnOnTheRenderThreadAndEachShowsItsLook()
    {
        QCOMPARE(gallery_->smallDrawn.load(), 0);
        const SceneState before = window_->history().sceneState();
        explore();
        for (int i = 0; i < Variations::count; ++i) {
            QVERIFY(!(nine().values(i) == values()));
            const QColor shown = nine().image(i).pixelColor(3, 3);
            QVERIFY2(std::abs(shown.red() - 255 * roughnessOf(i)) <= 1, qPrintable(QString::number(i)));
            const QRect cell = grid().visualItemRect(grid().item(i / 3, i % 3));
            const QColor seen = grid().viewport()->grab().toImage().pixelColor(cell.center());
            QVERIFY2(std::abs(seen.red() - shown.red()) <= 1, "and so does its cell");
        }
        QCOMPARE(gallery_->strangers.load(), 0);
        QVERIFY(window_->history().sceneState().values == before.values);
        const double aspect = 1.0 * nine().image(0).width() / nine().image(0).height();
        const QSize view = window_->viewport().pictures().shown().image().size();
        QVERIFY2(std::abs(aspect - 1.0 * view.width() / view.height()) < 0.02, "framed as the viewport's picture");
    }

    void longWhileTheyAreDrawnTheVisitorGoesOn()
    {
        while (may_.try_acquire()) continue;
        gallery_->beforeSmall = [this] { may_.acquire(); };
        window_->choose(1);
        action("Explore")->trigger();
        QTRY_COMPARE(gallery_->smallDrawn.load(), 1);
        QStringList shown;
        for (const QLabel* label : window_->docks().explore().findChildren<QLabel*>()) shown << label->text();
        QVERIFY2(shown.contains("Variation 1 of 9 is being drawn."), qPrintable(shown.join('|')));
        window_->history().set(1, gallery_->table().roughness.row, 0.75, newGesture());
        // Drawing of the next variation may have begun before the visitor's picture was ordered, which then waits for
        // it.
        const auto drawnBetween = [this] { return std::abs(red() - 191) <= 1; };
        for (int i = 0; i < 4 && !drawnBetween(); ++i) {
            may_.release();
            (void)QTest::qWaitFor(drawnBetween, 2000);
        }
        QVERIFY2(drawnBetween(), "its picture is drawn between two of theirs");
        QVERIFY(nine().finished() < Variations::count);
        may_.release(1000);
        drawn();
        QVERIFY2(nine().stale(), "they vary the look of before");
    }

    void nothingIsDrawnWhileNobodyLooks()
    {
        explore();
        const int before = gallery_->smallDrawn;
        action("Explore")->trigger();
        QVERIFY(!grid().isVisible());
        QTRY_VERIFY(gallery_->smallForgotten > 0);
        nine().drawAnew();
        QTest::qWait(100);
        QCOMPARE(gallery_->smallDrawn.load(), before);
        QCOMPARE(nine().finished(), 0);
        action("Explore")->trigger();
        drawn();
        QVERIFY2(gallery_->smallDrawn > before, "a control: what was missing is drawn once someone looks");
    }

    void aClickMakesOneTheLookAndOneUndoBringsTheFormerBack()
    {
        explore();
        const SceneState before = window_->history().sceneState();
        const int steps = stack().count();
        click(4);
        QVERIFY(values() == nine().values(4));
        QVERIFY(window_->history().sceneState().camera == before.camera);
        QVERIFY(window_->history().sceneState().values[hallIndex] == before.values[hallIndex]);
        QCOMPARE(stack().count(), steps + 1);
        QVERIFY(nine().onShow() == 4);
        QVERIFY(!nine().stale());
        QTRY_VERIFY(says("Variation 5 is shown."));
        QCOMPARE(grid().item(1, 1)->data(Qt::AccessibleTextRole).toString(), QString("Variation 5, seed 5, shown"));
        window_->presetController().saveUnder("Found");
        QCOMPARE(rowsNamed("Found").size(), 1);
        stack().undo();
        QVERIFY(values() == before.values[1]);
        QVERIFY2(!nine().stale(), "they vary this one");
    }

    void arrowsGoBetweenThemAndEnterPicks()
    {
        explore();
        window_->activateWindow();
        QTRY_VERIFY(window_->isActiveWindow());
        grid().setFocus();
        QTest::keyClick(&grid(), Qt::Key_Right);
        QTest::keyClick(&grid(), Qt::Key_Down);
        QTest::keyClick(&grid(), Qt::Key_Down);
        QCOMPARE(grid().current(), 7);
        QTest::keyClick(&grid(), Qt::Key_Return);
        QVERIFY(values() == nine().values(7));
        QTest::keyClick(&grid(), Qt::Key_Tab);
        QVERIFY2(!grid().hasFocus(), "Tab leaves them");
    }

    void goingOnDrawsTheNextNineAroundTheMarkedOne()
    {
        explore();
        const int steps = stack().count();
        grid().setCurrentCell(0, 2);
        const ParameterValues chosen = nine().values(2), former = nine().values(0);
        press("More like this");
        QVERIFY(values() == chosen);
        QCOMPARE(stack().count(), steps + 1);
        QCOMPARE(nine().number(), 2);
        QCOMPARE(dock().findChild<QSpinBox*>()->value(), 2);
        QCOMPARE(nine().seedOf(0), 10ULL);
        drawn();
        QVERIFY(!(nine().values(0) == former));
        QVERIFY(!nine().stale());
    }

    void aChangedLookMakesThemOldAndTheyAreDrawnAnewWhenAsked()
    {
        explore();
        const int before = gallery_->smallDrawn;
        window_->history().set(1, gallery_->table().roughness.row, 0.125, newGesture());
        QVERIFY(nine().stale());
        QTRY_VERIFY(says("of earlier settings or locks"));
        QTest::qWait(50);
        QCOMPARE(gallery_->smallDrawn.load(), before);
        press("Draw anew");
        QVERIFY(!nine().stale());
        drawn();
        QVERIFY(gallery_->smallDrawn > before);
        QVERIFY(!says("of earlier settings or locks"));
    }

    void whatIsLockedStaysAsItIs()
    {
        explore();
        fromHeadingMenu("Surface", "Lock the group");
        QVERIFY(nine().stale());
        nine().drawAnew();
        bool others = false;
        for (int i = 0; i < Variations::count; ++i) {
            QCOMPARE(roughnessOf(i), roughness());
            QVERIFY(nine().values(i).row(gallery_->table().base.row) == values().row(gallery_->table().base.row));
            others = others ||
                     !(nine().values(i).row(gallery_->table().tilt.row) == values().row(gallery_->table().tilt.row));
        }
        QVERIFY2(others, "a control: rows of other groups vary");
        QVERIFY(window_->panel().choices().list(PanelChoice::locked).contains("sdf_morph/roughness"));
        fromHeadingMenu("Surface", "Unlock the group");
        QVERIFY(window_->panel().choices().list(PanelChoice::locked).isEmpty());
    }

    void seedAndStrengthSayWhichAndHowFar()
    {
        explore();
        const ParameterValues first = nine().values(0);
        auto* seed = dock().findChild<QSpinBox*>();
        QTest::keyClick(seed, Qt::Key_Up);
        QVERIFY(!(nine().values(0) == first));
        QTest::keyClick(seed, Qt::Key_Down);
        QVERIFY2(nine().values(0) == first, "the same seed, the same again");
        auto* strength = dock().findChild<ValueSlider*>();
        QTest::keyClick(strength, Qt::Key_Home);
        QCOMPARE(nine().strength(), 0.0);
        for (int i = 0; i < Variations::count; ++i) QVERIFY(nine().values(i) == values());
        QTest::keyClick(strength, Qt::Key_End);
        QCOMPARE(nine().strength(), 1.0);
        QVERIFY(!(nine().values(0) == values()));
        QVERIFY(!stack().canUndo() || !stack().undoText().contains("variation"));
    }
};

VITRINE_WINDOW_TEST(VariationsTest)
#include "variations_test.moc"
