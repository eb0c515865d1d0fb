#include "ui/window/search_dialog.h"

#include "ui/kit/type_size.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostShown = 100;

}  // namespace

SearchDialog::SearchDialog(std::vector<SearchEntry> entries, QWidget* window)
    : QDialog(window, Qt::Popup), entries_(std::move(entries)), words_(new QLineEdit(this)),
      list_(new QTreeWidget(this)), help_(new QLabel(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Search"));
    for (const SearchEntry& entry : entries_)
        texts_.push_back(searchText(entry.title, entry.place, entry.help + QLatin1Char(' ') + entry.more));
    words_->setPlaceholderText(tr("Search parameters, presets, commands and pages"));
    words_->setAccessibleName(tr("Search"));
    growHeight(*words_, 28);
    words_->installEventFilter(this);
    list_->setAccessibleName(tr("Matches"));
    list_->setColumnCount(3);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (const int column : {1, 2}) list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    help_->setTextFormat(Qt::PlainText);
    help_->setWordWrap(true);
    help_->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(words_);
    layout->addWidget(list_, 1);
    layout->addWidget(help_);
    connect(words_, &QLineEdit::textChanged, this, &SearchDialog::find);
    connect(words_, &QLineEdit::returnPressed, this, &SearchDialog::go);
    connect(list_, &QTreeWidget::itemClicked, this, &SearchDialog::go);
    connect(list_, &QTreeWidget::currentItemChanged, this, &SearchDialog::showHelp);
    find();
    resize(QSize(grown(640, *this), grown(420, *this)).boundedTo(window->size() - QSize(32, 96)));
    move(window->mapToGlobal(QPoint((window->width() - width()) / 2, 64)));
    words_->setFocus();
}

void SearchDialog::find()
{
    const std::vector<std::string> query = searchWords(words_->text());
    std::vector<std::pair<int, std::size_t>> found;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const int score = query.empty() ? (entries_[i].command ? 1 : 0) : searchScore(query, texts_[i]);
        if (score > 0) found.emplace_back(-score, i);
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), mostShown));
    list_->clear();
    for (const auto& [rank, i] : found) {
        auto* item = new QTreeWidgetItem(list_, {entries_[i].title, entries_[i].place, entries_[i].keys});
        item->setData(0, Qt::UserRole, static_cast<qulonglong>(i));
        item->setForeground(1, palette().brush(QPalette::PlaceholderText));
        item->setForeground(2, palette().brush(QPalette::PlaceholderText));
    }
    list_->setVisible(!found.empty());
    list_->setCurrentItem(list_->topLevelItem(0));
    showHelp();
}

void SearchDialog::showHelp()
{
    const QTreeWidgetItem* item = list_->currentItem();
    if (item)
        help_->setText(entries_[item->data(0, Qt::UserRole).toULongLong()].help);
    else
        help_->setText(tr("Nothing found for “%1”. Try fewer or other words.").arg(words_->text()));
    words_->setAccessibleDescription(item ? item->text(0) + QStringLiteral(", ") + item->text(1) : help_->text());
}

void SearchDialog::go()
{
    const QTreeWidgetItem* item = list_->currentItem();
    if (!item) return;  // Nothing was found: the words stay.
    const std::function<void()> work = entries_[item->data(0, Qt::UserRole).toULongLong()].go;
    close();
    work();
}

bool SearchDialog::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Down:
        case Qt::Key_Up:
        case Qt::Key_PageDown:
        case Qt::Key_PageUp: QApplication::sendEvent(list_, event); return true;
        default: break;
        }
    }
    return QDialog::eventFilter(object, event);
}

}  // namespace vitrine::ui

#include "moc_search_dialog.cpp"
