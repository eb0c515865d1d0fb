#include "ui/presets/preset_list.h"

#include "ui/kit/flat_style.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/tab_order.h"
#include "ui/kit/tile_delegate.h"
#include "ui/kit/type_size.h"
#include "ui/presets/preset_preview.h"
#include "ui/presets/tag_chips.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int sideBySideUpTo = 140;  // Percent of the usual font size.
constexpr int fewPresets = 5;        // Up to this number of presets there is no search.
constexpr int idRole = Qt::UserRole;
constexpr int ownLine = TileDelegate::mark + 1;  // Role of the second line that a preset was loaded with.
constexpr int tagsRole = ownLine + 1;
constexpr int mostChips = 12;  // Most tags shown; others are found by typing.
constexpr int mostRecent = 3;
// Presets of the exhibit for which tags and recent presets leave room. Tags can be typed instead.
constexpr int leastBesideTags = 3, leastBesideRecent = 2;
constexpr int finderMargin = 8, finderSpacing = 6;

void showTiles(QListWidget& list)
{
    list.setFrameShape(QFrame::NoFrame);
    list.setItemDelegate(new TileDelegate(&list));
    list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list.setEditTriggers(QAbstractItemView::NoEditTriggers);
    list.setContextMenuPolicy(Qt::CustomContextMenu);
    list.setMouseTracking(true);
}

}  // namespace

PresetList::PresetList(QWidget* parent)
    : QWidget(parent), finder_(new QWidget(this)), words_(new QLineEdit(finder_)), chips_(new TagChips(finder_)),
      list_(new QListWidget(this)), preview_(new PresetPreview(*list_, idRole)), layout_(new QVBoxLayout(this)),
      recent_(new QWidget(this)), recentList_(new QListWidget(recent_)), buttons_(new QWidget(this))
{
    words_->setPlaceholderText(tr("Find a preset"));
    words_->setAccessibleName(tr("Find a preset"));
    words_->setToolTip(
        tr("Shows only presets whose name or tags contain these words, or which are “yours”. Enter loads the first, "
           "Esc clears."));
    words_->setProperty(IdleUndo::searches, true);
    words_->setClearButtonEnabled(true);
    growHeight(*words_, 26);
    words_->setTextMargins(4, 0, 4, 0);
    words_->installEventFilter(this);
    auto* finder = new QVBoxLayout(finder_);
    finder->setContentsMargins(finderMargin, finderMargin, finderMargin, finderMargin);
    finder->setSpacing(finderSpacing);
    finder->addWidget(words_);
    finder->addWidget(chips_);
    finder_->hide();
    connect(chips_, &TagChips::changed, this, &PresetList::filter);
    connect(chips_, &TagChips::changed, this, &PresetList::fit);
    connect(preview_, &PresetPreview::asked, this, &PresetList::factsAsked);
    connect(words_, &QLineEdit::textChanged, this, &PresetList::filter);
    list_->setAccessibleName(tr("Presets"));
    showTiles(*list_);
    // The list is always high enough for one preset, whatever the font size.
    followType(*list_, [this] {
        QStyleOptionViewItem option;
        option.font = list_->font();
        list_->setMinimumHeight(list_->itemDelegate()->sizeHint(option, {}).height());
    });
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(0);
    layout_->addWidget(finder_);
    layout_->addWidget(list_, 1);
    addRecent();
    layout_->addWidget(buttons_);
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(8, 8, 8, 8);
    row->setSpacing(8);
    connect(list_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { emit loadAsked(item->data(idRole).toString()); });
    connect(list_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { emit loadAsked(item->data(idRole).toString()); });
    connect(list_, &QListWidget::currentItemChanged, this, &PresetList::selectedChanged);
    connect(list_, &QListWidget::itemChanged, this,
            [this](QListWidgetItem* item) { emit renamed(item->data(idRole).toString(), item->text()); });
    connect(list_, &QListWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        if (QListWidgetItem* item = list_->itemAt(at)) {
            list_->setCurrentItem(item);
            QMenu::exec(menu_, list_->viewport()->mapToGlobal(at), nullptr, this);
        }
    });
}

void PresetList::addRecent()
{
    auto* heading = new QLabel(tr("Recent, of other exhibits"), recent_);
    heading->setForegroundRole(QPalette::PlaceholderText);
    recentList_->setAccessibleName(heading->text());
    recentList_->setFrameShape(QFrame::NoFrame);
    recentList_->setUniformItemSizes(true);
    recentList_->setTextElideMode(Qt::ElideRight);
    recentList_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    recentList_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    recentList_->setMouseTracking(true);
    auto* lines = new QVBoxLayout(recent_);
    lines->setContentsMargins(8, 8, 8, 0);
    lines->setSpacing(4);
    lines->addWidget(heading);
    lines->addWidget(recentList_);
    layout_->addWidget(recent_);
    recent_->hide();
    const auto ask = [this](const QListWidgetItem* item) { emit recentAsked(item->data(idRole).toString()); };
    connect(recentList_, &QListWidget::itemActivated, this, ask);
    connect(recentList_, &QListWidget::itemClicked, this, ask);
    followType(*recent_, [this] { fit(); });
}

void PresetList::setRecent(const std::vector<RecentPreset>& presets)
{
    recentList_->clear();
    for (const RecentPreset& preset : presets) {
        auto* item = new QListWidgetItem(preset.text, recentList_);
        item->setData(idRole, preset.id);
        item->setToolTip(tr("Goes to the exhibit and loads the preset: %1").arg(preset.text));
    }
    fit();
}

void PresetList::fit()
{
    const int preset = list_->minimumHeight();
    const int room = height() - buttons_->sizeHint().height();
    if (!finder_->isHidden()) {
        const int tags = chips_->layout()->heightForWidth(width() - 2 * finderMargin);
        const int words = words_->height() + 2 * finderMargin + finderSpacing;
        const bool fits = room - words - tags >= leastBesideTags * preset;
        // A pressed tag stays in sight, because it hides presets.
        chips_->setVisible(chips_->layout()->count() > 0 && (fits || !chips_->pressed().isEmpty()));
    }
    const QMargins around = recent_->layout()->contentsMargins();
    const int heading = fontMetrics().height() + around.top() + around.bottom() + recent_->layout()->spacing();
    const int line = std::max(recentList_->sizeHintForRow(0), 1);
    const int finder = finder_->isHidden() ? 0 : finder_->sizeHint().height();
    const int left = room - finder - leastBesideRecent * preset - heading;
    const int shown = std::min({recentList_->count(), left / line, mostRecent});
    recent_->setVisible(shown > 0);
    recentList_->setFixedHeight(std::max(shown, 1) * line);
}

void PresetList::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

void PresetList::setActions(QAction* save, QAction* saveAs, const QList<QAction*>& menu)
{
    menu_ = menu;
    auto* row = static_cast<QHBoxLayout*>(buttons_->layout());
    QToolButton* last = nullptr;
    for (QAction* action : {save, saveAs}) {
        auto* button = last = new QToolButton(buttons_);
        button->setDefaultAction(action);
        button->setAccessibleName(action->text().remove(QLatin1Char('&')));
        button->setFocusPolicy(Qt::StrongFocus);
        growHeight(*button, 26);
        row->addWidget(button, 1);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    auto* more = new QToolButton(buttons_);
    more->setText(QStringLiteral("⋯"));
    more->setAccessibleName(tr("More for presets"));
    more->setToolTip(tr("Rename, tags, duplicate, delete, import, export"));
    more->setPopupMode(QToolButton::InstantPopup);
    more->setFocusPolicy(Qt::StrongFocus);
    growSize(*more, 28, 26);
    more->setProperty(FlatStyle::hidesMenuArrow, true);
    auto* drop = new QMenu(more);
    drop->addAction(saveAs);
    drop->addActions(menu);
    more->setMenu(drop);
    row->addWidget(more);
    tabAsLaidOut(*this);
    // With a large font, two buttons would take the picture's width or the list's height. The menu has the second
    // command, too.
    followType(*buttons_,
               [this, saveAsButton = last] { saveAsButton->setVisible(grown(100, *buttons_) <= sideBySideUpTo); });
}

void PresetList::fill(const std::vector<PresetLine>& entries)
{
    const QSignalBlocker quiet(list_);
    const QString before = selected();
    list_->clear();
    // The visitor's own presets come first.
    std::vector<PresetLine> sorted = entries;
    std::stable_partition(sorted.begin(), sorted.end(), [](const PresetLine& entry) { return !entry.shipped; });
    for (const PresetLine& entry : sorted) list_->addItem(itemFor(entry));
    finder_->setVisible(list_->count() > fewPresets);
    if (finder_->isHidden()) words_->clear();
    chips_->setTags(finder_->isHidden() ? QStringList() : tagsInUse(), mostChips);
    filter();
    setCurrent(before);
    fit();
    tabAsLaidOut(*this);  // New tags are last in the order of the window.
}

QListWidgetItem* PresetList::itemFor(const PresetLine& entry)
{
    auto* item = new QListWidgetItem(entry.name);
    item->setData(idRole, entry.id);
    item->setData(tagsRole, entry.tags);
    item->setData(ownLine,
                  entry.problem.isEmpty() ? (entry.shipped ? QString() : tr("Yours")) : tr("Cannot be opened"));
    item->setData(TileDelegate::secondLine, item->data(ownLine));
    if (!entry.thumbnail.isNull()) item->setIcon(QIcon(entry.thumbnail));
    if (!entry.shipped) item->setFlags(item->flags() | Qt::ItemIsEditable);
    QStringList spoken{entry.name, item->data(ownLine).toString()};
    if (!entry.tags.isEmpty()) spoken << tr("Tags: %1").arg(entry.tags.join(QStringLiteral(", ")));
    spoken.removeAll(QString());
    item->setData(Qt::AccessibleTextRole, spoken.join(QStringLiteral(". ")));
    return item;
}

void PresetList::showPreview(const PresetFacts& facts)
{
    preview_->show(facts);
}

QStringList PresetList::tagsInUse() const
{
    QStringList uses;
    for (int i = 0; i < list_->count(); ++i) uses << list_->item(i)->data(tagsRole).toStringList();
    return uses;
}

void PresetList::filter()
{
    const QStringList pressed = chips_->pressed();
    const QStringList words = words_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    bool any = list_->count() == 0;
    for (int i = 0; i < list_->count(); ++i) {
        QListWidgetItem* item = list_->item(i);
        const QStringList tags = item->data(tagsRole).toStringList();
        const QString text = (QStringList{item->text(), item->data(ownLine).toString()} + tags).join(QLatin1Char(' '));
        const bool has =
            std::all_of(words.begin(), words.end(),
                        [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); }) &&
            std::all_of(pressed.begin(), pressed.end(), [&](const QString& tag) { return tags.contains(tag); });
        item->setHidden(!has);
        any = any || has;
    }
    showNothing(!any);
}

void PresetList::showNothing(bool on)
{
    // A hidden label would still be read by screen readers.
    if (!on) {
        delete std::exchange(nothing_, nullptr);
    } else if (!nothing_) {
        nothing_ = new QLabel(tr("No preset matches these words and tags."), this);
        nothing_->setAlignment(Qt::AlignCenter);
        layout_->insertWidget(layout_->indexOf(list_), nothing_);
    }
}

bool PresetList::eventFilter(QObject* object, QEvent* event)
{
    if (object == words_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape && !words_->text().isEmpty()) {
            words_->clear();
            return true;
        }
        if (key == Qt::Key_Down) {
            list_->setFocus();
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            for (int i = 0; i < list_->count(); ++i) {
                if (list_->item(i)->isHidden()) continue;
                emit loadAsked(list_->item(i)->data(idRole).toString());
                break;
            }
            return true;
        }
    }
    return QWidget::eventFilter(object, event);
}

QListWidgetItem* PresetList::itemOf(const QString& id) const
{
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->data(idRole).toString() == id) return list_->item(i);
    return nullptr;
}

void PresetList::setCurrent(const QString& id, bool changed)
{
    const QSignalBlocker quiet(list_);
    QListWidgetItem* current = itemOf(id);
    for (int i = 0; i < list_->count(); ++i) {
        QListWidgetItem* item = list_->item(i);
        const QString line = item == current && changed ? tr("Changed since") : item->data(ownLine).toString();
        if (item->data(TileDelegate::secondLine).toString() != line) item->setData(TileDelegate::secondLine, line);
    }
    list_->setCurrentItem(current);
}

QString PresetList::selected() const
{
    const QListWidgetItem* item = list_->currentItem();
    return item ? item->data(idRole).toString() : QString();
}

bool PresetList::startRename(const QString& id)
{
    QListWidgetItem* item = itemOf(id);
    if (!item || !(item->flags() & Qt::ItemIsEditable)) return false;
    list_->editItem(item);
    return true;
}

}  // namespace vitrine::ui

#include "moc_preset_list.cpp"
