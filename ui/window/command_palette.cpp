#include "ui/window/command_palette.h"

#include "ui/kit/type_size.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

QString nameOf(const QAction* action)
{
    return action->text().remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

QString keysOf(const QAction* action)
{
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    return keys.join(QStringLiteral(", "));
}

}  // namespace

CommandPalette::CommandPalette(const QList<QAction*>& actions, QWidget* window)
    : QDialog(window, Qt::Popup), actions_(actions), words_(new QLineEdit(this)), list_(new QListWidget(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Commands"));
    words_->setPlaceholderText(tr("Find a command"));
    words_->setAccessibleName(tr("Find a command"));
    growHeight(*words_, 28);
    words_->installEventFilter(this);
    list_->setAccessibleName(tr("Commands"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(words_);
    layout->addWidget(list_);
    connect(words_, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(words_, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
    fill();
    resize(QSize(grown(480, *this), grown(360, *this)).boundedTo(window->size() - QSize(32, 96)));
    move(window->mapToGlobal(QPoint((window->width() - width()) / 2, 64)));
    words_->setFocus();
}

void CommandPalette::fill()
{
    list_->clear();
    for (int i = 0; i < actions_.size(); ++i) {
        const QAction* action = actions_[i];
        if (!action->isEnabled()) continue;
        bool matches = true;
        for (const QString& word : words_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts))
            matches = matches && nameOf(action).contains(word, Qt::CaseInsensitive);
        if (!matches) continue;
        const QString keys = keysOf(action);
        auto* item = new QListWidgetItem(
            keys.isEmpty() ? nameOf(action) : nameOf(action) + QStringLiteral("    ") + keys, list_);
        item->setData(Qt::UserRole, i);
        item->setToolTip(action->toolTip());
    }
    list_->setCurrentRow(0);
}

void CommandPalette::run()
{
    const QListWidgetItem* item = list_->currentItem();
    QAction* action = item ? actions_[item->data(Qt::UserRole).toInt()] : nullptr;
    close();
    if (action) action->trigger();
}

bool CommandPalette::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Up) {
            const int row = list_->currentRow() + (key == Qt::Key_Down ? 1 : -1);
            if (row >= 0 && row < list_->count()) list_->setCurrentRow(row);
            return true;
        }
    }
    return QDialog::eventFilter(object, event);
}

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
    const auto heading = [&](const QString& text) {
        auto* item = new QTreeWidgetItem(tree, {text});
        QFont bold = item->font(0);
        bold.setWeight(QFont::DemiBold);
        item->setFont(0, bold);
        item->setFlags(Qt::ItemIsEnabled);
    };
    const auto line = [&](const QString& keys, const QString& what) { new QTreeWidgetItem(tree, {keys, what}); };
    heading(tr("In the museum"));
    line(tr("W A S D, arrows"), tr("Walk; Shift runs"));
    line(tr("Drag; Ctrl and arrows"), tr("Look around, or around the exhibit"));
    line(tr("Right drag"), tr("Look around with the pointer locked"));
    line(tr("Click"), tr("Visit an exhibit, press a button"));
    line(tr("Enter"), tr("The same with what is in the middle of the picture"));
    line(tr("Wheel, + and −"), tr("Come nearer to the exhibit or step back"));
    line(QStringLiteral("E"), tr("Press the red button you look at, or that of the exhibit you visit"));
    line(QStringLiteral("Esc"), tr("Leave the exhibit and walk on"));
    line(tr("Backspace, Alt+Left"), tr("Back to where you stood before"));
    line(tr("F6, Shift+F6"), tr("From the picture to the next panel, and on to the one before"));
    heading(tr("In the tree"));
    line(tr("Ctrl and arrows"), tr("Move the node: up, down, out of its parent, into the one above"));
    heading(tr("With a gamepad"));
    line(tr("Left stick"), tr("Walk; the right trigger, or pressing the stick, runs"));
    line(tr("Right stick"), tr("Look around, or around the exhibit"));
    line(tr("Triggers"), tr("Come nearer to the exhibit, or step back"));
    line(QStringLiteral("A"), tr("Visit what is in the middle of the picture, or press its button"));
    line(QStringLiteral("B"), tr("Leave the exhibit and walk on"));
    line(QStringLiteral("X"), tr("Press the red button"));
    line(QStringLiteral("Y"), tr("Back to where you stood before"));
    line(tr("Cross up, down"), tr("Choose a parameter"));
    line(tr("Cross left, right"), tr("Change it, as the arrows do"));
    line(tr("Shoulders"), tr("Visit the exhibit before, or the next one"));
    line(tr("Start"), tr("Stop and start the exhibits' clock"));
    line(tr("In dialogs and menus"), tr("The cross moves, A presses, B closes"));
    heading(tr("While two settings are compared"));
    line(tr("B, held"), tr("B in place of A"));
    line(tr("Drag the line; comma, period"), tr("Move the wipe"));
    heading(tr("In number fields"));
    line(tr("Drag the label or the number"), tr("Change it; Shift ten times finer, Ctrl ten times coarser"));
    line(tr("Click, or any digit"), tr("Type: 1/3, 2*pi, 30deg"));
    line(tr("Up, Down, wheel"), tr("One step; the wheel only in the field with the focus"));
    line(tr("Enter, Esc"), tr("Accept; bring back the value before"));
    heading(tr("Commands"));
    for (const QAction* action : actions)
        if (!action->shortcuts().isEmpty()) line(keysOf(action), nameOf(action));
    tree->resizeColumnToContents(0);
    tree->header()->resizeSection(0, tree->header()->sectionSize(0) + 24);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(tree);
    resize(QSize(grown(560, *this), grown(560, *this)).boundedTo(screen()->availableSize() - QSize(32, 96)));
}

}  // namespace vitrine::ui

#include "moc_command_palette.cpp"
