#pragma once

#include "exhibits/printing/print_preview.h"

#include <QWidget>

#include <memory>

namespace vitrine::ui {

class EyesPreview;
class PrintNumbersView;
class StripPreview;

/// Right side of the print dialog: the raster, the picture for both eyes, and the numbers that a printer asks for.
class PrintResults final : public QWidget {
    Q_OBJECT

public:
    explicit PrintResults(QWidget* parent = nullptr);

    /// Shows a preview; null: none. `distance`: viewing distance in meters. A chart has no picture for the eyes.
    void showPreview(const std::shared_ptr<const printing::PrintPreview>&, double distance, bool chart);
    /// Shows or hides what only a print has.
    void showChart(bool chart);
    [[nodiscard]] PrintNumbersView& numbers() { return *numbers_; }

private:
    StripPreview* strips_;
    EyesPreview* eyes_;
    PrintNumbersView* numbers_;
};

}  // namespace vitrine::ui
