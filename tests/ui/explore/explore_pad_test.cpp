// Pad of four settings in the real window: the effect of its handle by pointer and keys.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/explore/explore_dock.h"
#include "ui/explore/morph_pad.h"
#include "ui/presets/preset_controller.h"
#include "ui/window/window_docks.h"

#include <QAccessible>
#include <QComboBox>
#include <QFile>

using namespace vitrine;
using namespace vitrine::ui;

class ExplorePadTest : public test::OpenWindow {
    Q_OBJECT

    [[nodiscard]] ExploreDock& dock() { return window_->docks().explore(); }
    [[nodiscard]] MorphPad& pad() { return dock().pad(); }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    void setRoughness(double value) { window_->history().set(1, gallery_->table().roughness.row, value, newGesture()); }
    [[nodiscard]] bool near(double a, double b) { return std::abs(a - b) < 0.01; }
    /// Chooses by keyboard, without opening the list.
    void choose(std::size_t corner, const char* name)
    {
        QComboBox& chooser = dock().chooser(corner);
        chooser.setFocus();
        QTest::keyClicks(&chooser, QString::fromUtf8(name));
        QTRY_VERIFY(dock().corners().ready());
        QTest::qWait(QApplication::keyboardInputInterval() + 20);  // After this pause, letters start another search.
    }
    /// Sets 0.6, with presets of 1 ("Rough") and 0.2 ("Slick").
    void explore()
    {
        window_->choose(1);
        setRoughness(1);
        window_->presetController().saveUnder("Rough");
        setRoughness(0.2);
        window_->presetController().saveUnder("Slick");
        setRoughness(0.6);
        action("Explore")->trigger();
        QTRY_VERIFY(pad().isVisible());
        choose(1, "Rough");
        choose(2, "Slick");
        choose(3, "Slick");
        window_->activateWindow();
        QTRY_VERIFY(window_->isActiveWindow());
        pad().setFocus();
        QCOMPARE(pad().place(), QPointF(0, 0));
        QVERIFY(!pad().hollow());
    }
    [[nodiscard]] QPoint at(double x, double y)
    {
        return {static_cast<int>(10 + x * (pad().width() - 20)), static_cast<int>(10 + y * (pad().height() - 20))};
    }
    void moveTo(double x, double y)
    {
        const QPoint from = at(pad().place().x(), pad().place().y());
        for (int i = 1; i <= 6; ++i) QTest::mouseMove(&pad(), from + (at(x, y) - from) * i / 6);
    }
    void drag(double x, double y)
    {
        QTest::mousePress(&pad(), Qt::LeftButton, {}, at(pad().place().x(), pad().place().y()));
        moveTo(x, y);
        QTest::mouseRelease(&pad(), Qt::LeftButton, {}, at(x, y));
    }

private slots:
    void initTestCase()
    {
        prepare();
        QApplication::setKeyboardInputInterval(50);
    }
    void init() { start(); }
    void cleanup() { finish(); }

    void longADragBlendsTheCornersLiveAndIsOneUndoStep()
    {
        explore();
        const int before = stack().count();
        const render::Camera camera = window_->history().sceneState().camera;
        QTest::mousePress(&pad(), Qt::LeftButton, {}, at(0, 0));
        moveTo(0.5, 0);
        QVERIFY2(near(roughness(), 0.8), "halfway from 0.6 to 1, before the button is up");
        QTRY_VERIFY(std::abs(red() - 204) <= 2);
        moveTo(0.5, 0.5);
        QVERIFY2(near(roughness(), (0.6 + 1 + 0.2 + 0.2) / 4), "a quarter of each");
        moveTo(2, 0);
        QTest::mouseRelease(&pad(), Qt::LeftButton, {}, at(2, 0));
        QCOMPARE(roughness(), 1.0);
        QVERIFY2(pad().place() == QPointF(1, 0), "it stays in the square");
        QCOMPARE(stack().count(), before + 1);
        QVERIFY(window_->history().sceneState().camera == camera);
        stack().undo();
        QCOMPARE(roughness(), 0.6);
        QCOMPARE(pad().place(), QPointF(0, 0));
    }

    void longAPressBringsTheHandleThere()
    {
        explore();
        QTest::mouseClick(&pad(), Qt::LeftButton, {}, at(0, 1));
        QCOMPARE(roughness(), 0.2);
        QCOMPARE(pad().place(), QPointF(0, 1));
    }

    void escDuringADragTakesItBack()
    {
        explore();
        const int before = stack().count();
        QTest::mousePress(&pad(), Qt::LeftButton, {}, at(0, 0));
        moveTo(0.7, 0.1);
        QVERIFY(!near(roughness(), 0.6));
        QTest::keyClick(&pad(), Qt::Key_Escape);
        QCOMPARE(roughness(), 0.6);
        QCOMPARE(pad().place(), QPointF(0, 0));
        QCOMPARE(stack().count(), before);
        moveTo(0.9, 0.9);
        QTest::mouseRelease(&pad(), Qt::LeftButton, {}, at(0.9, 0.9));
        QCOMPARE(roughness(), 0.6);
        drag(1, 0);
        QCOMPARE(roughness(), 1.0);
        QTest::mousePress(&pad(), Qt::LeftButton, {}, at(1, 0));
        moveTo(0.3, 0.8);
        QTest::keyClick(&pad(), Qt::Key_Escape);
        QTest::mouseRelease(&pad(), Qt::LeftButton, {}, at(1, 0));
        QVERIFY2(roughness() == 1.0 && pad().place() == QPointF(1, 0), "to where this drag began");
        QCOMPARE(stack().count(), before + 1);
    }

    void arrowsMoveTheHandleFinerAndCoarser()
    {
        explore();
        const int before = stack().count();
        QTest::keyClick(&pad(), Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(near(pad().place().x(), 0.2));
        QTest::keyClick(&pad(), Qt::Key_Right);
        QVERIFY(std::abs(pad().place().x() - 0.22) < 1e-9);
        QTest::keyClick(&pad(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(std::abs(pad().place().x() - 0.218) < 1e-9);
        QVERIFY(std::abs(roughness() - (0.6 + 0.4 * 0.218)) < 1e-9);
        QTest::keyClick(&pad(), Qt::Key_Down, Qt::ControlModifier);
        QVERIFY(near(pad().place().y(), 0.2));
        QTest::keyClick(&pad(), Qt::Key_Up);
        QVERIFY(std::abs(pad().place().y() - 0.18) < 1e-9);
        QCOMPARE(stack().count(), before + 5);
        QTest::keyClick(&pad(), Qt::Key_Home);
        QCOMPARE(roughness(), 0.6);
    }

    void aScreenReaderHearsWhatCountsHowMuch()
    {
        explore();
        drag(0.25, 0);
        QAccessibleInterface* read = QAccessible::queryAccessibleInterface(&pad());
        QVERIFY(read);
        QCOMPARE(read->text(QAccessible::Name), QString("Between four settings"));
        QVERIFY2(QRegularExpression("^7[45] % Current settings, 2[56] % Rough$")
                     .match(read->text(QAccessible::Value))
                     .hasMatch(),
                 qPrintable(read->text(QAccessible::Value)));
        QCOMPARE(dock().chooser(1).accessibleName(), QString("Upper right corner"));
    }

    void anyOtherChangeBeginsAnew()
    {
        explore();
        drag(0.5, 0.5);
        setRoughness(0.4);
        QCOMPARE(pad().place(), QPointF(0, 0));
        drag(0.5, 0);
        QVERIFY2(near(roughness(), 0.7), "from what is on show now");
        choose(0, "Slick");
        QVERIFY2(pad().hollow(), "no corner is what is on show, nor is the handle's place");
        QTest::keyClick(&pad(), Qt::Key_Home);
        QCOMPARE(roughness(), 0.2);
        QVERIFY(!pad().hollow());
    }

    void aLookThatIsKeptAtACornerStaysThere()
    {
        explore();
        choose(3, "Keep");
        QCOMPARE(dock().chooser(3).currentText(), QString("Kept settings"));
        QVERIFY(!dock().corners().at(3).picture.isNull());
        setRoughness(0.9);
        drag(0, 1);
        QCOMPARE(roughness(), 0.2);
        drag(1, 1);
        QCOMPARE(roughness(), 0.6);
    }

    void aPresetThatCannotBeReadIsSaidAndTheCornerStays()
    {
        explore();
        const QString id = dock().corners().at(2).id;
        QFile file(id);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{");
        file.close();
        dock().corners().takePreset(1, id);
        QCOMPARE(dock().corners().at(1).name, QString("Rough"));
        QCOMPARE(dock().chooser(1).currentText(), QString("Rough"));
        QVERIFY(window_->findChild<MessageStrip*>()->isVisible());
        drag(1, 0);
        QCOMPARE(roughness(), 1.0);
    }

    void theHallHasAPadOfItsOwn()
    {
        explore();
        window_->choose(hallIndex);
        QVERIFY(dock().corners().onShow() == 0U);
        for (const PadCorners::Corner& corner : {dock().corners().at(1), dock().corners().at(2)})
            QVERIFY(corner.name != "Rough" && corner.name != "Slick");
        const double before = roughness();
        QTRY_VERIFY(dock().corners().ready());
        drag(1, 1);
        QCOMPARE(roughness(), before);
    }
};

VITRINE_WINDOW_TEST(ExplorePadTest)
#include "explore_pad_test.moc"
