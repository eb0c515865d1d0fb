#include "ui/study/two_line_delegate.h"

#include "ui/kit/theme.h"

#include <QApplication>
#include <QPainter>

namespace vitrine::ui {
namespace {

QFont smaller(QFont font)
{
    font.setPointSizeF(font.pointSizeF() * 0.9);
    return font;
}

}  // namespace

QSize TwoLineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return {160, QFontMetrics(option.font).height() + QFontMetrics(smaller(option.font)).height() + 10};
}

void TwoLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QString text = option.text;
    option.text.clear();
    // The style draws tick and background; the selection is marked as in the other lists.
    const Theme& colors = theme();
    const bool selected = option.state & QStyle::State_Selected;
    option.state &= ~(QStyle::State_Selected | QStyle::State_HasFocus);
    painter->save();
    if (selected) {
        QColor fill = colors.accent;
        fill.setAlphaF(0.18F);
        painter->fillRect(option.rect, fill);
        painter->fillRect(QRect(option.rect.left(), option.rect.top(), 3, option.rect.height()), colors.accent);
    }
    option.rect.adjust(6, 0, 0, 0);
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    const int left =
        option.features & QStyleOptionViewItem::HasCheckIndicator
            ? style->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, option.widget).right() + 8
            : option.rect.left() + 4;
    const QRect words(QPoint(left, option.rect.top() + 4), QPoint(option.rect.right() - 6, option.rect.bottom() - 4));
    painter->setPen(colors.text);
    painter->drawText(words, Qt::AlignTop | Qt::AlignLeft,
                      option.fontMetrics.elidedText(text, Qt::ElideRight, words.width()));
    const QFont small = smaller(option.font);
    painter->setFont(small);
    painter->setPen(colors.dim);
    painter->drawText(words, Qt::AlignBottom | Qt::AlignLeft,
                      QFontMetrics(small).elidedText(index.data(secondLine).toString(), Qt::ElideRight, words.width()));
    if (given.state & QStyle::State_HasFocus) {
        painter->setPen(colors.accent);
        painter->drawRect(given.rect.adjusted(0, 0, -1, -1));
    }
    painter->restore();
}

}  // namespace vitrine::ui

#include "moc_two_line_delegate.cpp"
