#include "ui/record/bookmarks_dialog.h"

#include "ui/record/bookmarks.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

BookmarksDialog::BookmarksDialog(Bookmarks& bookmarks, QWidget* parent)
    : QDialog(parent), bookmarks_(bookmarks), list_(new QListWidget(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Bookmarks"));
    list_->setAccessibleName(tr("Bookmarks"));
    auto* column = new QVBoxLayout;
    const auto button = [&](const QString& text, const QString& tip, auto work) {
        auto* made = new QPushButton(text, this);
        made->setToolTip(tip);
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, work);
        column->addWidget(made);
        return made;
    };
    go_ =
        button(tr("&Go there"), tr("Goes to the view of the selected bookmark."), [this] { bookmarks_.go(number()); });
    set_ = button(tr("&Set to this view"), tr("Sets the selected bookmark to the current view."),
                  [this] { bookmarks_.set(number()); });
    delete_ = button(tr("&Delete"), tr("Deletes the selected bookmark."), [this] { bookmarks_.forget(number()); });
    column->addSpacing(8);
    tour_ = button(tr("Save as a &tour…"), tr("Writes the bookmarks to a file that `vitrine record` follows."),
                   [this] { emit tourAsked(); });
    deleteAll_ = button(tr("Delete &all"), tr("Deletes all nine bookmarks."), [this] { bookmarks_.forgetAll(); });
    column->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* both = new QHBoxLayout;
    both->addWidget(list_, 1);
    both->addLayout(column);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(both, 1);
    layout->addWidget(buttons);
    connect(&bookmarks_, &Bookmarks::changed, this, &BookmarksDialog::fill);
    connect(list_, &QListWidget::currentRowChanged, this, &BookmarksDialog::showButtons);
    connect(list_, &QListWidget::itemActivated, this, [this] {
        if (go_->isEnabled()) bookmarks_.go(number());
    });
    fill();
}

int BookmarksDialog::number() const
{
    return list_->currentRow() + 1;
}

void BookmarksDialog::fill()
{
    const int row = std::max(list_->currentRow(), 0);
    list_->clear();
    for (int number = 1; number <= Bookmarks::most; ++number) {
        const QString name = bookmarks_.name(number);
        list_->addItem(name.isEmpty() ? tr("%1 (not set)").arg(number) : name);
    }
    list_->setCurrentRow(row);
    showButtons();
}

void BookmarksDialog::showButtons()
{
    const bool isSet = list_->currentRow() >= 0 && !bookmarks_.name(number()).isEmpty();
    go_->setEnabled(isSet);
    delete_->setEnabled(isSet);
    for (QPushButton* button : {tour_, deleteAll_}) button->setEnabled(bookmarks_.hasSome());
}

}  // namespace vitrine::ui

#include "moc_bookmarks_dialog.cpp"
