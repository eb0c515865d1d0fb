#include "ui/kit/tile_delegate.h"

#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QAbstractItemView>
#include <QLineEdit>
#include <QPainter>
#include <QTextLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int twoLines = 34;  // Pixels for the name and the second line, at the usual font size.

QImage cut(const QImage& picture, const QSize& size)
{
    const QImage scaled = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    return scaled.copy(QRect(QPoint((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2), size));
}

/// Draws a text that is too long for one line. What does not fit the second one is elided.
void drawInTwoLines(QPainter& painter, const QRect& room, const QString& text)
{
    const QFontMetrics metrics = painter.fontMetrics();
    QTextLayout layout(text, painter.font(), painter.device());
    layout.beginLayout();
    QTextLine line = layout.createLine();
    line.setLineWidth(room.width());
    layout.endLayout();
    const QString first = text.left(line.textLength()).trimmed();
    const QString second = text.mid(line.textLength());
    const QRect both(room.left(), room.center().y() - metrics.lineSpacing(), room.width(), 2 * metrics.lineSpacing());
    painter.drawText(both, Qt::AlignTop | Qt::AlignLeft, first);
    painter.drawText(both, Qt::AlignBottom | Qt::AlignLeft, metrics.elidedText(second, Qt::ElideRight, room.width()));
}

}  // namespace

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
    const int left = 12 + pictureBeside(option.fontMetrics).width() + 8;
    editor->setGeometry(option.rect.adjusted(left, 3, -4, -3));
}

QSize TileDelegate::pictureBeside(const QFontMetrics& metrics)
{
    // Half as much as the type: words need the room.
    constexpr int most = 130;  // Percent.
    const int percent = std::min((100 + grown(100, metrics)) / 2, most);
    return picture * percent / 100;
}

QSize TileDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    const QFontMetrics metrics(option.font);
    return {grown(160, metrics), std::max(pictureBeside(metrics).height(), grown(twoLines, metrics)) + 12};
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
    if (selected)
        painter->fillRect(QRect(option.rect.left(), option.rect.top(), 3, option.rect.height()), colors.accent);

    const QSize shown = pictureBeside(option.fontMetrics);
    const QRect frame(QPoint(option.rect.left() + 12, option.rect.center().y() - shown.height() / 2), shown);
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
    QRect words = option.rect.adjusted(12 + shown.width() + 12, 6, -8, -6);
    const QFontMetrics metrics(option.font);
    painter->setPen(enabled ? colors.text : colors.dim);
    const QString name = index.data(Qt::DisplayRole).toString();
    if (second.isEmpty() && metrics.horizontalAdvance(name) > words.width()) {
        drawInTwoLines(*painter, words, name);
    } else {
        painter->drawText(words, int((second.isEmpty() ? Qt::AlignVCenter : Qt::AlignTop) | Qt::AlignLeft),
                          metrics.elidedText(name, Qt::ElideRight, words.width()));
    }
    painter->setPen(colors.dim);
    QFont small = option.font;
    small.setPointSizeF(small.pointSizeF() * 0.9);
    painter->setFont(small);
    // Buttons may lie over the right end of the second line.
    const auto* list = qobject_cast<const QAbstractItemView*>(option.widget);
    const QWidget* buttons = list ? list->indexWidget(index) : nullptr;
    const QFontMetrics smallMetrics(small);
    const int room = words.width() - (buttons ? buttons->sizeHint().width() : 0);
    if (!buttons || smallMetrics.horizontalAdvance(second) <= room)
        painter->drawText(words, Qt::AlignBottom | Qt::AlignLeft,
                          smallMetrics.elidedText(second, Qt::ElideRight, words.width()));
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(colors.accent);
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    painter->restore();
}

QPixmap thumbnailOf(const QImage& picture)
{
    return QPixmap::fromImage(cut(picture, TileDelegate::picture * 2));
}

QImage previewOf(const QImage& picture)
{
    return cut(picture, TileDelegate::picture * 6);
}

}  // namespace vitrine::ui

#include "moc_tile_delegate.cpp"
