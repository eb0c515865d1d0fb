#pragma once

#include <QTableWidget>

namespace vitrine::ui {

class Variations;

/// The pictures of nine variations, three by three: arrows go from one to another, Enter or a click picks one.
class VariationGrid final : public QTableWidget {
    Q_OBJECT

public:
    static constexpr int side = 3;

    /// Must outlive it.
    explicit VariationGrid(const Variations&, QWidget* parent = nullptr);

    /// The one that the keys are at, 0 to 8.
    [[nodiscard]] int current() const { return currentRow() * side + currentColumn(); }
    /// Shows them as they are now.
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
