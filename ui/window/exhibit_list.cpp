#include "ui/window/exhibit_list.h"

#include "ui/kit/text.h"
#include "ui/kit/tile_delegate.h"

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int exhibitRole = Qt::UserRole;

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
}

void ExhibitList::fill(Subjects subjects, const std::vector<int>& emptyPlaces)
{
    clear();
    struct Entry {
        int place;
        std::optional<std::size_t> exhibit;
    };
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const auto* exhibit = dynamic_cast<const Exhibit*>(subjects[i]);
        entries.push_back({exhibit ? exhibit->place() : 0, i});  // The hall comes first.
    }
    for (const int place : emptyPlaces) entries.push_back({place, std::nullopt});
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.place < b.place; });
    for (const Entry& entry : entries) {
        auto* item = new QListWidgetItem(this);
        const bool numbered = entry.place >= 1 && entry.place <= 9;
        item->setData(TileDelegate::mark, numbered ? QString::number(entry.place) : QString());
        if (!entry.exhibit) {
            item->setText(tr("In preparation"));
            item->setData(TileDelegate::secondLine, tr("Place %1").arg(entry.place));
            item->setFlags(Qt::NoItemFlags);
            continue;
        }
        const Subject& subject = *subjects[*entry.exhibit];
        item->setText(text(subject.title()));
        item->setData(exhibitRole, static_cast<qulonglong>(*entry.exhibit));
        item->setData(TileDelegate::secondLine, numbered ? tr("Place %1").arg(entry.place) : QString());
        item->setToolTip(text(subject.summary()));
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
