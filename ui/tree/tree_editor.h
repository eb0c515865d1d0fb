#pragma once

#include "exhibits/framework/tree.h"
#include "ui/model/history.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <string>

namespace vitrine::ui {

class Workbench;

/// The tree of the visited exhibit, the node that is selected in it, and their changes as steps of the history.
class TreeEditor final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive it.
    explicit TreeEditor(Workbench&, QObject* parent = nullptr);

    void setSubject(std::size_t exhibit);
    [[nodiscard]] std::size_t subject() const { return subject_; }
    /// The exhibit's; null where it has no tree.
    [[nodiscard]] const HasTree* source() const { return source_; }
    [[nodiscard]] const ParameterValues& values() const;
    [[nodiscard]] const Tree& tree() const { return tree_; }
    /// Its id; empty: none.
    [[nodiscard]] const std::string& selected() const { return selected_; }
    /// Selects nothing where there is no such node.
    void select(const std::string& node);

    /// Makes a change, selects the node that it was about, and says why where it makes no sense. Returns whether it was
    /// made.
    bool apply(const TreeEdit&, const QString& text);
    /// Sets a number of the selected node.
    void setRow(std::size_t row, const Value&, Gesture, const QString& text);
    /// The same of its place.
    void setPlace(const TreePlace& from, const TreePlace& to, Gesture, const QString& text);
    /// "ball", for the texts of steps.
    [[nodiscard]] QString selectedTitle() const;

signals:
    /// Other nodes, or another exhibit.
    void treeChanged();
    void selectionChanged();
    /// Values of the exhibit, those of its nodes among them.
    void valuesChanged();
    /// Somebody asked to see the selected node.
    void shown();

private:
    void refresh();
    /// From now on the document says what the file says, so that what changes it can be undone whatever becomes of the
    /// file.
    void beginDocument();
    void change(const ParameterValues&, Gesture, const QString& text);

    Workbench& window_;
    const HasTree* source_ = nullptr;
    std::size_t subject_ = 0;
    Tree tree_;
    std::shared_ptr<const Parameters> table_;  ///< That the tree was made of.
    std::string selected_;
    std::string selectedBefore_;
};

}  // namespace vitrine::ui
