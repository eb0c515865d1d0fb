#pragma once

#include <QStyledItemDelegate>

namespace vitrine::ui {

/// Delegate of lists with ticks: draws the text and a faint second line below.
class TwoLineDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int secondLine = Qt::UserRole + 1;  ///< Role of the faint line.

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
};

}  // namespace vitrine::ui
