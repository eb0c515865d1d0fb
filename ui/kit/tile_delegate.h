#pragma once

#include <QPixmap>
#include <QStyledItemDelegate>

namespace vitrine::ui {

/// Delegate of the exhibit and preset lists: draws a picture at the left and one or two lines of text.
class TileDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    static constexpr int secondLine = Qt::UserRole + 1;  ///< Role of the faint line below the name.
    static constexpr int mark = Qt::UserRole + 2;        ///< Role of a word shown in place of a missing picture.
    static constexpr QSize picture{64, 36};              ///< Size of the pictures in pixels at the usual font size.
    /// Returns their size beside text of this font: they grow half as fast, so that room for the text is left.
    [[nodiscard]] static QSize pictureBeside(const QFontMetrics&);

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override;
    /// Makes an opaque editor in place of the name.
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem&, const QModelIndex&) const override;
};

/// Returns a picture cut to the shape of the lists' pictures, at twice their size for high-resolution screens.
[[nodiscard]] QPixmap thumbnailOf(const QImage&);
/// Returns the same at six times their size, to be saved for lists and previews.
[[nodiscard]] QImage previewOf(const QImage&);

}  // namespace vitrine::ui
