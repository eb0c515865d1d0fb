#include "ui/window/search_dialog.h"

#include "ui/kit/flow_layout.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostShown = 100;
constexpr auto measureKeys = Qt::CTRL | Qt::Key_Return;
constexpr auto figureKeys = Qt::CTRL | Qt::SHIFT | Qt::Key_Return;

/// Returns the rank of an entry before anything is typed, 0: it is not listed.
int atOnce(const SearchEntry& entry)
{
    if (entry.recent > 0) return std::numeric_limits<int>::max() - entry.recent;
    return entry.command ? 1 : 0;
}

}  // namespace

SearchDialog::SearchDialog(std::vector<SearchEntry> entries, QWidget* window)
    : QDialog(window, Qt::Popup), entries_(std::move(entries)), words_(new QLineEdit(this)),
      list_(new QTreeWidget(this)), help_(new QLabel(this)), buttons_(new QWidget(this))
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
    layout->addWidget(buttons_);
    new FlowLayout(buttons_);
    addButton(tr("Measure its cost"), tr("Measures what the accuracy of this parameter costs, in the Study panel."),
              measureKeys, &SearchEntry::measure);
    addButton(tr("Measure and save figure"),
              tr("Measures it and saves the chart as SVG in your pictures folder, under a free name."), figureKeys,
              &SearchEntry::figure);
    connect(words_, &QLineEdit::textChanged, this, &SearchDialog::find);
    connect(words_, &QLineEdit::returnPressed, this, [this] { go(); });
    connect(list_, &QTreeWidget::itemClicked, this, [this] { go(); });
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
        const int score = query.empty() ? atOnce(entries_[i]) : searchScore(query, texts_[i]);
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

const SearchEntry* SearchDialog::current() const
{
    const QTreeWidgetItem* item = list_->currentItem();
    return item ? &entries_[item->data(0, Qt::UserRole).toULongLong()] : nullptr;
}

void SearchDialog::showHelp()
{
    const QTreeWidgetItem* item = list_->currentItem();
    const SearchEntry* entry = current();
    help_->setText(entry ? entry->help : tr("Nothing found for “%1”. Try fewer or other words.").arg(words_->text()));
    buttons_->setVisible(entry && entry->measure);
    words_->setAccessibleDescription(item ? item->text(0) + QStringLiteral(", ") + item->text(1) : help_->text());
}

void SearchDialog::act(std::function<void()> SearchEntry::*what)
{
    const SearchEntry* entry = current();
    if (!entry) return;  // Nothing was found: the words stay.
    const std::function<void()> work = entry->*what ? entry->*what : entry->go;
    close();
    work();
}

void SearchDialog::addButton(const QString& face, const QString& tip, const QKeySequence& keys,
                             std::function<void()> SearchEntry::*what)
{
    auto* button = new QToolButton(buttons_);
    button->setText(QStringLiteral("%1  %2").arg(face, keys.toString(QKeySequence::NativeText)));
    button->setAccessibleName(face);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::NoFocus);  // The words keep the focus.
    growHeight(*button, 26);
    connect(button, &QToolButton::clicked, this, [this, what] { act(what); });
    buttons_->layout()->addWidget(button);
}

bool SearchDialog::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        switch (key->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (!key->modifiers().testFlag(Qt::ControlModifier)) break;
            act(key->modifiers().testFlag(Qt::ShiftModifier) ? &SearchEntry::figure : &SearchEntry::measure);
            return true;
        case Qt::Key_Down:
        case Qt::Key_Up:
        case Qt::Key_PageDown:
        case Qt::Key_PageUp: QApplication::sendEvent(list_, event); return true;
        default: break;
        }
    }
    return QDialog::eventFilter(object, event);
}

void SearchDialog::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setPen(theme().outline);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace vitrine::ui

#include "moc_search_dialog.cpp"
