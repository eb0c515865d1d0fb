#pragma once

#include <QTableWidget>

namespace vitrine::ui {

class Variations;

/// Grid with the pictures of nine variations, three by three. Arrow keys move the focus; Enter or a click picks one.
class VariationGrid final : public QTableWidget {
    Q_OBJECT

public:
    static constexpr int side = 3;

    /// The variations must outlive the grid.
    explicit VariationGrid(const Variations&, QWidget* parent = nullptr);

    /// Returns the focused variation, 0 to 8.
    [[nodiscard]] int current() const { return currentRow() * side + currentColumn(); }
    /// Shows the present pictures.
    void refresh();

signals:
    void picked(int variation);

protected:
    void keyPressEvent(QKeyEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {260, 160}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 100}; }

private:
    const Variations& variations_;
};

}  // namespace vitrine::ui
