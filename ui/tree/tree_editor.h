#pragma once

#include "exhibits/framework/scene/tree.h"
#include "ui/model/history.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <string>

namespace vitrine::ui {

class Workbench;

/// Tree of the visited exhibit and its selected node. Their changes are steps of the history.
class TreeEditor final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object.
    explicit TreeEditor(Workbench&, QObject* parent = nullptr);

    void setSubject(std::size_t exhibit);
    [[nodiscard]] std::size_t subject() const { return subject_; }
    /// Returns the exhibit's interface to its tree; null if it has none.
    [[nodiscard]] const HasTree* source() const { return source_; }
    [[nodiscard]] const ParameterValues& values() const;
    [[nodiscard]] const Tree& tree() const { return tree_; }
    /// Returns the id of the selected node; empty: none.
    [[nodiscard]] const std::string& selected() const { return selected_; }
    /// Selects a node. Selects nothing if there is no such node.
    void select(const std::string& node);

    /// Makes an edit and selects its node. Returns whether it was made; otherwise a message says why not.
    bool apply(const TreeEdit&, const QString& text);
    /// Sets a number of the selected node.
    void setParameter(std::size_t row, const Value&, Gesture, const QString& text);
    /// Moves, turns or scales the selected node.
    void setPlace(const TreePlace& from, const TreePlace& to, Gesture, const QString& text);
    /// Returns the title of the selected node for texts of undo steps, such as "ball".
    [[nodiscard]] QString selectedTitle() const;

signals:
    /// Emitted when the nodes, or the exhibit, changed.
    void treeChanged();
    void selectionChanged();
    /// Emitted when values of the exhibit changed, including those of nodes.
    void valuesChanged();
    /// Emitted when the selected node was requested to be shown.
    void shown();

private:
    /// Follows the changes of the subject, and of no other.
    void watch();
    void refresh();
    /// Copies the text of the file to the document parameter, so that edits can be undone whatever happens to the file.
    void beginDocument();
    void change(const ParameterValues&, Gesture, const QString& text);

    Workbench& window_;
    const HasTree* source_ = nullptr;
    std::size_t subject_ = 0;
    QMetaObject::Connection watched_;
    Tree tree_;
    std::shared_ptr<const Parameters> table_;  ///< Table from which the tree was made.
    std::string selected_;
    std::vector<std::string> selectedBefore_;  ///< Ids of nodes, the latest last.
};

}  // namespace vitrine::ui
