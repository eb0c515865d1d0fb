#include "ui/tree/tree_dock.h"

#include "ui/editor/document_file.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/tree/kind_menu.h"
#include "ui/tree/tree_editor.h"
#include "ui/tree/tree_overlay.h"
#include "ui/tree/tree_rows.h"
#include "ui/tree/tree_view.h"

#include <QAction>
#include <QActionGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>
#include <utility>

namespace vitrine::ui {

using What = TreeEdit::What;

TreeDock::TreeDock(TreeEditor& editor, TreeOverlay& overlay, DocumentFile& file, QWidget* parent)
    : QWidget(parent), editor_(editor), overlay_(overlay), file_(file), view_(new TreeView(editor, this)),
      rows_(new TreeRowsView(editor, this)), words_(new QLineEdit(this)), layout_(new QVBoxLayout(this)),
      adds_(new KindMenu(tr("Add"), this)), wraps_(new KindMenu(tr("Wrap in"), this)),
      kinds_(new KindMenu(tr("Change kind"), this))
{
    addActions();
    offerKinds(adds_, What::add, true, true);
    offerKinds(wraps_, What::wrap, false, true);
    offerKinds(kinds_, What::kind, true, true);
    auto* parts = new QSplitter(Qt::Vertical);
    parts->addWidget(view_);
    parts->addWidget(rows_);
    parts->setChildrenCollapsible(false);
    parts->setSizes({220, 320});
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(0);
    layout_->addWidget(bar());
    layout_->addWidget(finder());
    layout_->addWidget(parts, 1);
    followType(*this, [this] { setMinimumWidth(std::max(320, grown(296, *this))); });
    connect(view_, &QWidget::customContextMenuRequested, this, &TreeDock::openMenu);
    connect(&editor_, &TreeEditor::selectionChanged, this, &TreeDock::enable);
    connect(&editor_, &TreeEditor::treeChanged, this, &TreeDock::enable);
    connect(&editor_, &TreeEditor::valuesChanged, this, &TreeDock::enable);
    enable();
}

QAction* TreeDock::add(What what, const QString& text, const QString& tip, const QKeySequence& key)
{
    auto* action = new QAction(text, this);
    action->setToolTip(tip);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    view_->addAction(action);
    connect(action, &QAction::triggered, this, [this, what] { apply(what); });
    actions_.insert(static_cast<int>(what), action);
    return action;
}

void TreeDock::addActions()
{
    add(What::duplicate, tr("Duplicate"), tr("Duplicates the node; the copy follows it."),
        QKeySequence(Qt::CTRL | Qt::Key_D));
    add(What::remove, tr("Delete"), tr("Deletes the node with everything in it."), QKeySequence(Qt::Key_Delete));
    add(What::unwrap, tr("Unwrap"), tr("Replaces the operation by its only child."));
    add(What::solo, tr("Solo"), tr("Shows only this node and hides all others."));
    add(What::showAll, tr("Show all"), tr("Shows all nodes again."));
    auto* rename = new QAction(tr("Rename\tF2"), this);
    connect(rename, &QAction::triggered, this, [this] {
        if (view_->currentItem()) view_->editItem(view_->currentItem(), 0);
    });
    actions_.insert(static_cast<int>(What::rename), rename);
}

QWidget* TreeDock::bar()
{
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(4);
    const auto button = [&](const QString& text, const QString& tip) {
        auto* made = new QToolButton;
        made->setText(text);
        made->setToolTip(tip);
        made->setAccessibleName(text);
        made->setFocusPolicy(Qt::StrongFocus);
        growHeight(*made, 26);
        layout->addWidget(made);
        return made;
    };
    auto* adds = button(tr("Add"), tr("Adds a shape or an operation to the selected one, or beside it."));
    adds->setMenu(adds_);
    adds->setPopupMode(QToolButton::InstantPopup);
    auto* wraps = button(tr("Wrap"), tr("Wraps the selected node in an operation."));
    wraps->setMenu(wraps_);
    wraps->setPopupMode(QToolButton::InstantPopup);
    save_ = button(tr("Save"), tr("Writes your edits to the scene file."));
    connect(save_, &QToolButton::clicked, this, [this] { file_.save(); });
    layout->addStretch(1);
    auto* group = new QActionGroup(this);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (const auto& [mode, text, key] :
         {std::tuple{HandleMode::move, tr("Move"), Qt::Key_1}, std::tuple{HandleMode::turn, tr("Turn"), Qt::Key_2},
          std::tuple{HandleMode::scale, tr("Scale"), Qt::Key_3}}) {
        auto* action = new QAction(text, group);
        action->setCheckable(true);
        action->setChecked(mode == overlay_.mode());
        action->setShortcut(QKeySequence(key));
        action->setShortcutContext(Qt::WidgetShortcut);
        action->setToolTip(
            tr("Handles in the picture; %1 while the picture has the focus.").arg(QKeySequence(key).toString()));
        overlay_.parentWidget()->addAction(action);
        connect(action, &QAction::toggled, this, [this, group, mode = mode](bool on) {
            if (on) overlay_.setMode(mode);
            if (!group->checkedAction()) overlay_.setMode(HandleMode::none);
        });
        auto* made = button(text, action->toolTip());
        made->setDefaultAction(action);
    }
    return bar;
}

QWidget* TreeDock::finder()
{
    words_->setPlaceholderText(tr("Find a node"));
    words_->setAccessibleName(tr("Find a node"));
    words_->setToolTip(
        tr("Shows only nodes whose name or kind contains these words. Enter goes to the first, Esc clears."));
    words_->setProperty(IdleUndo::searches, true);
    words_->setClearButtonEnabled(true);
    growHeight(*words_, 26);
    words_->setTextMargins(4, 0, 4, 0);
    words_->installEventFilter(this);
    connect(words_, &QLineEdit::textChanged, view_, &TreeView::setWords);
    connect(view_, &TreeView::filtered, this, [this](bool some) { showNothing(!some); });
    auto* finder = new QWidget;
    auto* layout = new QHBoxLayout(finder);
    layout->setContentsMargins(8, 0, 8, 6);
    layout->addWidget(words_);
    return finder;
}

void TreeDock::showNothing(bool on)
{
    // A hidden label would still be read by screen readers.
    if (!on) {
        delete std::exchange(nothing_, nullptr);
    } else if (!nothing_) {
        nothing_ = new QLabel(tr("No node matches."), this);
        nothing_->setAlignment(Qt::AlignCenter);
        layout_->insertWidget(layout_->count() - 1, nothing_);
    }
}

bool TreeDock::eventFilter(QObject* object, QEvent* event)
{
    if (object != words_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(object, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Escape:
        if (words_->text().isEmpty()) return false;
        words_->clear();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Down: view_->goToFirst(); return true;
    default: return false;
    }
}

QString TreeDock::words(What what, const std::string& word) const
{
    const QString node = editor_.selectedTitle(), kind = QString::fromStdString(word);
    switch (what) {
    case What::add: return tr("Add %1").arg(kind);
    case What::duplicate: return tr("Duplicate %1").arg(node);
    case What::remove: return tr("Delete %1").arg(node);
    case What::wrap: return tr("Wrap %1 in %2").arg(node, kind);
    case What::unwrap: return tr("Unwrap %1").arg(node);
    case What::solo: return tr("Show %1 alone").arg(node);
    case What::showAll: return tr("Show all nodes");
    case What::kind: return tr("Make %1 a %2").arg(node, kind);
    default: return tr("Change the tree");
    }
}

TreeEdit TreeDock::addition(const std::string& kind) const
{
    const Tree& tree = editor_.tree();
    TreeEdit edit{What::add, "root", kind};
    for (std::size_t at = tree.find(editor_.selected()); at != TreeNode::none; at = tree.nodes[at].parent) {
        edit.node = tree.nodes[at].id;
        if (tree.nodes[at].takesChildren) break;
    }
    return edit;
}

void TreeDock::apply(What what, const std::string& word)
{
    const TreeEdit edit = what == What::add ? addition(word) : TreeEdit{what, editor_.selected(), word};
    editor_.apply(edit, words(what, word));
}

void TreeDock::offerKinds(KindMenu* menu, What what, bool shapes, bool operations)
{
    connect(menu, &KindMenu::chosen, this, [this, what](const std::string& kind) { apply(what, kind); });
    connect(menu, &QMenu::aboutToShow, this, [this, menu, what, shapes, operations] {
        const Tree& tree = editor_.tree();
        const std::size_t index = tree.find(editor_.selected());
        const auto isOperation = [&](const TreeKind& kind) {
            return index != TreeNode::none && kind.operation && kind.name == tree.nodes[index].kind;
        };
        const bool ofOperation = std::any_of(tree.kinds.begin(), tree.kinds.end(), isOperation);
        std::vector<TreeKind> offered;
        for (const TreeKind& kind : tree.kinds) {
            if (kind.operation ? !operations : !shapes) continue;
            // The kind of a shape can change to other shapes only.
            if (what == What::kind && kind.operation != ofOperation) continue;
            offered.push_back(kind);
        }
        menu->offer(offered);
    });
}

void TreeDock::openMenu(const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addMenu(adds_);
    menu->addMenu(wraps_);
    menu->addMenu(kinds_);
    menu->addSeparator();
    for (const What what : {What::duplicate, What::remove, What::unwrap, What::rename}) menu->addAction(action(what));
    menu->addSeparator();
    for (const What what : {What::solo, What::showAll}) menu->addAction(action(what));
    menu->popup(view_->viewport()->mapToGlobal(at));
}

void TreeDock::enable()
{
    const bool some = !editor_.selected().empty();
    for (const What what : {What::duplicate, What::remove, What::unwrap, What::rename, What::solo})
        action(what)->setEnabled(some);
    for (QMenu* menu : {wraps_, kinds_}) menu->setEnabled(some);
    adds_->setEnabled(editor_.source() != nullptr);
    action(What::showAll)->setEnabled(editor_.source() != nullptr);
    save_->setEnabled(file_.edited());
}

}  // namespace vitrine::ui

#include "moc_tree_dock.cpp"
