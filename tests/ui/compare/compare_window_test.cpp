// Comparison in the real window: sources of B, modes, and copying values between A and B.

#include "tests/ui/compare/open_comparison.h"
#include "tests/ui/ui_main.h"

#include "exhibits/framework/files/preset.h"
#include "render/image/image_io.h"
#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_bar.h"
#include "ui/presets/preset_controller.h"
#include "ui/viewport/overlay.h"

#include <QContextMenuEvent>
#include <QMenu>

#include <glm/gtc/constants.hpp>

using namespace vitrine;
using namespace vitrine::ui;

class CompareWindowTest : public test::OpenComparison {
    Q_OBJECT

    /// Returns an entry of the menu of sources for B, or of one of its submenus.
    [[nodiscard]] static QAction* entry(QMenu& menu, const QString& text)
    {
        for (QAction* each : menu.actions()) {
            if (each->text().remove('&') == text) return each;
            if (each->menu())
                if (QAction* inner = entry(*each->menu(), text)) return inner;
        }
        return nullptr;
    }
    [[nodiscard]] QMenu& sources()
    {
        emit controller().actions().sources().aboutToShow();
        return controller().actions().sources();
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longAWipeShowsAOnTheLeftOfItsLineAndBOnTheRight()
    {
        QVERIFY2(!controller().bar().isVisible(), "nothing is compared at the start");
        compare();
        QVERIFY(action("Wipe")->isChecked());
        QVERIFY(controller().bar().isVisible());
        QVERIFY(isA(0.3));
        QVERIFY(isB(0.6));
        const render::Camera camera = window_->history().sceneState().camera;
        dragInPicture(0.5, 0.75);
        QVERIFY(std::abs(controller().overlay().wipe() - 0.75) < 0.01);
        QVERIFY(window_->history().sceneState().camera == camera);
        QVERIFY2(isA(0.6), "the line is right of it now");
        QVERIFY(isB(0.9));
        dragInPicture(0.2, 0.3);
        QVERIFY2(!(window_->history().sceneState().camera == camera), "beside the line a drag looks around");
        QVERIFY(std::abs(controller().overlay().wipe() - 0.75) < 0.01);
        rest();
        window_->activateWindow();
        QTRY_VERIFY(window_->isActiveWindow());
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_W, Qt::ControlModifier);
        QVERIFY(!action("Wipe")->isChecked());
        QVERIFY2(isA(0.9), "A alone");
    }

    void whileItsKeyIsHeldBIsShownAlone()
    {
        compare();
        action("Wipe")->trigger();
        rest();
        view().setFocus();
        const std::size_t drawn = gallery_->otherRequests().size();
        QTest::keyPress(&view(), Qt::Key_B);
        QTRY_VERIFY(isB(0.1));
        QVERIFY(gallery_->otherRequests().size() > drawn);
        QTest::keyRelease(&view(), Qt::Key_B);
        QTRY_VERIFY(isA(0.1));
        action("A/B flicker")->trigger();
        rest();
        QVERIFY(isA(0.1));
        QVERIFY(isA(0.9));
        const std::size_t ready = gallery_->otherRequests().size();
        QTest::keyPress(&view(), Qt::Key_B);
        QVERIFY2(isB(0.1), "it was kept ready");
        QTest::keyRelease(&view(), Qt::Key_B);
        QCOMPARE(gallery_->otherRequests().size(), ready);
    }

    void whoLosesBWhileItsKeyIsHeldHoldsItNoMore()
    {
        compare();
        view().setFocus();
        QTest::keyPress(&view(), Qt::Key_B);
        QTRY_VERIFY2(isB(0.1), "a control: the key is held");
        action("End the comparison")->trigger();
        QVERIFY(!controller().overlay().otherAlone());
        QTest::keyRelease(&view(), Qt::Key_B);
        setRoughness(0.2);
        action("Hold the current settings as B")->trigger();
        setRoughness(0.8);
        rest();
        QVERIFY(!controller().overlay().otherAlone());
        QVERIFY(isA(0.3));
        QVERIFY(isB(0.6));
        QTest::keyPress(&view(), Qt::Key_B);
        QVERIFY2(isB(0.1), "a control: the key works as before");
        QTest::keyRelease(&view(), Qt::Key_B);
        QVERIFY(isA(0.3));
    }

    void sideBySideThePointerWorksInBoth()
    {
        compare();
        action("Side by side")->trigger();
        rest();
        const auto middle = [&](double x) { return shownAt(x, 0.5).red(); };
        QVERIFY(std::abs(middle(0.25) - 204) <= 1);
        QVERIFY(std::abs(middle(0.75) - 51) <= 1);
        QVERIFY2(std::abs(shownAt(0.25, 0.02).red() - 0x20) <= 1, "above a picture of half the size is nothing");
        // A drag has the same effect as in the whole picture, which is twice as wide, also across the middle.
        for (const auto& [from, to] : {std::pair{0.7, 0.8}, {0.6, 0.3}, {0.2, 0.9}}) {
            const double before = heading();
            const int pixels = at(to).x() - at(from).x();
            QTest::mousePress(&view(), Qt::LeftButton, {}, at(from, 0.5));
            for (int i = 1; i <= 8; ++i) QTest::mouseMove(&view(), at(from, 0.5) + QPoint(pixels * i / 8, 0));
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, at(to, 0.5));
            const double turned = std::remainder(heading() - before, 2 * glm::pi<double>());
            const double whole = pixels * view().width() / ((view().width() - 4) / 2.0);
            QVERIFY2(std::abs(std::abs(turned) - 0.0035 * std::abs(whole)) < 0.01,
                     qPrintable(QString("%1 radians by %2 pixels").arg(turned).arg(whole)));
            QCOMPARE(turned > 0, pixels > 0);
        }
    }

    void longNamesAreNotShownWhereAnotherPictureCoversTheirs()
    {
        compare();
        window_->visit(1);
        QTRY_COMPARE(view().visitor().mode(), CameraControl::Mode::orbit);
        rest();
        const auto named = [&] {
            for (const Overlay* overlay : view().findChildren<Overlay*>())
                if (overlay->isVisible() && overlay->text() == "Torus to mug") return true;
            return false;
        };
        QTest::mouseMove(&view(), at(0.52, 0.5));
        QTRY_VERIFY2(named(), "a control: between A and B of one picture it is");
        action("Side by side")->trigger();
        QVERIFY(!named());
        QTest::mouseMove(&view(), at(0.26, 0.5));
        QTest::qWait(100);
        QVERIFY(!named());
        action("Side by side")->trigger();
        QTest::mouseMove(&view(), at(0.52, 0.5));
        QTRY_VERIFY(named());
    }

    void whatMovesValuesBetweenTheTwoIsOneUndoStep()
    {
        compare();
        QUndoStack& stack = window_->history().stack();
        const int before = stack.count();
        const auto expect = [&](double a, double b, int steps) {
            QCOMPARE(roughness(), a);
            QCOMPARE(otherRoughness(), b);
            QCOMPARE(stack.count(), before + steps);
        };
        action("Swap A and B")->trigger();
        expect(0.2, 0.8, 1);
        stack.undo();
        expect(0.8, 0.2, 1);
        action("Copy all from B")->trigger();
        expect(0.2, 0.2, 1);
        QTRY_COMPARE(controller().bar().differenceText(), QString("A and B are identical"));
        stack.undo();
        QTRY_COMPARE(controller().bar().differenceText(), QString("1 parameter differs"));
        action("Copy all to B")->trigger();
        expect(0.8, 0.8, 1);
        stack.undo();
        expect(0.8, 0.2, 1);

        // The same for one parameter, in its menu.
        window_->history().set(1, gallery_->table().morph.row, 0.9, newGesture());
        const auto openMenu = [&] {
            auto* row = window_->panel().row("roughness");
            QContextMenuEvent event(QContextMenuEvent::Mouse, {4, 4}, row->mapToGlobal(QPoint(4, 4)));
            QApplication::sendEvent(row, &event);
            return window_->panel().findChildren<QMenu*>().back();
        };
        QMenu* menu = openMenu();
        QAction* take = entry(*menu, "Copy from B: 0.2");
        QVERIFY(take && take->isEnabled());
        take->trigger();
        menu->close();
        QCOMPARE(roughness(), 0.2);
        QTRY_COMPARE(controller().bar().differenceText(),
                     QString("1 parameter differs"));  // The other one still differs.
        stack.undo();
        menu = openMenu();
        entry(*menu, "Copy to B")->trigger();
        menu->close();
        QCOMPARE(otherRoughness(), 0.8);
        QVERIFY(controller().other().name().endsWith(" *"));
        stack.undo();
        QCOMPARE(otherRoughness(), 0.2);
    }

    void aSliderLeadsAToBInOneUndoStep()
    {
        compare();
        QUndoStack& stack = window_->history().stack();
        const int before = stack.count();
        ValueSlider& slider = controller().bar().morph();
        const int y = slider.height() / 2;
        QTest::mousePress(&slider, Qt::LeftButton, {}, {8, y});
        for (int x = 9; x <= slider.width() / 2; x += 3) QTest::mouseMove(&slider, {x, y});
        QVERIFY2(roughness() > 0.4 && roughness() < 0.6, qPrintable(QString::number(roughness())));
        for (int x = slider.width() / 2; x <= slider.width() - 2; x += 3) QTest::mouseMove(&slider, {x, y});
        QCOMPARE(roughness(), 0.2);
        for (int x = slider.width() - 2; x >= slider.width() / 2; x -= 3) QTest::mouseMove(&slider, {x, y});
        QVERIFY2(roughness() > 0.4 && roughness() < 0.6, "the way back is the same way");
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, {slider.width() / 2, y});
        QCOMPARE(stack.count(), before + 1);
        QCOMPARE(otherRoughness(), 0.2);
        stack.undo();
        QCOMPARE(roughness(), 0.8);
        QCOMPARE(slider.value(), 0);
    }

    void presetsFilesPicturesAndUndoStepsCanBeB()
    {
        window_->choose(1);
        setRoughness(0.3);
        window_->presetController().saveUnder("Dull & Dusty");
        setRoughness(0.7);
        settle();
        QAction* preset = entry(sources(), "Dull  Dusty");
        QVERIFY(preset);
        QCOMPARE(preset->text(), QString("Dull && Dusty"));  // A single ampersand would mark a shortcut key.
        preset->trigger();
        QTRY_VERIFY(controller().other().isSet());
        QCOMPARE(otherRoughness(), 0.3);
        QCOMPARE(controller().other().name(), QString("Dull & Dusty"));
        QCOMPARE(roughness(), 0.7);

        // A picture that contains a preset.
        Preset inside{"sdf_morph", "From a picture", window_->history().sceneState().values[1], std::nullopt};
        inside.values.set(gallery_->table().roughness, 0.45);
        const QString picture = home_->filePath("picture.png");
        render::writePicture(picture.toStdString(), render::Image(4, 4, 3, 0.5F), render::PictureFormat::png8,
                             {.preset = presetText(inside)});
        controller().holdFile(picture);
        QTRY_COMPARE(otherRoughness(), 0.45);
        QCOMPARE(controller().other().name(), QString("From a picture"));

        // Values from before the last edit; the present ones stay.
        const int steps = window_->history().stack().count();
        QAction* step = entry(sources(), "At the start");
        QVERIFY(step);
        step->trigger();
        QTRY_COMPARE(otherRoughness(), 0.25);
        QCOMPARE(roughness(), 0.7);
        QCOMPARE(window_->history().stack().count(), steps);
        window_->history().stack().undo();
        QAction* undone = entry(sources(), "After “Change roughness”");  // The last step, which is undone now.
        QVERIFY(undone);
        undone->trigger();
        QTRY_COMPARE(otherRoughness(), 0.7);

        // The later of two sources becomes B, even if the earlier one takes longer to read.
        controller().holdFile(picture);
        action("Hold the current settings as B")->trigger();
        settle();
        QTest::qWait(50);
        QCOMPARE(controller().other().name(), QString("Snapshot of A"));
        setRoughness(0.7);
        action("Hold the current settings as B")->trigger();
        QTRY_COMPARE(otherRoughness(), 0.7);

        // An unreadable file changes nothing and is reported.
        const QString bad = home_->filePath("bad.json");
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{");
        file.close();
        controller().holdFile(bad);
        QTest::qWait(100);
        QCOMPARE(otherRoughness(), 0.7);
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("bad.json"));
    }

    void everyCommandIsInThePaletteWithItsShortcutInTheTip()
    {
        for (const QAction* each : controller().actions().all()) {
            if (!each) continue;
            QVERIFY2(action(qPrintable(each->text().remove('&'))) == each, qPrintable(each->text()));
            QVERIFY(!each->toolTip().isEmpty());
            if (!each->shortcut().isEmpty())
                QVERIFY(each->toolTip().contains(each->shortcut().toString(QKeySequence::NativeText)));
        }
        QVERIFY(!action("Swap A and B")->isEnabled());
        compare();
        QVERIFY(action("Swap A and B")->isEnabled());
        for (const QWidget* child : controller().bar().findChildren<QWidget*>())
            if (child->focusPolicy() != Qt::NoFocus)
                QVERIFY2(!child->accessibleName().isEmpty(), child->metaObject()->className());
        window_->hidePanels(true);
        QVERIFY2(!controller().bar().isVisible(), "the bare picture is bare");
        window_->hidePanels(false);
        QVERIFY(controller().bar().isVisible());
    }
};

VITRINE_UI_TEST(CompareWindowTest)

#include "compare_window_test.moc"
