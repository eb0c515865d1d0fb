#pragma once

#include "exhibits/framework/exhibit.h"

#include <QListWidget>
#include <QStyledItemDelegate>

#include <memory>
#include <span>
#include <vector>

namespace vitrine::ui {

/// The hall and its nine places: picture, number, title; places that wait are grey.
class ExhibitList final : public QListWidget {
    Q_OBJECT

public:
    explicit ExhibitList(QWidget* parent = nullptr);

    void fill(std::span<const std::unique_ptr<Exhibit>>, const std::vector<int>& emptyPlaces);
    void setThumbnail(std::size_t exhibit, const QPixmap&);
    [[nodiscard]] bool hasThumbnail(std::size_t exhibit) const;
    /// Marks it as chosen; emits nothing.
    void choose(std::size_t exhibit);

signals:
    void chosen(std::size_t exhibit);

private:
    [[nodiscard]] QListWidgetItem* itemOf(std::size_t exhibit) const;
};

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

}  // namespace vitrine::ui
