#pragma once

#include "ui/explore/pad_corners.h"

#include <QWidget>

#include <array>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace vitrine::ui {

class MorphPad;
class PadControl;
class ParameterPanel;
class PresetController;
class ValueSlider;
class VariationGrid;
class Variations;
class Workbench;

/// Dock that blends four settings, and shows nine variations, of the exhibit whose parameters are shown. While hidden,
/// it reads and draws nothing.
class ExploreDock final : public QWidget {
    Q_OBJECT

public:
    /// All must outlive the dock.
    ExploreDock(Workbench&, PresetController&, const ParameterPanel&, QWidget* parent = nullptr);

    /// Updates the dock. Call when another exhibit's parameters may be shown.
    void follow();

    [[nodiscard]] PadCorners& corners() const { return *corners_; }
    [[nodiscard]] MorphPad& pad() const { return *pad_; }
    [[nodiscard]] Variations& variations() const { return *variations_; }
    [[nodiscard]] VariationGrid& grid() const { return *grid_; }
    /// Returns the combo box that chooses a corner's settings.
    [[nodiscard]] QComboBox& chooser(std::size_t corner) const { return *choosers_.at(corner); }

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void addPad(QVBoxLayout&);
    [[nodiscard]] QComboBox* makeChooser(std::size_t corner);
    void addVariations(QVBoxLayout&);
    /// Fills the chooser of a corner and selects its present entry.
    void fillChooser(std::size_t corner);
    void choose(std::size_t corner, int entry);
    void beginAnew();
    void refreshVariations();
    [[nodiscard]] QString stateOfVariations() const;

    Workbench& workbench_;
    PadCorners* corners_;
    MorphPad* pad_;
    PadControl* control_ = nullptr;
    std::array<QComboBox*, PadCorners::count> choosers_{};
    Variations* variations_;
    VariationGrid* grid_;
    QSpinBox* number_;
    ValueSlider* strength_;
    QLabel* percent_;
    QLabel* state_;
    QPushButton* anew_;
    QPushButton* goOn_;
    std::optional<std::size_t> exhibit_;  // Exhibit that is explored; unset: the one shown next.
};

}  // namespace vitrine::ui
