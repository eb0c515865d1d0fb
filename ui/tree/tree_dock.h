#pragma once

#include "exhibits/framework/scene/tree.h"

#include <QHash>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

class KindMenu;
class TreeEditor;
class DocumentFile;
class TreeOverlay;
class TreeRowsView;
class TreeView;

/// Dock with the tree of the visited exhibit, the commands for its nodes, and the numbers of the selected node.
class TreeDock final : public QWidget {
    Q_OBJECT

public:
    /// All must outlive the dock.
    TreeDock(TreeEditor&, TreeOverlay&, DocumentFile&, QWidget* parent = nullptr);

    [[nodiscard]] TreeView& view() const { return *view_; }
    [[nodiscard]] TreeRowsView& rows() const { return *rows_; }
    [[nodiscard]] TreeEditor& editor() const { return editor_; }
    [[nodiscard]] TreeOverlay& overlay() const { return overlay_; }
    /// Returns the action of an edit.
    [[nodiscard]] QAction* action(TreeEdit::What what) const { return actions_.value(static_cast<int>(what)); }

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    QAction* add(TreeEdit::What, const QString& text, const QString& tip, const QKeySequence& = {});
    void addActions();
    [[nodiscard]] QWidget* bar();
    [[nodiscard]] QWidget* finder();
    void showNothing(bool);
    /// Fills a menu of kinds whenever it opens. `operations`: kinds that hold other nodes.
    void offerKinds(KindMenu*, TreeEdit::What, bool shapes, bool operations);
    void openMenu(const QPoint&);
    void apply(TreeEdit::What, const std::string& word = {});
    void enable();
    /// Returns the edit that adds a node to the selected one, or to the nearest node around it that takes children.
    [[nodiscard]] TreeEdit addition(const std::string& kind) const;
    [[nodiscard]] QString words(TreeEdit::What, const std::string& word) const;

    TreeEditor& editor_;
    TreeOverlay& overlay_;
    DocumentFile& file_;
    TreeView* view_;
    TreeRowsView* rows_;
    QLineEdit* words_;
    QVBoxLayout* layout_;
    QLabel* nothing_ = nullptr;  ///< Label for an empty search result; null if a node is found.
    QHash<int, QAction*> actions_;
    KindMenu *adds_, *wraps_, *kinds_;
    QToolButton* save_ = nullptr;
};

}  // namespace vitrine::ui
