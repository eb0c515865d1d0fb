#pragma once

#include "exhibits/framework/tree.h"

#include <QTreeWidget>

#include <string>

namespace vitrine::ui {

class TreeEditor;

/// The nodes of the exhibit's tree: a check mark shows or hides, dragging reorders, F2 renames.
class TreeView final : public QTreeWidget {
    Q_OBJECT

public:
    /// The editor must outlive it.
    explicit TreeView(TreeEditor&, QWidget* parent = nullptr);

    /// Null where there is no such node.
    [[nodiscard]] QTreeWidgetItem* itemOf(const std::string& node) const;
    [[nodiscard]] static std::string nodeOf(const QTreeWidgetItem&);
    /// What dropping one item on another means (`side` 0), or above it (-1) or below (1); no parent: nothing.
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
    void filter();
    [[nodiscard]] bool hasWords(const QTreeWidgetItem&) const;
    void showSelection();
    void takeEdit(QTreeWidgetItem*, int column);
    /// Ctrl with the arrows: up and down among its siblings, out of its parent, into the one above. False: it cannot go
    /// there.
    bool moveByKey(int key);
    void startMove(const QTreeWidgetItem& moved, QTreeWidgetItem& target, int side);

    TreeEditor& editor_;
    QStringList words_;
    bool filling_ = false;
};

}  // namespace vitrine::ui
