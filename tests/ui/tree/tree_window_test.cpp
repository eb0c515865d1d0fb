#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "render/files/read_file.h"
#include "ui/editor/document_file.h"
#include "ui/tree/tree_dock.h"
#include "ui/tree/tree_editor.h"
#include "ui/tree/tree_overlay.h"
#include "ui/tree/tree_rows.h"
#include "ui/tree/tree_view.h"
#include "ui/window/file_opener.h"
#include "ui/window/recent_files.h"
#include "ui/window/window_docks.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>

#include <fstream>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::patience;

namespace {

const std::string twoBalls = R"({"format": "vitrine-scene",   "version": 1,
 "camera": {"position": [0, 0, 8], "target": [0, 0, 0], "fieldOfView": 40},
 "root": { "kind":"union", "children": [
   {"kind": "sphere", "name": "left",  "radius": 0.50, "translate": [-1, 0, 0]},
   {"kind": "sphere", "name": "right", "radius": 0.50, "translate": [1, 0, 0]}
 ]}}
)";

}  // namespace

/// A scene of shapes in the window, which is clicked, edited and saved. The picture is painted; the field is the real
/// one.
class TreeWindowTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t scenes = 2;

    std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<scenes::SdfScenes>(); }
    [[nodiscard]] QString path() const { return home_->filePath("two.json"); }
    [[nodiscard]] std::string onDisk() const { return render::readFile(path().toStdString(), 1 << 20); }
    void write(const std::string& text) const { std::ofstream(path().toStdString()) << text; }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[scenes]; }
    [[nodiscard]] std::string document()
    {
        return std::get<std::string>(values().row(values().table().find("document").value()));
    }
    [[nodiscard]] TreeDock& dock() { return window_->docks().tree(); }
    [[nodiscard]] TreeEditor& editor() { return dock().editor(); }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    /// Returns a number of the selected node.
    [[nodiscard]] double number(const char* row)
    {
        const TreeParameters rows = editor().source()->parametersOf(editor().values(), editor().selected()).value();
        return std::get<double>(rows.values.row(rows.values.table().find(row).value()));
    }
    /// Returns the position of a point of the scene in the picture: x, y at the depth of the balls.
    [[nodiscard]] QPoint at(double x, double y)
    {
        const ExhibitState state{values()};
        const TreePlace place = editor().source()->placeOf(state, "root.children[0]").value();
        const glm::dmat4 world = gallery_->museum().worldFromExhibit(scenes) * place.exhibitFromParent;
        const render::View view = window_->viewport().scene().view();
        const glm::dvec4 clip = view.clipFromWorld * world * glm::dvec4(x, y, 0, 1);
        const QSize size = window_->viewport().size();
        return {static_cast<int>((0.5 + 0.5 * clip.x / clip.w) * size.width()),
                static_cast<int>((0.5 - 0.5 * clip.y / clip.w) * size.height())};
    }
    void click(const QPoint& point) { QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, point); }
    void openScene()
    {
        write(twoBalls);
        window_->files().open(path());
        QTRY_VERIFY(values().table().find("document") && editor().tree().nodes.size() == 3);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        settle();
    }
    QMessageBox* question() { return window_->findChild<QMessageBox*>(); }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        openScene();
    }
    void cleanup()
    {
        if (window_) stack().clear();
        if (window_ && document() != "")
            window_->history().set(scenes, values().table().find("document").value(), std::string(), 0);
        finish();
    }

    void longNodesAreFoundByNameAndKind()
    {
        QLineEdit* words = nullptr;
        for (QLineEdit* each : dock().findChildren<QLineEdit*>())
            if (each->accessibleName() == "Find a node") words = each;
        QVERIFY(words);
        const auto shown = [this] {
            QStringList names;
            for (QTreeWidgetItemIterator it(&dock().view()); *it; ++it)
                if (!(*it)->isHidden()) names << (*it)->text(0);
            return names;
        };
        QCOMPARE(shown(), (QStringList{"union", "left", "right"}));
        words->setFocus();
        QTest::keyClicks(words, "RIG sph");
        QCOMPARE(shown(), (QStringList{"union", "right"}));
        QTest::keyClick(words, Qt::Key_Return);
        QCOMPARE(editor().selected(), std::string("root.children[1]"));
        // A change rebuilds the tree; the search text stays.
        dock().action(TreeEdit::What::duplicate)->trigger();
        QTRY_COMPARE(editor().tree().nodes.size(), std::size_t{4});
        QCOMPARE(shown().size(), 3);
        stack().undo();
        QTRY_COMPARE(editor().tree().nodes.size(), std::size_t{3});

        const auto label = [this] {
            for (const QLabel* each : dock().findChildren<QLabel*>())
                if (each->text() == "No node matches.") return each;
            return static_cast<const QLabel*>(nullptr);
        };
        QVERIFY(!label());
        words->setText("nothing of the kind");
        QTRY_VERIFY(label() && label()->isVisible());
        words->setFocus();
        QTest::keyClick(words, Qt::Key_Escape);
        QVERIFY(words->text().isEmpty());
        QVERIFY(!label());
        QCOMPARE(shown(), (QStringList{"union", "left", "right"}));
    }

    void longUndoingSeveralAdditionsReturnsToWhatWasSelected()
    {
        const std::string left = "root.children[0]";
        editor().select(left);
        QVERIFY(editor().apply({TreeEdit::What::add, "root", "sphere"}, "first"));
        const std::string first = editor().selected();
        QVERIFY(editor().apply({TreeEdit::What::add, "root", "sphere"}, "second"));
        QVERIFY(editor().selected() != first && first != left);
        stack().undo();
        QCOMPARE(editor().selected(), first);
        stack().undo();
        QCOMPARE(editor().selected(), left);
        QCOMPARE(TreeView::nodeOf(*dock().view().currentItem()), left);
    }

    void longNodesOfOneTitleAreToldApartByTheirFirstNumber()
    {
        QVERIFY(editor().apply({TreeEdit::What::add, "root", "sphere"}, "first"));
        const std::string first = editor().selected();
        QCOMPARE(dock().view().itemOf(first)->text(1), QString());  // No other node has its title.
        QVERIFY(editor().apply({TreeEdit::What::add, "root", "sphere"}, "second"));
        const std::string second = editor().selected();
        const auto beside = [this](const std::string& node) { return dock().view().itemOf(node)->text(1); };
        QVERIFY2(beside(first).startsWith("Radius 0."), qPrintable(beside(first)));
        QCOMPARE(beside(second), beside(first));
        const TreeParameters rows = editor().source()->parametersOf(editor().values(), second).value();
        editor().setParameter(rows.values.table().find("radius").value(), 0.123, 0, "third");
        QCOMPARE(beside(second), QString::fromUtf8("Radius 0.123\u2009m"));
        QVERIFY(beside(first) != beside(second));
    }

    void kindsAreOfferedInGroupsAndFoundByWords()
    {
        click(at(1, 0));
        QMenu* menu = nullptr;
        for (QToolButton* button : dock().findChildren<QToolButton*>())
            if (button->text() == "Wrap") menu = button->menu();
        QVERIFY(menu);
        const auto offered = [&](bool groups) {
            QStringList texts;
            for (const QAction* each : menu->actions())
                if (each->isVisible() && !each->text().isEmpty() && (each->menu() != nullptr) == groups)
                    texts << each->text();
            return texts;
        };
        menu->popup(window_->mapToGlobal(QPoint(40, 40)));
        QTRY_VERIFY(menu->isVisible());
        auto* words = menu->findChild<QLineEdit*>();
        QVERIFY(words);
        QCOMPARE(offered(true), (QStringList{"Combine", "Reshape", "Repeat"}));
        QVERIFY(offered(false).isEmpty());
        QTest::keyClicks(words, "no such thing");
        QCOMPARE(offered(false), QStringList{"No shape or operation matches."});
        words->clear();
        QTest::keyClicks(words, "smooth union");
        QCOMPARE(offered(false), QStringList{"union"});
        QVERIFY(offered(true).isEmpty());
        const std::size_t before = editor().tree().nodes.size();
        QTest::keyClick(words, Qt::Key_Return);
        QTRY_VERIFY(!menu->isVisible());
        QCOMPARE(editor().tree().nodes.size(), before + 1);
        QCOMPARE(editor().tree().nodes[editor().tree().find(editor().selected())].kind, std::string("union"));
        stack().undo();
        for (QToolButton* button : dock().findChildren<QToolButton*>())
            if (button->text() == "Add") menu = button->menu();
        menu->popup(window_->mapToGlobal(QPoint(40, 40)));
        QTRY_VERIFY(menu->isVisible());
        QCOMPARE(offered(true), (QStringList{"Solids", "More solids", "Flat shapes", "Combine", "Reshape", "Repeat"}));
        QVERIFY(menu->height() < window_->height() / 2);
        menu->close();
    }

    void longClickDragUndoSaveAndReload()
    {
        click(at(1, 0));
        QCOMPARE(editor().selected(), std::string("root.children[1]"));
        QCOMPARE(dock().view().currentItem()->text(0), QString("right"));
        QTRY_VERIFY(!dock().overlay().outline().empty());
        // Dragging its radius is one step and changes only its own text.
        auto* slider = dock().rows().row("radius")->findChild<ValueSlider*>();
        QVERIFY(slider);
        const render::Camera camera = window_->history().sceneState().camera;
        QToolButton* save = nullptr;
        for (QToolButton* button : dock().findChildren<QToolButton*>())
            if (button->text() == "Save") save = button;
        // Checks whether there is something to save.
        const auto savable = [&](bool is) {
            return save->isEnabled() == is && action("Save scene or shader as…")->isEnabled();
        };
        QVERIFY(save && savable(false));
        const int steps = stack().count();
        const QPoint from(12, slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        for (int x = 0; x <= 60; x += 4) QTest::mouseMove(slider, from + QPoint(x, 0));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(60, 0));
        QCOMPARE(stack().count(), steps + 1);
        QCOMPARE(stack().undoText(), QString("Change radius of right"));
        const double dragged = number("radius");
        QVERIFY(dragged != 0.5);
        QTRY_VERIFY(savable(true));
        QCOMPARE(onDisk(), twoBalls);
        QVERIFY(document().starts_with(twoBalls.substr(0, twoBalls.rfind("0.50"))));
        stack().undo();
        QCOMPARE(number("radius"), 0.5);
        QCOMPARE(document(), twoBalls);
        QVERIFY(window_->docks().documentFile().unsaved().isEmpty());
        QTRY_COMPARE(document(), std::string());  // There are no edits left.
        QTRY_VERIFY(savable(false));
        QCOMPARE(number("radius"), 0.5);
        stack().redo();
        QCOMPARE(number("radius"), dragged);
        QCOMPARE(window_->docks().documentFile().unsaved(), QStringList("two.json"));

        QCOMPARE(action("Save")->shortcut(), QKeySequence("Ctrl+S"));
        action("Save")->trigger();
        QCOMPARE(onDisk().substr(0, 60), twoBalls.substr(0, 60));
        QVERIFY(onDisk() != twoBalls);
        QCOMPARE(document(), std::string());
        QTRY_VERIFY(window_->docks().documentFile().unsaved().isEmpty());
        // A saved edit can still be undone.
        stack().undo();
        QCOMPARE(number("radius"), 0.5);
        stack().redo();
        QTRY_COMPARE(number("radius"), dragged);

        // Another program saves the file: it is read within about a second, and the camera stays.
        if (!document().empty()) QVERIFY(window_->docks().documentFile().save());
        std::string other = twoBalls;
        other.replace(other.rfind("0.50"), 4, "0.8125");
        QTest::qWait(20);
        write(other);
        QTRY_COMPARE_WITH_TIMEOUT(number("radius"), 0.8125, patience);
        QCOMPARE(window_->history().sceneState().camera, camera);
        QCOMPARE(editor().selected(), std::string("root.children[1]"));
    }

    void longCtrlAndTheArrowsReorderTheTree()
    {
        click(at(1, 0));
        QCOMPARE(dock().view().currentItem()->text(0), QString("right"));
        const int steps = stack().count();
        QTest::keyClick(&dock().view(), Qt::Key_Down, Qt::ControlModifier);  // It is the last one.
        QTest::keyClick(&dock().view(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_COMPARE(editor().tree().nodes[1].name, std::string("right"));
        QCOMPARE(stack().count(), steps + 1);
        QCOMPARE(editor().selected(), std::string("root.children[0]"));
        QTest::keyClick(&dock().view(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_COMPARE(editor().tree().nodes[1].name, std::string("left"));
        stack().undo();
        stack().undo();
        QCOMPARE(stack().index(), steps);
    }

    void longHandlesMoveWhatIsSelectedInOneStep()
    {
        click(at(-1, 0));
        QCOMPARE(editor().selected(), std::string("root.children[0]"));
        const auto& handles = dock().overlay().handles();
        QVERIFY(handles.size() >= 2);
        QCOMPARE(handles[0].axis, 0);
        const QPoint end = handles[0].line.back().toPoint();
        const int steps = stack().count();
        auto* viewport = &window_->viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, end);
        for (int x = 0; x <= 40; x += 4) QTest::mouseMove(viewport, end + QPoint(x, 0));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, end + QPoint(40, 0));
        QCOMPARE(stack().count(), steps + 1);
        QVERIFY(number("translateX") > -0.9);
        QCOMPARE(number("translateY"), 0.0);
        // The ball moved as far as the pointer.
        const QPoint middle = at(number("translateX"), 0);
        QVERIFY2(std::abs(middle.x() - (at(-1, 0).x() + 40)) <= 2, qPrintable(QString::number(middle.x())));
        stack().undo();
        QCOMPARE(number("translateX"), -1.0);
    }

    void longTheTreeAddsWrapsRenamesHidesAndTakesBack()
    {
        editor().select("root.children[0]");
        QVERIFY(editor().apply({TreeEdit::What::wrap, "root.children[0]", "twist"}, "Wrap"));
        QCOMPARE(dock().view().topLevelItem(0)->childCount(), 2);
        QCOMPARE(dock().view().topLevelItem(0)->child(0)->text(0), QString("twist"));
        dock().view().topLevelItem(0)->child(1)->setText(0, "egg");
        QTRY_COMPARE(editor().tree().nodes[3].name, std::string("egg"));
        dock().view().topLevelItem(0)->child(1)->setCheckState(0, Qt::Unchecked);
        QTRY_VERIFY(editor().tree().nodes[3].hidden);
        dock().action(TreeEdit::What::duplicate)->trigger();
        QCOMPARE(editor().tree().nodes.size(), std::size_t(5));
        dock().action(TreeEdit::What::remove)->trigger();
        QCOMPARE(editor().tree().nodes.size(), std::size_t(4));
        for (int i = 0; i < 5; ++i) stack().undo();
        QCOMPARE(editor().tree().nodes.size(), std::size_t(3));
        QCOMPARE(document(), twoBalls);
    }

    void draggingReorders()
    {
        QTreeWidgetItem& root = *dock().view().topLevelItem(0);
        const TreeEdit below = TreeView::moveOf(*root.child(0), *root.child(1), 1);
        QCOMPARE(below.parent, std::string("root"));
        QCOMPARE(below.before, std::size_t(2));
        QCOMPARE(TreeView::moveOf(*root.child(1), *root.child(0), -1).before, std::size_t(0));
        QCOMPARE(TreeView::moveOf(*root.child(1), root, 0).parent, std::string("root"));
        QVERIFY(TreeView::moveOf(*root.child(1), root, -1).parent.empty());
        QVERIFY(editor().apply(below, "Move"));
        QCOMPARE(dock().view().topLevelItem(0)->child(1)->text(0), QString("left"));
        QCOMPARE(editor().selected(), std::string("root.children[1]"));
    }

    void whatMakesNoSenseIsSaidAndChangesNothing()
    {
        const int steps = stack().count();
        editor().select("root");
        dock().action(TreeEdit::What::remove)->trigger();
        QCOMPARE(stack().count(), steps);
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("root cannot be deleted"));
    }

    void longAFileThatTwoChangedIsAskedAbout()
    {
        for (const char* answer : {"keepMine", "takeTheirs"}) {
            editor().select("root.children[1]");
            editor().setParameter(0, 0.625, newGesture(), "Change");
            QCOMPARE(number("radius"), 0.625);
            std::string other = twoBalls;
            other.replace(other.rfind("0.50"), 4, answer[0] == 'k' ? "0.75" : "0.875");
            write(other);
            QTRY_VERIFY_WITH_TIMEOUT(question(), patience);
            question()->findChild<QPushButton*>(answer)->click();
            QTRY_VERIFY(!question());
            if (answer[0] == 'k') QCOMPARE(number("radius"), 0.625);
        }
        QTRY_COMPARE(number("radius"), 0.875);
        stack().undo();
        QCOMPARE(number("radius"), 0.625);
    }

    void closingAsksToSave()
    {
        editor().select("root.children[1]");
        editor().setParameter(0, 0.625, newGesture(), "Change");
        window_->close();
        QVERIFY(window_->isVisible());
        QVERIFY(question());
        question()->findChild<QPushButton*>("saveAndClose")->click();
        QTRY_VERIFY(!window_->isVisible());
        QVERIFY(onDisk().find("0.625") != std::string::npos);
        window_.reset();
    }

    void longSessionsBringWhatIsNotSavedBack()
    {
        editor().select("root.children[1]");
        editor().setParameter(0, 0.625, newGesture(), "Change");
        const std::string before = document();
        window_->close();
        question()->findChild<QPushButton*>("closeUnsaved")->click();
        QTRY_VERIFY(!window_->isVisible());
        window_.reset();
        openWindow();
        QCOMPARE(document(), before);
        QTRY_COMPARE(editor().tree().nodes.size(), std::size_t(3));
        editor().select("root.children[1]");
        QCOMPARE(number("radius"), 0.625);
    }

    void thePanelIsThereOnlyWithATree()
    {
        auto* panel = window_->findChild<QDockWidget*>("tree");
        QVERIFY(panel->toggleViewAction()->isEnabled());
        QVERIFY(!panel->isHidden());
        window_->visit(1);
        QVERIFY(panel->isHidden());
        QVERIFY(!panel->toggleViewAction()->isEnabled());
        window_->visit(scenes);
        QVERIFY(!panel->isHidden());
        QVERIFY(recentFiles().contains(path()));
    }
};

VITRINE_WINDOW_TEST(TreeWindowTest)

#include "tree_window_test.moc"
