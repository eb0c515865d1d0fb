#include "ui/preferences/keys_page.h"

#include "ui/kit/idle_undo.h"
#include "ui/kit/type_size.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

constexpr int indexRole = Qt::UserRole;

}  // namespace

KeysPage::KeysPage(KeyBindings& keys, QWidget* parent)
    : QWidget(parent), keys_(keys), words_(new QLineEdit(this)), list_(new QTreeWidget(this)), name_(new QLabel(this)),
      edit_(new QKeySequenceEdit(this)), none_(new QPushButton(tr("None"), this)),
      reset_(new QPushButton(tr("Reset"), this)), resetAll_(new QPushButton(tr("Reset all"), this)),
      message_(new QLabel(this)), take_(new QPushButton(tr("Reassign it"), this)),
      leave_(new QPushButton(tr("Leave it"), this))
{
    build();
    fill();
    connect(words_, &QLineEdit::textChanged, this, &KeysPage::filter);
    connect(list_, &QTreeWidget::currentItemChanged, this, &KeysPage::showChosen);
    connect(edit_, &QKeySequenceEdit::keySequenceChanged, this, &KeysPage::typed);
    connect(none_, &QPushButton::clicked, this, [this] { give({}); });
    connect(reset_, &QPushButton::clicked, this, [this] {
        if (const QAction* action = chosen()) give(keys_.usual(*action));
    });
    connect(resetAll_, &QPushButton::clicked, &keys_, &KeyBindings::resetAll);
    connect(take_, &QPushButton::clicked, this, [this] {
        if (QAction* action = chosen()) keys_.set(*action, asked_);
        list_->setFocus();
    });
    connect(leave_, &QPushButton::clicked, this, [this] {
        showChosen();
        list_->setFocus();
    });
    connect(&keys_, &KeyBindings::changed, this, &KeysPage::fill);
    list_->setCurrentItem(list_->topLevelItem(0));
}

void KeysPage::build()
{
    words_->setPlaceholderText(tr("Find a command"));
    words_->setAccessibleName(tr("Find a command"));
    words_->setToolTip(tr("Shows only commands whose name or shortcut contains these words."));
    words_->setProperty(IdleUndo::searches, true);
    words_->setClearButtonEnabled(true);
    list_->setAccessibleName(tr("Commands and their shortcuts"));
    list_->setHeaderLabels({tr("Command"), tr("Shortcut")});
    list_->setRootIsDecorated(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(false);
    name_->setTextFormat(Qt::PlainText);
    name_->setWordWrap(true);
    name_->setBuddy(edit_);
    edit_->setAccessibleName(tr("New shortcut"));
    edit_->setToolTip(tr("Press the new shortcut of the command."));
    none_->setToolTip(tr("Removes all shortcuts of the command."));
    reset_->setToolTip(tr("Restores the default shortcuts of the command."));
    resetAll_->setToolTip(tr("Restores the default shortcuts of all commands."));
    message_->setTextFormat(Qt::PlainText);
    message_->setWordWrap(true);
    message_->setAccessibleName(tr("About the shortcut"));
    take_->setToolTip(tr("The shortcut is removed from the other command."));
    leave_->setToolTip(tr("Nothing is changed."));
    auto* editing = new QHBoxLayout;
    editing->setSpacing(8);
    editing->addWidget(edit_, 1);
    for (QPushButton* button : {none_, reset_, resetAll_}) editing->addWidget(button);
    auto* asking = new QHBoxLayout;
    asking->setSpacing(8);
    asking->addWidget(message_, 1);
    asking->addWidget(take_);
    asking->addWidget(leave_);
    for (QPushButton* button : {none_, reset_, resetAll_, take_, leave_}) button->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(8);
    layout->addWidget(words_);
    layout->addWidget(list_, 1);
    layout->addWidget(name_);
    layout->addLayout(editing);
    layout->addLayout(asking);
    // Space for two lines, so that a message moves nothing above it.
    followType(*message_, [this] { message_->setMinimumHeight(2 * message_->fontMetrics().lineSpacing()); });
}

QAction* KeysPage::chosen() const
{
    const QTreeWidgetItem* item = list_->currentItem();
    return item ? keys_.actions().value(item->data(0, indexRole).toInt()) : nullptr;
}

void KeysPage::fill()
{
    const QSignalBlocker quiet(list_);
    while (list_->topLevelItemCount() < keys_.actions().size()) {
        auto* item = new QTreeWidgetItem(list_);
        item->setData(0, indexRole, list_->topLevelItemCount() - 1);
    }
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_->topLevelItem(i);
        const QAction& action = *keys_.actions()[i];
        item->setText(0, KeyBindings::nameOf(action));
        item->setText(1, KeyBindings::textOf(action.shortcuts()));
        item->setToolTip(0, action.statusTip());
        QFont font = list_->font();
        font.setBold(keys_.differs(action));
        item->setFont(1, font);
    }
    filter();
    showChosen();
}

void KeysPage::filter()
{
    const QStringList words = words_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_->topLevelItem(i);
        const QString text = item->text(0) + QLatin1Char(' ') + item->text(1);
        bool has = true;
        for (const QString& word : words) has = has && text.contains(word, Qt::CaseInsensitive);
        item->setHidden(!has);
    }
}

void KeysPage::showChosen()
{
    const QAction* action = chosen();
    for (QWidget* part : std::initializer_list<QWidget*>{edit_, none_, reset_}) part->setEnabled(action != nullptr);
    resetAll_->setEnabled(keys_.anyDiffers());
    say({}, false);
    const QSignalBlocker quiet(edit_);
    edit_->clear();
    if (!action) return name_->clear();
    const QString usual = KeyBindings::textOf(keys_.usual(*action));
    name_->setText(usual.isEmpty()
                       ? tr("New shortcut for “%1”; its default is none.").arg(KeyBindings::nameOf(*action))
                       : tr("New shortcut for “%1”; its default is %2.").arg(KeyBindings::nameOf(*action), usual));
    if (!action->shortcuts().isEmpty()) edit_->setKeySequence(action->shortcut());
    none_->setEnabled(!action->shortcuts().isEmpty());
    reset_->setEnabled(keys_.differs(*action));
}

void KeysPage::typed()
{
    // A shortcut has one stroke only: later ones are ignored.
    const QKeySequence whole = edit_->keySequence();
    if (whole.isEmpty()) return;
    const QKeySequence stroke(whole[0]);
    const QString refused = KeyBindings::refusal(stroke);
    if (refused.isEmpty()) return give({stroke});
    showChosen();
    say(refused, false);
}

void KeysPage::give(const KeyBindings::Keys& keys)
{
    QAction* action = chosen();
    if (!action || keys == action->shortcuts()) return;
    if (const QAction* other = keys_.user(keys, *action)) {
        asked_ = keys;
        KeyBindings::Keys theirs;
        for (const QKeySequence& key : keys)
            if (other->shortcuts().contains(key)) theirs << key;
        return say(tr("%1 is already used by “%2”. Reassign it?")
                       .arg(KeyBindings::textOf(theirs), KeyBindings::nameOf(*other)),
                   true);
    }
    keys_.set(*action, keys);
}

void KeysPage::say(const QString& words, bool asks)
{
    message_->setText(words);
    take_->setVisible(asks);
    leave_->setVisible(asks);
    if (asks) take_->setFocus();
}

}  // namespace vitrine::ui

#include "moc_keys_page.cpp"
