// Panel of the minimal exhibit with a tree, which shows that it does not depend on the kind of tree.

#include "tests/support/blocks.h"
#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/editor/document_file.h"
#include "ui/presets/preset_controller.h"
#include "ui/tree/tree_dock.h"
#include "ui/tree/tree_editor.h"
#include "ui/tree/tree_overlay.h"
#include "ui/tree/tree_rows.h"
#include "ui/tree/tree_view.h"
#include "ui/window/window_docks.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>
#include <QUrl>

#include <fstream>

using namespace vitrine;
using namespace vitrine::ui;

class TreeBlocksTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t blocks = 2;

    std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<test::BlocksExhibit>(); }
    [[nodiscard]] QString path() const { return home_->filePath("pile.json"); }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[blocks]; }
    [[nodiscard]] TreeDock& dock() { return window_->docks().tree(); }
    [[nodiscard]] TreeEditor& editor() { return dock().editor(); }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    [[nodiscard]] QTreeWidgetItem& root() { return *dock().view().topLevelItem(0); }
    [[nodiscard]] double size(const char* node)
    {
        const auto rows = editor().source()->parametersOf(values(), node);
        return rows ? std::get<double>(rows->values.row(0)) : 0;
    }
    /// Drops the file on the window.
    void drop(const QString& file)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window_.get(), &enter);
        QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window_.get(), &event);
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        std::ofstream(path().toStdString())
            << test::textOfBlocks({{"red", 0.6, {-0.5, 0, 0}}, {"blue", 0.6, {0.5, 0, 0}}});
        drop(path());
        QTRY_COMPARE(editor().tree().nodes.size(), std::size_t(3));
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        settle();
    }
    void cleanup()
    {
        if (window_) window_->history().set(blocks, values().table().find("document").value(), std::string(), 0);
        finish();
    }

    void longADroppedFileIsShownAndItsExhibitVisited()
    {
        QCOMPARE(window_->chosen(), blocks);
        QCOMPARE(root().childCount(), 2);
        QCOMPARE(root().child(0)->text(0), QString("red"));
        QCOMPARE(root().child(0)->data(0, Qt::UserRole).toString(), QString("red"));
        stack().undo();
        QTRY_COMPARE(editor().tree().nodes.size(), std::size_t(1));
    }

    void longTheMenuOfKindsAddsAndDeleteTakesAway()
    {
        QMenu* menu = nullptr;
        for (auto* button : dock().findChildren<QToolButton*>())
            if (button->text() == "Add") menu = button->menu();
        QVERIFY(menu);
        emit menu->aboutToShow();
        QCOMPARE(menu->actions().first()->text(), QString("cube"));
        QCOMPARE(menu->actions().first()->toolTip(), QString("A cube."));
        menu->actions().first()->trigger();
        QCOMPARE(editor().selected(), std::string("block 2"));
        QCOMPARE(stack().undoText(), QString("Add cube"));
        QCOMPARE(dock().view().currentItem()->text(0), QString("block 2"));
        window_->activateWindow();
        dock().view().setFocus();
        QTRY_VERIFY(dock().view().hasFocus());
        QTest::keyClick(&dock().view(), Qt::Key_Delete);
        QCOMPARE(editor().tree().nodes.size(), std::size_t(3));
        QVERIFY(editor().selected().empty());
        stack().undo();
        stack().undo();
        QCOMPARE(editor().tree().nodes.size(), std::size_t(3));
    }

    void f2RenamesInPlace()
    {
        editor().select("blue");
        window_->activateWindow();
        dock().view().setFocus();
        QTest::keyClick(&dock().view(), Qt::Key_F2);
        auto* field = dock().view().findChild<QLineEdit*>();
        QVERIFY(field);
        QTest::keyClicks(field, "green");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(editor().selected(), std::string("green"));
        QCOMPARE(root().child(1)->text(0), QString("green"));
        QCOMPARE(stack().undoText(), QString("Rename blue"));
    }

    void longWhatItDoesNotKnowIsSaidAndTheTreeStaysAsItIs()
    {
        root().child(0)->setCheckState(0, Qt::Unchecked);
        QTRY_VERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("no such change"));
        QTRY_COMPARE(root().child(0)->checkState(0), Qt::Checked);
    }

    void longAnOutlineAndHandlesStandWhereTheCubeIs()
    {
        auto& viewport = window_->viewport();
        const QSize room = viewport.size();
        // The camera of the best view is 4 m away; the block is 0.5 m to the right.
        const double perMeter = room.height() / (2 * viewport.scene().view().tanHalfFov.y * 4);
        const QPoint blue(room.width() / 2 + static_cast<int>(0.5 * perMeter), room.height() / 2);
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, blue);
        QCOMPARE(editor().selected(), std::string("blue"));
        QTRY_VERIFY(!dock().overlay().outline().empty());
        double left = 1e9, right = -1e9;
        for (const QLineF& line : dock().overlay().outline()) {
            left = std::min(left, line.x1());
            right = std::max(right, line.x1());
        }
        // From the left edge of its back to the right edge of its front, 0.3 m farther and nearer.
        const double wide = (0.8 / 3.7 - 0.2 / 4.3) * 4 * perMeter;
        QVERIFY2(std::abs(right - left - wide) < 2, qPrintable(QString::number(right - left - wide)));
        QVERIFY(!dock().overlay().handles().empty());
        QVERIFY(QLineF(dock().overlay().handles()[0].line[0], blue).length() < 2);
        // Shortcut of another mode, while the picture has the focus.
        window_->activateWindow();
        viewport.setFocus();
        QTRY_VERIFY(viewport.hasFocus());
        QTest::keyClick(&viewport, Qt::Key_2);
        QVERIFY(dock().overlay().handles()[0].line.size() > 10);
        QTest::keyClick(&viewport, Qt::Key_1);
        QCOMPARE(dock().overlay().handles()[0].line.size(), std::size_t(2));
        // Handles belong to the whole picture of A.
        action("Hold the current settings as B")->trigger();
        action("Side by side")->trigger();
        QTRY_VERIFY(viewport.covered());
        QVERIFY(!dock().overlay().isVisible());
        QVERIFY(dock().overlay().handles().empty());
        action("End the comparison")->trigger();
        QVERIFY(dock().overlay().isVisible());
        QVERIFY(!dock().overlay().handles().empty());
        // A click beside the block selects nothing.
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, QPoint(room.width() / 2, room.height() / 2 + 5));
        QVERIFY(editor().selected().empty());
        QVERIFY(dock().overlay().handles().empty());
    }

    void longPresetsCarryWhatIsNotInTheFile()
    {
        editor().select("red");
        editor().setParameter(0, 0.3, newGesture(), "Change");
        window_->presetController().saveUnder("Small red");
        stack().undo();
        QCOMPARE(size("red"), 0.6);
        window_->presetController().load(rowsNamed("Small red").front()->data(Qt::UserRole).toString());
        QTRY_COMPARE(size("red"), 0.3);
        QVERIFY(window_->docks().documentFile().unsaved().contains("pile.json"));
    }

    void savedElsewhereTheOldFileStaysAsItIs()
    {
        editor().select("red");
        editor().setParameter(0, 0.3, newGesture(), "Change");
        const QString other = home_->filePath("other.json");
        QVERIFY(window_->docks().documentFile().saveTo(other));
        QTRY_COMPARE(std::get<std::string>(values().row(values().table().find("pile").value())), other.toStdString());
        QTRY_COMPARE(size("red"), 0.3);
        QVERIFY(render::readFile(path().toStdString(), 1 << 20).find("0.3,") == std::string::npos);
        QVERIFY(window_->docks().documentFile().unsaved().isEmpty());
        QVERIFY(!window_->docks().documentFile().saveTo(home_->filePath("no/such/folder.json")));
    }
};

VITRINE_WINDOW_TEST(TreeBlocksTest)

#include "tree_blocks_test.moc"
