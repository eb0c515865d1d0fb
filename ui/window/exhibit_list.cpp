#include "ui/window/exhibit_list.h"

#include "ui/window/theme.h"

#include <QLineEdit>
#include <QPainter>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int exhibitRole = Qt::UserRole;

QString text(std::string_view s)
{
    return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

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

void ExhibitList::fill(std::span<const std::unique_ptr<Exhibit>> exhibits, const std::vector<int>& emptyPlaces)
{
    clear();
    struct Entry {
        int place;
        std::optional<std::size_t> exhibit;
    };
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < exhibits.size(); ++i) entries.push_back({exhibits[i]->place(), i});
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
        const Exhibit& exhibit = *exhibits[*entry.exhibit];
        item->setText(text(exhibit.title()));
        item->setData(exhibitRole, static_cast<qulonglong>(*entry.exhibit));
        item->setData(TileDelegate::secondLine, numbered ? tr("Place %1").arg(entry.place) : QString());
        item->setToolTip(text(exhibit.summary()));
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

QWidget* TileDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    if (!editor) return nullptr;
    editor->setAutoFillBackground(true);
    editor->setAccessibleName(tr("New name"));
    QPalette colors = editor->palette();
    colors.setColor(QPalette::Base, colors.color(QPalette::Window));
    editor->setPalette(colors);
    if (auto* line = qobject_cast<QLineEdit*>(editor)) line->setFrame(true);
    return editor;
}

void TileDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const
{
    const int left = 12 + picture.width() + 8;
    editor->setGeometry(option.rect.adjusted(left, 3, -4, -3));
}

QSize TileDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {160, picture.height() + 12};
}

void TileDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const Theme& colors = theme();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool enabled = index.flags() & Qt::ItemIsEnabled;
    const bool selected = option.state & QStyle::State_Selected;
    const bool hovered = enabled && option.state & QStyle::State_MouseOver;
    if (selected || hovered) {
        QColor fill = selected ? colors.accent : colors.text;
        fill.setAlphaF(selected ? 0.18F : 0.06F);
        painter->fillRect(option.rect, fill);
    }
    if (selected) painter->fillRect(QRect(option.rect.left(), option.rect.top(), 3, option.rect.height()), colors.accent);

    const QRect frame(option.rect.left() + 12, option.rect.top() + 6, picture.width(), picture.height());
    const QIcon icon = index.data(Qt::DecorationRole).value<QIcon>();
    if (!icon.isNull()) {
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        painter->drawPixmap(frame, icon.pixmap(picture * 2));
    } else {
        QColor fill = colors.text;
        fill.setAlphaF(0.06F);
        painter->fillRect(frame, fill);
        QFont large = option.font;
        large.setPointSizeF(large.pointSizeF() * 1.3);
        painter->setFont(large);
        painter->setPen(colors.dim);
        painter->drawText(frame, Qt::AlignCenter, index.data(mark).toString());
        painter->setFont(option.font);
    }
    const QString second = index.data(secondLine).toString();
    QRect words = option.rect.adjusted(12 + picture.width() + 12, 6, -8, -6);
    const QFontMetrics metrics(option.font);
    painter->setPen(enabled ? colors.text : colors.dim);
    const QString first = metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, words.width());
    painter->drawText(words, (second.isEmpty() ? Qt::AlignVCenter : Qt::AlignTop) | Qt::AlignLeft, first);
    painter->setPen(colors.dim);
    QFont small = option.font;
    small.setPointSizeF(small.pointSizeF() * 0.9);
    painter->setFont(small);
    painter->drawText(words, Qt::AlignBottom | Qt::AlignLeft,
                      QFontMetrics(small).elidedText(second, Qt::ElideRight, words.width()));
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(colors.accent);
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    painter->restore();
}

}  // namespace vitrine::ui

#include "moc_exhibit_list.cpp"
