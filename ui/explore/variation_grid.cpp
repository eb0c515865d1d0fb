#include "ui/explore/variation_grid.h"

#include "ui/explore/variations.h"
#include "ui/kit/theme.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>

namespace vitrine::ui {
namespace {

/// Delegate that draws one variation: its picture, a frame if it equals the present values, another for the keyboard
/// focus.
class CellDelegate final : public QStyledItemDelegate {
public:
    CellDelegate(const Variations& variations, VariationGrid& grid)
        : QStyledItemDelegate(&grid), variations_(variations), grid_(grid)
    {
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int i = index.row() * VariationGrid::side + index.column();
        const Theme& colors = theme();
        painter->save();
        painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        const QRectF room = QRectF(option.rect).adjusted(3, 3, -3, -3);
        const QImage& image = variations_.image(i);
        if (image.isNull()) {
            QColor fill = colors.text;
            fill.setAlphaF(0.06F);
            painter->setPen(Qt::NoPen);
            painter->setBrush(fill);
            painter->drawRoundedRect(room, 3, 3);
        } else {
            const QSizeF size = QSizeF(image.size()).scaled(room.size(), Qt::KeepAspectRatioByExpanding);
            painter->setClipRect(room);
            if (variations_.stale()) painter->setOpacity(0.5);
            painter->drawImage(QRectF(room.center() - QPointF(size.width() / 2, size.height() / 2), size), image);
            painter->setOpacity(1);
            painter->setClipping(false);
        }
        painter->setBrush(Qt::NoBrush);
        const bool here = option.state & QStyle::State_HasFocus || (grid_.hasFocus() && grid_.current() == i);
        if (variations_.onShow() == i) {
            painter->setPen(QPen(colors.accent, 2.5));
            painter->drawRect(room);
        } else if (here || option.state & QStyle::State_MouseOver) {
            painter->setPen(QPen(here ? colors.accent : colors.dim, 1, here ? Qt::DashLine : Qt::SolidLine));
            painter->drawRect(room);
        }
        painter->restore();
    }

private:
    const Variations& variations_;
    VariationGrid& grid_;
};

}  // namespace

VariationGrid::VariationGrid(const Variations& variations, QWidget* parent)
    : QTableWidget(side, side, parent), variations_(variations)
{
    setAccessibleName(tr("Nine variations"));
    setAccessibleDescription(tr("Arrow keys select a variation, Enter uses it."));
    setToolTip(tr("Click a variation, or select it with the arrow keys and press Enter, to use it. Can be undone."));
    setItemDelegate(new CellDelegate(variations, *this));
    for (QHeaderView* header : {horizontalHeader(), verticalHeader()}) {
        header->hide();
        header->setMinimumSectionSize(20);
        header->setSectionResizeMode(QHeaderView::Stretch);
    }
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setEditTriggers(NoEditTriggers);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(false);
    for (int i = 0; i < side * side; ++i) setItem(i / side, i % side, new QTableWidgetItem);
    setCurrentCell(0, 0);
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int column) { emit picked(row * side + column); });
    refresh();
}

void VariationGrid::refresh()
{
    setEnabled(variations_.made());
    for (int i = 0; i < side * side; ++i) {
        const qulonglong seed = variations_.seedOf(i);
        QString words = tr("Variation %1, seed %2").arg(i + 1).arg(seed);
        if (variations_.made() && variations_.image(i).isNull())
            words = tr("Variation %1, seed %2, not drawn yet").arg(i + 1).arg(seed);
        else if (variations_.onShow() == i)
            words = tr("Variation %1, seed %2, shown").arg(i + 1).arg(seed);
        QTableWidgetItem* cell = item(i / side, i % side);
        if (cell->data(Qt::AccessibleTextRole).toString() != words) cell->setData(Qt::AccessibleTextRole, words);
    }
    viewport()->update();
}

void VariationGrid::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space)
        emit picked(current());
    else
        QTableWidget::keyPressEvent(event);
}

void VariationGrid::resizeEvent(QResizeEvent* event)
{
    QTableWidget::resizeEvent(event);
    setFixedHeight(width() * 9 / 16);
}

}  // namespace vitrine::ui

#include "moc_variation_grid.cpp"
