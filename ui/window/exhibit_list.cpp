#include "ui/window/exhibit_list.h"

#include "exhibits/framework/files/lesson.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/tile_delegate.h"

#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace vitrine::ui {
namespace {

constexpr int exhibitRole = Qt::UserRole;
constexpr int nameRole = Qt::UserRole + 3;  // Name of the exhibit in files.

}  // namespace

ExhibitList::ExhibitList(QWidget* parent) : QListWidget(parent)
{
    setAccessibleName(tr("Exhibits"));
    setFrameShape(QFrame::NoFrame);
    setItemDelegate(new TileDelegate(this));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMouseTracking(true);
    connect(this, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { emit chosen(item->data(exhibitRole).toULongLong()); });
    connect(this, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { emit chosen(item->data(exhibitRole).toULongLong()); });
    connect(this, &QListWidget::currentItemChanged, this, &ExhibitList::showButtons);
}

void ExhibitList::showButtons(QListWidgetItem* row, QListWidgetItem* before)
{
    if (QWidget* old = before ? itemWidget(before) : nullptr) {
        old->hide();  // It is destroyed later.
        removeItemWidget(before);
    }
    if (!row || row->flags() == Qt::NoItemFlags) return;
    auto* buttons = new QWidget;
    setItemWidget(row, buttons);  // Before the order of tabs, which holds within one window.
    auto* layout = new QHBoxLayout(buttons);
    layout->setContentsMargins(0, 0, 4, 2);
    layout->setSpacing(2);
    layout->addStretch(1);
    const std::size_t exhibit = row->data(exhibitRole).toULongLong();
    QWidget* last = this;
    const auto button = [&](const QString& face, const QString& tip, void (ExhibitList::*asked)(std::size_t)) {
        auto* made = new QToolButton(buttons);
        made->setText(face);
        made->setAutoRaise(true);
        made->setToolTip(tip);
        made->setAccessibleName(tip);
        layout->addWidget(made, 0, Qt::AlignBottom);
        setTabOrder(last, made);
        last = made;
        connect(made, &QToolButton::clicked, this, [this, asked, exhibit] { emit(this->*asked)(exhibit); });
    };
    std::error_code ignored;
    if (std::filesystem::exists(shippedLesson(row->data(nameRole).toString().toStdString()), ignored))
        button(tr("Lesson"), tr("Start the lesson on %1").arg(row->text()), &ExhibitList::lessonAsked);
    button(tr("About"), tr("About %1").arg(row->text()), &ExhibitList::pageAsked);
}

void ExhibitList::fill(const Museum& museum)
{
    clear();
    struct Entry {
        int place;
        std::optional<std::size_t> subject;
    };
    std::vector<Entry> entries{{0, hallIndex}};
    constexpr int depot = std::numeric_limits<int>::max();
    for (const auto& [i, exhibit] : museum.exhibits())
        entries.push_back({museum.isInHall(i) ? exhibit.place() : depot, i});
    for (const int place : museum.emptyPlaces()) entries.push_back({place, std::nullopt});
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.place < b.place; });
    for (const Entry& entry : entries) {
        auto* item = new QListWidgetItem(this);
        const bool numbered = entry.place >= 1 && entry.place < depot;
        item->setData(TileDelegate::mark, numbered ? QString::number(entry.place) : QString());
        if (!entry.subject) {
            item->setText(tr("In preparation"));
            item->setData(TileDelegate::secondLine, tr("Place %1").arg(entry.place));
            item->setFlags(Qt::NoItemFlags);
            continue;
        }
        const SceneObject& subject = museum.subject(*entry.subject);
        item->setText(translatedText(subject.title()));
        item->setData(exhibitRole, static_cast<qulonglong>(*entry.subject));
        item->setData(nameRole, text(subject.name()));
        item->setData(TileDelegate::secondLine, numbered               ? tr("Place %1").arg(entry.place)
                                                : entry.place == depot ? tr("In storage: shown alone")
                                                                       : QString());
        item->setToolTip(translatedText(subject.summary()));
    }
}

QListWidgetItem* ExhibitList::itemOf(std::size_t exhibit) const
{
    for (int i = 0; i < count(); ++i)
        if (item(i)->flags() != Qt::NoItemFlags && item(i)->data(exhibitRole).toULongLong() == exhibit) return item(i);
    return nullptr;
}

void ExhibitList::setThumbnail(std::size_t exhibit, const QPixmap& pixmap)
{
    if (QListWidgetItem* found = itemOf(exhibit)) found->setIcon(QIcon(pixmap));
}

bool ExhibitList::hasThumbnail(std::size_t exhibit) const
{
    const QListWidgetItem* found = itemOf(exhibit);
    return found && !found->icon().isNull();
}

void ExhibitList::choose(std::size_t exhibit)
{
    setCurrentItem(itemOf(exhibit));
}

}  // namespace vitrine::ui

#include "moc_exhibit_list.cpp"
