#pragma once

#include "exhibits/printing/print_views.h"
#include "ui/model/history.h"

#include <QWidget>

#include <array>
#include <cstddef>
#include <vector>

class QDoubleSpinBox;
class QGridLayout;
class QSpinBox;
class QToolButton;

namespace vitrine::ui {

class PrintSetup;

/// Fields for the turn and the shift of one view of a print, with a field that chooses the view.
class PlaceBar final : public QWidget {
    Q_OBJECT

public:
    /// The setup must outlive it.
    PlaceBar(PrintSetup&, QWidget* parent);

    /// Offers the views that were read; null: none.
    void showViews(const printing::PrintViews*);

private:
    void layOut(QGridLayout&);
    void showPlace();
    void change(std::size_t field);
    /// Returns the number of the picture that the chosen view is made from; 0: there is none.
    [[nodiscard]] int picture() const;
    /// Returns the places that are set; none where their text cannot be read.
    [[nodiscard]] printing::ViewPlaces places() const;
    /// Returns the place of the chosen view.
    [[nodiscard]] printing::ViewPlace place() const;
    void set(const printing::ViewPlace&, Gesture, const QString& text);

    PrintSetup& setup_;
    QSpinBox* view_;
    std::array<QDoubleSpinBox*, 3> numbers_{};  ///< Turn, right, down.
    QToolButton* reset_;
    std::vector<int> pictures_;  ///< Numbers of the pictures, one for each view.
    Gesture gesture_ = 0;        ///< Consecutive changes of one field of one view are one step to undo; 0: none yet.
    std::size_t changed_ = 0;    ///< Index of that field.
};

}  // namespace vitrine::ui
