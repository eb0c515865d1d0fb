#include "ui/tree/tree_view.h"

#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/parameters/shown_text.h"
#include "ui/tree/tree_editor.h"

#include <QDropEvent>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostUnfolded = 500;  ///< Number of nodes. Larger trees are unfolded to the first level only.

}  // namespace

TreeView::TreeView(TreeEditor& editor, QWidget* parent) : QTreeWidget(parent), editor_(editor)
{
    setAccessibleName(tr("Tree"));
    setColumnCount(2);
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setDragDropMode(QAbstractItemView::InternalMove);
    setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    setExpandsOnDoubleClick(false);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(true);
    header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    connect(&editor_, &TreeEditor::treeChanged, this, &TreeView::rebuild);
    connect(&editor_, &TreeEditor::selectionChanged, this, &TreeView::showSelection);
    connect(&editor_, &TreeEditor::valuesChanged, this, &TreeView::showSelectedSize);
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!filling_) editor_.select(item ? nodeOf(*item) : std::string());
    });
    connect(this, &QTreeWidget::itemChanged, this, &TreeView::takeEdit);
    rebuild();
}

std::string TreeView::nodeOf(const QTreeWidgetItem& item)
{
    return item.data(0, Qt::UserRole).toString().toStdString();
}

QTreeWidgetItem* TreeView::itemOf(const std::string& node) const
{
    const QString wanted = QString::fromStdString(node);
    for (QTreeWidgetItemIterator it(const_cast<TreeView*>(this)); *it; ++it)
        if ((*it)->data(0, Qt::UserRole).toString() == wanted) return *it;
    return nullptr;
}

void TreeView::rebuild()
{
    filling_ = true;
    clear();
    std::vector<QTreeWidgetItem*> items;
    std::map<std::string_view, std::vector<QTreeWidgetItem*>> nodesOfTitle;
    QTreeWidgetItem* shared = nullptr;
    for (const TreeNode& node : editor_.tree().nodes) {
        QTreeWidgetItem* item = nullptr;
        if (node.parent != TreeNode::none) {
            item = new QTreeWidgetItem(items[node.parent]);
        } else if (node.shared) {
            if (!shared) {
                shared = new QTreeWidgetItem(this, {tr("Definitions")});
                shared->setFlags(Qt::ItemIsEnabled);
            }
            item = new QTreeWidgetItem(shared);
        } else {
            item = new QTreeWidgetItem(this);
        }
        item->setData(0, Qt::UserRole, QString::fromStdString(node.id));
        item->setText(0, text(Tree::title(node)));
        item->setText(1, node.name.empty() ? QString() : text(node.kind));
        nodesOfTitle[Tree::title(node)].push_back(item);
        item->setCheckState(0, node.hidden ? Qt::Unchecked : Qt::Checked);
        item->setToolTip(
            0, tr("The check mark shows or hides it. Drag it, or press Ctrl and the arrows, to reorder; F2 renames."));
        Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsUserCheckable;
        if (node.movable) flags |= Qt::ItemIsDragEnabled;
        if (node.takesChildren) flags |= Qt::ItemIsDropEnabled;
        item->setFlags(flags);
        items.push_back(item);
    }
    for (const auto& [title, alike] : nodesOfTitle)
        for (std::size_t i = 0; alike.size() > 1 && items.size() <= mostUnfolded && i < alike.size(); ++i) {
            alike[i]->setData(1, Qt::UserRole, true);
            showSize(*alike[i]);
        }
    if (items.size() <= mostUnfolded)
        expandAll();
    else
        expandToDepth(0);
    filling_ = false;
    filter();
    showSelection();
}

void TreeView::showSize(QTreeWidgetItem& item) const
{
    const TreeNode& node = editor_.tree().nodes[editor_.tree().find(nodeOf(item))];
    const std::optional<TreeParameters> rows = editor_.source()->parametersOf(editor_.values(), node.id);
    QString size;
    for (std::size_t i = 0; rows && size.isEmpty() && i < rows->values.rows().size(); ++i) {
        const ParameterInfo& info = rows->values.rows()[i];
        if (info.kind == Kind::real)
            size = translatedText(label(info)) + QLatin1Char(' ') + shownText(info, rows->values.row(i));
    }
    const QString kind = node.name.empty() ? QString() : text(node.kind);
    item.setText(1, kind.isEmpty() || size.isEmpty() ? kind + size : kind + QStringLiteral(", ") + size);
}

void TreeView::showSelectedSize()
{
    QTreeWidgetItem* item = editor_.selected().empty() ? nullptr : itemOf(editor_.selected());
    if (item && item->data(1, Qt::UserRole).toBool()) showSize(*item);
}

void TreeView::setWords(const QString& words)
{
    words_ = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    filter();
    if (QTreeWidgetItem* item = currentItem()) scrollToItem(item);
}

bool TreeView::hasWords(const QTreeWidgetItem& item) const
{
    return std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
        return item.text(0).contains(word, Qt::CaseInsensitive) || item.text(1).contains(word, Qt::CaseInsensitive);
    });
}

void TreeView::filter()
{
    bool some = false;
    for (QTreeWidgetItemIterator it(this); *it; ++it) (*it)->setHidden(!words_.isEmpty());
    for (QTreeWidgetItemIterator it(this); *it; ++it) {
        if (words_.isEmpty() || nodeOf(**it).empty() || !hasWords(**it)) continue;
        some = true;
        for (QTreeWidgetItem* shown = *it; shown; shown = shown->parent()) {
            shown->setHidden(false);
            if (shown != *it) shown->setExpanded(true);
        }
    }
    emit filtered(some || words_.isEmpty());
}

void TreeView::goToFirst()
{
    for (QTreeWidgetItemIterator it(this); *it; ++it) {
        if ((*it)->isHidden() || nodeOf(**it).empty() || !hasWords(**it)) continue;
        setCurrentItem(*it);
        setFocus(Qt::ShortcutFocusReason);
        return;
    }
}

void TreeView::showSelection()
{
    filling_ = true;
    QTreeWidgetItem* item = editor_.selected().empty() ? nullptr : itemOf(editor_.selected());
    setCurrentItem(item);
    if (item) scrollToItem(item);
    filling_ = false;
}

void TreeView::takeEdit(QTreeWidgetItem* item, int column)
{
    if (filling_ || column != 0) return;
    const std::size_t index = editor_.tree().find(nodeOf(*item));
    if (index == TreeNode::none) return;
    const TreeNode node = editor_.tree().nodes[index];
    const QString title = text(Tree::title(node));
    const bool hidden = item->checkState(0) == Qt::Unchecked;
    const QString typed = item->text(0).trimmed();
    if (hidden == node.hidden && typed == title) return;
    // Queued: the change rebuilds the tree, which must not happen while an item is being edited.
    QMetaObject::invokeMethod(
        this,
        [this, node, title, hidden, typed] {
            const bool made =
                hidden != node.hidden
                    ? editor_.apply({hidden ? TreeEdit::What::hide : TreeEdit::What::show, node.id},
                                    hidden ? tr("Hide %1").arg(title) : tr("Show %1").arg(title))
                    : editor_.apply({TreeEdit::What::rename, node.id, typed.toStdString()}, tr("Rename %1").arg(title));
            if (!made) rebuild();
        },
        Qt::QueuedConnection);
}

bool TreeView::event(QEvent* event)
{
    // F2 renames while the tree has the focus, whatever the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F2) {
        event->accept();
        return true;
    }
    return QTreeWidget::event(event);
}

void TreeView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_F2 && currentItem()) {
        editItem(currentItem(), 0);
        return;
    }
    if (event->key() == Qt::Key_Escape) {
        editor_.select({});
        return;
    }
    if (event->modifiers() == Qt::ControlModifier && moveByKey(event->key())) return;
    QTreeWidget::keyPressEvent(event);
}

TreeEdit TreeView::moveOf(const QTreeWidgetItem& dragged, QTreeWidgetItem& target, int side)
{
    TreeEdit edit{TreeEdit::What::move, nodeOf(dragged)};
    if (side == 0) {
        edit.parent = nodeOf(target);
    } else if (const QTreeWidgetItem* parent = target.parent()) {
        edit.parent = nodeOf(*parent);
        edit.before = static_cast<std::size_t>(parent->indexOfChild(&target) + (side > 0 ? 1 : 0));
    }
    return edit;
}

void TreeView::dropEvent(QDropEvent* event)
{
    // Items are not moved here: the edit rebuilds the tree.
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    const QTreeWidgetItem* dragged = currentItem();
    QTreeWidgetItem* target = itemAt(event->position().toPoint());
    if (!dragged || !target || event->source() != this) return;
    startMove(*dragged, *target, dropIndicatorPosition() == OnItem ? 0 : dropIndicatorPosition() == AboveItem ? -1 : 1);
}

bool TreeView::moveByKey(int key)
{
    const QTreeWidgetItem* item = currentItem();
    QTreeWidgetItem* parent = item ? item->parent() : nullptr;
    if (!parent || !(item->flags() & Qt::ItemIsDragEnabled)) return false;
    const int at = parent->indexOfChild(const_cast<QTreeWidgetItem*>(item));
    QTreeWidgetItem* above = parent->child(at - 1);
    QTreeWidgetItem* below = parent->child(at + 1);
    const bool takes = above && (above->flags() & Qt::ItemIsDropEnabled);
    if (key == Qt::Key_Up && above)
        startMove(*item, *above, -1);
    else if (key == Qt::Key_Down && below)
        startMove(*item, *below, 1);
    else if (key == Qt::Key_Left && parent->parent())
        startMove(*item, *parent, 1);
    else if (key == Qt::Key_Right && takes)
        startMove(*item, *above, 0);
    else
        return false;
    return true;
}

void TreeView::startMove(const QTreeWidgetItem& moved, QTreeWidgetItem& target, int side)
{
    const TreeEdit edit = moveOf(moved, target, side);
    if (edit.parent.empty()) return;
    const QString title = moved.text(0);
    QMetaObject::invokeMethod(
        this, [this, edit, title] { editor_.apply(edit, tr("Move %1").arg(title)); }, Qt::QueuedConnection);
}

}  // namespace vitrine::ui

#include "moc_tree_view.cpp"
