#pragma once

#include "exhibits/framework/scene/tree.h"

#include <QTreeWidget>

#include <string>

namespace vitrine::ui {

class TreeEditor;

/// Tree of the exhibit's nodes: a check mark shows or hides, dragging reorders, F2 renames.
class TreeView final : public QTreeWidget {
    Q_OBJECT

public:
    /// The editor must outlive the view.
    explicit TreeView(TreeEditor&, QWidget* parent = nullptr);

    /// Returns the item of a node; null if there is no such node.
    [[nodiscard]] QTreeWidgetItem* itemOf(const std::string& node) const;
    [[nodiscard]] static std::string nodeOf(const QTreeWidgetItem&);
    /// Returns the edit for dropping one item on another (`side` 0), above it (-1) or below it (1). Without a parent
    /// the edit does nothing.
    [[nodiscard]] static TreeEdit moveOf(const QTreeWidgetItem& dragged, QTreeWidgetItem& target, int side);
    /// Shows only nodes whose name or kind contains all these words, with their parents. No words: all nodes.
    void setWords(const QString&);
    /// Selects the first node that has the words and gives the focus to the tree.
    void goToFirst();

signals:
    /// `some`: at least one node has the words.
    void filtered(bool some);

protected:
    bool event(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    void rebuild();
    /// Shows the kind and the first real number of a node beside its title, for example "radius 0.42 m". Called for
    /// nodes whose title another one has, too.
    void showSize(QTreeWidgetItem&) const;
    void showSelectedSize();
    void filter();
    [[nodiscard]] bool hasWords(const QTreeWidgetItem&) const;
    void showSelection();
    void takeEdit(QTreeWidgetItem*, int column);
    /// Moves the selected node with Ctrl and an arrow key: up and down among its siblings, out of its parent, or into
    /// the node above. Returns false if that is impossible.
    bool moveByKey(int key);
    void startMove(const QTreeWidgetItem& moved, QTreeWidgetItem& target, int side);

    TreeEditor& editor_;
    QStringList words_;
    bool filling_ = false;
};

}  // namespace vitrine::ui
