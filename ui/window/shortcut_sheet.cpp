#include "ui/window/shortcut_sheet.h"

#include "ui/kit/menu_text.h"
#include "ui/kit/type_size.h"

#include <QAction>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

void addHeading(QTreeWidget& tree, const QString& text)
{
    auto* item = new QTreeWidgetItem(&tree, {text});
    QFont bold = item->font(0);
    bold.setWeight(QFont::DemiBold);
    item->setFont(0, bold);
    item->setFlags(Qt::ItemIsEnabled);
}

void addLine(QTreeWidget& tree, const QString& keys, const QString& what)
{
    new QTreeWidgetItem(&tree, {keys, what});
}

void addPad(QTreeWidget& tree)
{
    addHeading(tree, ShortcutSheet::tr("With a gamepad"));
    addLine(tree, ShortcutSheet::tr("Left stick"),
            ShortcutSheet::tr("Walk; the right trigger, or pressing the stick, runs"));
    addLine(tree, ShortcutSheet::tr("Right stick"), ShortcutSheet::tr("Look around, or around the exhibit"));
    addLine(tree, ShortcutSheet::tr("Triggers"), ShortcutSheet::tr("Come nearer to the exhibit, or step back"));
    addLine(tree, QStringLiteral("A"),
            ShortcutSheet::tr("Visit what is in the middle of the picture, or press its button"));
    addLine(tree, QStringLiteral("B"), ShortcutSheet::tr("Leave the exhibit and walk on"));
    addLine(tree, QStringLiteral("X"), ShortcutSheet::tr("Press the red button"));
    addLine(tree, QStringLiteral("Y"), ShortcutSheet::tr("Return to where you stood before"));
    addLine(tree, ShortcutSheet::tr("Directional pad up, down"), ShortcutSheet::tr("Choose a parameter"));
    addLine(tree, ShortcutSheet::tr("Directional pad left, right"),
            ShortcutSheet::tr("Change the value, like the arrow keys"));
    addLine(tree, ShortcutSheet::tr("Shoulder buttons"), ShortcutSheet::tr("Visit the previous or the next exhibit"));
    addLine(tree, ShortcutSheet::tr("Start button"), ShortcutSheet::tr("Stop and start the exhibits' clock"));
    addLine(tree, ShortcutSheet::tr("In dialogs and menus"),
            ShortcutSheet::tr("The directional pad moves, A presses, B closes"));
}

/// Adds what keys, mouse and gamepad do beside the menus' commands.
void addUsual(QTreeWidget& tree)
{
    addHeading(tree, ShortcutSheet::tr("In the museum"));
    addLine(tree, ShortcutSheet::tr("W A S D, arrows"), ShortcutSheet::tr("Walk; Shift runs"));
    addLine(tree, ShortcutSheet::tr("Drag; Ctrl and arrows"), ShortcutSheet::tr("Look around, or around the exhibit"));
    addLine(tree, ShortcutSheet::tr("Right drag"), ShortcutSheet::tr("Look around with the pointer locked"));
    addLine(tree, ShortcutSheet::tr("Click"), ShortcutSheet::tr("Visit an exhibit, press a button"));
    addLine(tree, ShortcutSheet::tr("Enter"), ShortcutSheet::tr("The same with what is in the middle of the picture"));
    addLine(tree, ShortcutSheet::tr("Wheel, + and −"), ShortcutSheet::tr("Come nearer to the exhibit or step back"));
    addLine(tree, QStringLiteral("E"),
            ShortcutSheet::tr("Press the red button you look at, or that of the exhibit you visit"));
    addLine(tree, QStringLiteral("Esc"), ShortcutSheet::tr("Leave the exhibit and walk on"));
    addLine(tree, ShortcutSheet::tr("Backspace, Alt+Left"), ShortcutSheet::tr("Return to where you stood before"));
    addLine(tree, ShortcutSheet::tr("I, held"),
            ShortcutSheet::tr("Show color, light, position, normal, distance and cost of the pixel below the pointer"));
    addLine(tree, ShortcutSheet::tr("1 to 9"), ShortcutSheet::tr("Glide to that bookmark"));
    addLine(tree, ShortcutSheet::tr("F6, Shift+F6"),
            ShortcutSheet::tr("Move the focus to the next or the previous panel"));
    addHeading(tree, ShortcutSheet::tr("In the tree"));
    addLine(tree, ShortcutSheet::tr("Ctrl and arrows"),
            ShortcutSheet::tr("Move the node: up, down, out of its parent, into the one above"));
    addPad(tree);
    addHeading(tree, ShortcutSheet::tr("While two settings are compared"));
    addLine(tree, ShortcutSheet::tr("B, held"), ShortcutSheet::tr("Show B instead of A"));
    addLine(tree, ShortcutSheet::tr("Drag the line; comma, period"), ShortcutSheet::tr("Move the wipe"));
    addHeading(tree, ShortcutSheet::tr("In number fields"));
    addLine(tree, ShortcutSheet::tr("Drag the label or the number"),
            ShortcutSheet::tr("Change the value; Shift ten times finer, Ctrl ten times coarser"));
    addLine(tree, ShortcutSheet::tr("Click, or any digit"), ShortcutSheet::tr("Type: 1/3, 2*pi, 30deg"));
    addLine(tree, ShortcutSheet::tr("Up, Down, wheel"),
            ShortcutSheet::tr("One step; the wheel only in the field with the focus"));
    addLine(tree, ShortcutSheet::tr("Enter, Esc"), ShortcutSheet::tr("Accept; restore the previous value"));
}

}  // namespace

ShortcutSheet::ShortcutSheet(const QList<QAction*>& actions, QWidget* window) : QDialog(window)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keyboard, mouse and gamepad"));
    auto* tree = new QTreeWidget(this);
    tree->setAccessibleName(tr("Shortcuts"));
    tree->setColumnCount(2);
    tree->setHeaderHidden(true);
    tree->setRootIsDecorated(false);
    tree->setFrameShape(QFrame::NoFrame);
    addUsual(*tree);
    addHeading(*tree, tr("Commands"));
    for (const QAction* action : actions)
        if (!action->shortcuts().isEmpty()) addLine(*tree, keysText(*action), nameText(*action));
    tree->resizeColumnToContents(0);
    tree->header()->resizeSection(0, tree->header()->sectionSize(0) + 24);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(tree);
    int named = 0;
    for (int i = 0; i < tree->topLevelItemCount(); ++i)
        named = std::max(named, tree->sizeHintForIndex(tree->model()->index(i, 1)).width());
    const int whole = tree->header()->sectionSize(0) + named + grown(64, *this);
    resize(QSize(std::max(grown(560, *this), whole), grown(560, *this))
               .boundedTo(screen()->availableSize() - QSize(32, 96)));
}

}  // namespace vitrine::ui

#include "moc_shortcut_sheet.cpp"
