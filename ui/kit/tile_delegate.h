#pragma once

#include <QPixmap>
#include <QStyledItemDelegate>

namespace vitrine::ui {

/// Draws one line of the exhibit or preset list: picture at the left, one or two lines of text.
class TileDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int secondLine = Qt::UserRole + 1;  ///< Role of the quiet line below the name.
    static constexpr int mark = Qt::UserRole + 2;        ///< Role of a word shown where no picture is.
    static constexpr QSize picture{64, 36};

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
    /// In place of the name, and nothing shines through it.
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem&, const QModelIndex&) const override;
};

/// A picture cut to the shape of the lists' pictures, twice as large for fine screens.
[[nodiscard]] QPixmap thumbnailOf(const QImage&);
/// The same, six times as large: to be kept, for lists and for looking at it closely.
[[nodiscard]] QImage previewOf(const QImage&);

}  // namespace vitrine::ui
