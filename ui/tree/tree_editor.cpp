#include "ui/tree/tree_editor.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/museum/museum.h"
#include "render/failure.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/model/workbench.h"

#include <utility>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostRemembered = 64;  ///< Number of earlier selections.

/// Returns the cause of problems of editing the tree. They are removed by the next successful edit.
QString treeEditCause()
{
    return QStringLiteral("editing of the tree");
}

}  // namespace

TreeEditor::TreeEditor(Workbench& window, QObject* parent) : QObject(parent), window_(window)
{
    watch();
}

void TreeEditor::watch()
{
    disconnect(watched_);
    watched_ = window_.history().watch(subject_, this, [this](std::optional<std::size_t>) { refresh(); });
}

const ParameterValues& TreeEditor::values() const
{
    return window_.history().sceneState().values[subject_];
}

void TreeEditor::setSubject(std::size_t exhibit)
{
    if (subject_ == exhibit) return;
    subject_ = exhibit;
    watch();
    source_ = capability<HasTree>(window_.museum().subject(exhibit));
    table_.reset();
    tree_ = {};
    selected_.clear();
    selectedBefore_.clear();
    refresh();
    emit treeChanged();
    emit selectionChanged();
}

void TreeEditor::refresh()
{
    if (!source_) return;
    if (table_ != values().sharedTable()) {
        table_ = values().sharedTable();
        Tree now = source_->tree(values());
        const bool another = now.nodes != tree_.nodes;
        tree_ = std::move(now);
        if (another) emit treeChanged();
    }
    // If an undo removed the selected node, the latest one selected before it that still exists is selected again.
    if (!selected_.empty() && tree_.find(selected_) == TreeNode::none) {
        while (!selectedBefore_.empty() && tree_.find(selectedBefore_.back()) == TreeNode::none)
            selectedBefore_.pop_back();
        selected_ = selectedBefore_.empty() ? std::string() : selectedBefore_.back();
        if (!selectedBefore_.empty()) selectedBefore_.pop_back();
        emit selectionChanged();
    }
    emit valuesChanged();
}

void TreeEditor::select(const std::string& node)
{
    const std::string wanted = tree_.find(node) == TreeNode::none ? std::string() : node;
    if (wanted == selected_) return;
    if (!selected_.empty()) {
        if (selectedBefore_.size() == mostRemembered) selectedBefore_.erase(selectedBefore_.begin());
        selectedBefore_.push_back(selected_);
    }
    selected_ = wanted;
    emit selectionChanged();
}

QString TreeEditor::selectedTitle() const
{
    const std::size_t index = tree_.find(selected_);
    return index == TreeNode::none ? QString() : text(Tree::title(tree_.nodes[index]));
}

void TreeEditor::beginDocument()
{
    SceneState begun = window_.history().sceneState();
    const DocumentPlace document = source_->document(values());
    if (!std::get<std::string>(values().row(document.document)).empty()) return;
    begun.values[subject_].setParameter(document.document, source_->documentText(values()));
    window_.history().settle(begun);
}

void TreeEditor::change(const ParameterValues& values, Gesture gesture, const QString& text)
{
    SceneState after = window_.history().sceneState();
    after.values[subject_] = values;
    window_.history().change(text, after, gesture);
}

bool TreeEditor::apply(const TreeEdit& edit, const QString& text)
{
    if (!source_) return false;
    try {
        render::AssetStore assets = window_.museum().assets();
        EditedTree made = source_->edited(values(), edit, assets);
        window_.setProblems(treeEditCause(), {});
        beginDocument();
        change(made.values, 0, text);
        select(made.node);
        return true;
    } catch (const Failure& failure) {
        window_.setProblems(treeEditCause(), {});
        window_.setProblems(treeEditCause(), {translatedText(failure.message())});
        return false;
    }
}

void TreeEditor::setParameter(std::size_t row, const Value& value, Gesture gesture, const QString& text)
{
    if (!source_ || selected_.empty()) return;
    try {
        render::AssetStore assets = window_.museum().assets();
        const ParameterValues next = source_->withParameter(values(), selected_, row, value, assets);
        window_.setProblems(treeEditCause(), {});
        beginDocument();
        change(next, gesture, text);
    } catch (const Failure& failure) {
        window_.setProblems(treeEditCause(), {});
        window_.setProblems(treeEditCause(), {translatedText(failure.message())});
        emit valuesChanged();
    }
}

void TreeEditor::setPlace(const TreePlace& from, const TreePlace& to, Gesture gesture, const QString& text)
{
    if (!source_ || selected_.empty()) return;
    try {
        render::AssetStore assets = window_.museum().assets();
        const ParameterValues next = source_->withPlace(values(), selected_, from, to, assets);
        window_.setProblems(treeEditCause(), {});
        beginDocument();
        change(next, gesture, text);
    } catch (const Failure& failure) {
        window_.setProblems(treeEditCause(), {});
        window_.setProblems(treeEditCause(), {translatedText(failure.message())});
    }
}

}  // namespace vitrine::ui

#include "moc_tree_editor.cpp"
