#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/framework/files/preset.h"
#include "ui/parameters/motion_dialog.h"
#include "ui/parameters/number_field.h"
#include "ui/window/clock_bar.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

using namespace vitrine;
using namespace vitrine::ui;

/// Animating parameters by their menu and dialog.
class MotionWindowTest : public test::OpenWindow {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        mostSamples_ = asTheHallRequests;
        prepare();
    }
    void init()
    {
        start();
        window_->choose(1);
        settle();
    }
    void cleanup() { finish(); }

    void longAParameterMovesUntilItIsHeldAndStopsWhereItIs()
    {
        const int steps = window_->history().stack().count();
        const double before = roughness();
        auto* dialog = animate();
        QVERIFY(dialog);
        QVERIFY(motion());
        QVERIFY(row()->differs());
        const long long drawn = window_->viewport().pictures().shown().pictures();
        QTRY_VERIFY(window_->viewport().pictures().shown().pictures() > drawn + 3);
        const double shown = in<NumberField>("roughness")->value();
        QTRY_VERIFY(in<NumberField>("roughness")->value() != shown);
        QCOMPARE(roughness(), before);
        dialog->accept();
        QCOMPARE(window_->history().stack().count(), steps + 1);
        choose("Hold the motion");
        QVERIFY(motion()->heldAt);
        settle();
        const long long held = window_->viewport().pictures().shown().pictures();
        const double heldValue = in<NumberField>("roughness")->value();
        QTest::qWait(400);
        QCOMPARE(window_->viewport().pictures().shown().pictures(), held);
        choose("Stop here");
        QVERIFY(!motion());
        QVERIFY(std::abs(roughness() - heldValue) < 1e-6);
        while (window_->history().stack().canUndo()) window_->history().stack().undo();
        QVERIFY(!motion());
        QCOMPARE(roughness(), before);
    }

    void theDialogShowsWhatItsKindGoesByAndIsOneStepAndCancels()
    {
        const int steps = window_->history().stack().count();
        auto* dialog = animate();
        auto* kinds = dialog->row("kind")->findChild<QComboBox*>();
        QVERIFY(dialog->row("period") && dialog->row("phase"));
        QVERIFY(!dialog->row("steps") && !dialog->row("nearest"));
        choose(*kinds, static_cast<int>(MotionKind::steps));
        QCOMPARE(motion()->kind, MotionKind::steps);
        QVERIFY(dialog->row("steps"));
        choose(*kinds, static_cast<int>(MotionKind::distance));
        QVERIFY(dialog->row("nearest") && dialog->row("farthest") && !dialog->row("period"));
        QCOMPARE(window_->history().stack().count(), steps + 1);
        dialog->reject();
        QVERIFY(!motion());
        dialog = animate();
        window_->history().stack().undo();
        QTRY_VERIFY(!window_->findChild<MotionDialog*>());
    }

    void whoSetsItByHandStopsIt()
    {
        animate()->accept();
        QVERIFY(motion());
        dragRoughness(30);
        QVERIFY(!motion());
        window_->history().stack().undo();
        QVERIFY(motion());
        row()->reset();
        QVERIFY(!motion());
        QVERIFY(!row()->differs());
    }

    void presetsKeepIt()
    {
        animate()->accept();
        const std::string text = presetText(
            {"made", "A", window_->history().sceneState().values[1], std::nullopt, render::Json::object(), {}});
        const Preset read = parsePreset(text, "a.json", "made", gallery_->table());
        QCOMPARE(read.values.motions().size(), std::size_t{1});
        QVERIFY(read.values == window_->history().sceneState().values[1]);
    }

    void longTheClockIsStoppedStartedAndSet()
    {
        gallery_->exhibit().moves = true;
        window_->viewport().scene().change();
        QTRY_VERIFY(window_->viewport().clock().time() > 0.3);
        QTRY_VERIFY(clock()->value() > 0.3);
        QCOMPARE(clockButton()->text(), QString("Pause"));
        QTest::mouseClick(clockButton(), Qt::LeftButton);
        QCOMPARE(clockButton()->text(), QString("Play"));
        settle();
        const double rests = window_->viewport().clock().time();
        QTRY_COMPARE(clock()->value(), rests);
        type("71.25");
        QCOMPARE(window_->viewport().clock().time(), 71.25);
        settle();
        QCOMPARE(gallery_->requests().back().time, 71.25);
        QCOMPARE(gallery_->requests().back().samples, 16);
        const long long drawn = window_->viewport().pictures().shown().pictures();
        type("71.25");
        QTest::qWait(300);
        QCOMPARE(window_->viewport().pictures().shown().pictures(), drawn);
        QTest::mouseClick(clockButton(), Qt::LeftButton);
        QCOMPARE(clockButton()->text(), QString("Pause"));
        QTRY_VERIFY(window_->viewport().clock().time() > 71.4);
        QTRY_VERIFY(clock()->value() > 71.4);
        type("1e9");
        QVERIFY(window_->viewport().clock().time() >= ExhibitClock::latest);
    }

    void longAtAMomentBeforeAPressNothingIsPressed()
    {
        gallery_->exhibit().movesFor = 3;
        window_->visit(1);
        settle();
        action("Pause clock")->trigger();
        type("10");
        window_->viewport().interaction().press();
        settle();
        QCOMPARE(gallery_->requests().back().sincePressed[1], 0.0);
        type("11.5");
        settle();
        QCOMPARE(gallery_->requests().back().sincePressed[1], 1.5);
        type("9.5");
        settle();
        QVERIFY(gallery_->requests().back().sincePressed[1] > 1e6);
        QCOMPARE(gallery_->requests().back().time, 9.5);
    }

private:
    [[nodiscard]] NumberField* clock() { return window_->findChild<ClockBar*>()->findChild<NumberField*>(); }
    [[nodiscard]] QToolButton* clockButton() { return window_->findChild<ClockBar*>()->findChild<QToolButton*>(); }
    void type(const char* time)
    {
        QTest::mouseClick(clock(), Qt::LeftButton);
        QTest::keyClicks(clock(), time);
        QTest::keyClick(clock(), Qt::Key_Return);
    }
    [[nodiscard]] ParameterRow* row() { return window_->panel().row("roughness"); }
    [[nodiscard]] const Motion* motion()
    {
        const ParameterValues& values = window_->history().sceneState().values[1];
        return values.motion(*values.table().find("roughness"));
    }
    /// Chooses from the parameter's menu.
    void choose(const char* words)
    {
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, row()->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(row(), &event);
        auto* menu = window_->panel().findChild<QMenu*>();
        QVERIFY(menu);
        for (QAction* action : menu->actions())
            if (action->text() == QString::fromUtf8(words)) action->trigger();
        delete menu;
    }
    static void choose(QComboBox& box, int index)
    {
        box.setCurrentIndex(index);
        emit box.activated(index);
    }
    MotionDialog* animate()
    {
        choose("Animate…");
        return window_->findChild<MotionDialog*>();
    }
};

VITRINE_WINDOW_TEST(MotionWindowTest)

#include "motion_window_test.moc"
