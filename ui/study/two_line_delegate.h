#pragma once

#include <QStyledItemDelegate>

namespace vitrine::ui {

/// Draws a line of a list that may be ticked: its text, and a quiet second line below.
class TwoLineDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int secondLine = Qt::UserRole + 1;  ///< Role of the quiet line.

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
};

}  // namespace vitrine::ui
