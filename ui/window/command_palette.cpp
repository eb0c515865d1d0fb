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
    setWindowTitle(tr("Keyboard and mouse"));
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
    line(tr("Drag"), tr("Look around, or around the exhibit"));
    line(tr("Right drag"), tr("Look around with the pointer locked"));
    line(tr("Click"), tr("Visit an exhibit, press a button"));
    line(tr("Wheel"), tr("Come nearer to the exhibit or step back"));
    line(QStringLiteral("E"), tr("Press the red button you look at, or that of the exhibit you visit"));
    line(QStringLiteral("Esc"), tr("Leave the exhibit and walk on"));
    line(tr("Backspace"), tr("Back to where you stood before"));
    heading(tr("While two settings are compared"));
    line(tr("B, held"), tr("B in place of A"));
    line(tr("Drag the line"), tr("Move the wipe"));
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
