#pragma once

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/view_weights.h"

#include <string>
#include <vector>

namespace vitrine::printing {

enum class ChartKind : std::uint8_t {
    pitch,     ///< Bands of black and white views at LPI around the sheet's; the correct one is evenly lit.
    phase,     ///< Bands at phases 0 to 1.
    views,     ///< Bands of 1 to N views, one of them white; the largest number still distinguishable is usable.
    rotation,  ///< The middle view black and all others white over the full height: uniform if the sheet is straight.
};

/// A calibration chart to print and lay the lenses on. Its patterns use the same weights as prints, so they show the
/// printer and the sheet, not the drawing of the chart.
///
/// Each band carries its value in ink at both ends and in the middle. Around the bands are lines that are not at lens
/// pitch, to square the sheet by. A ruler in millimeters along both sides shows whether the printer scaled. The two
/// feed directions are printed to tick one, since a printer's scale differs between them: print the chart once each
/// way.
class Chart {
public:
    /// Makes a chart of the layout's size, sheet, direction and (for views and rotation) number of views. `span` is the
    /// range of LPI of a pitch chart in each direction, 0.01 for 1 %. Throws Failure (ErrorKind::usage) if the print is
    /// too small.
    Chart(const PrintLayout&, ChartKind, double span);

    void fill(const Region&, std::uint8_t* out) const;
    void fill(const Region&, std::uint16_t* out) const;

    struct Band {
        double from = 0, to = 0;  ///< Along the lenses, in millimeters from the print's top or left edge.
        PrintLayout layout;
        std::vector<double> views;  ///< Linear level of each view.
        std::string label{};
    };
    [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }

private:
    [[nodiscard]] double level(double x, double y, std::vector<ViewWeight>& taps) const;
    [[nodiscard]] bool inked(double along, double across) const;
    template <typename Code> void fillCodes(const Region&, Code* out) const;

    PrintLayout layout_;
    std::vector<Band> bands_;
    std::string title_;
    double along_ = 0, across_ = 0;  ///< Sides of the print in millimeters, along and across the lenses.
    bool upright_ = true;            ///< Whether the lenses are closer to vertical than to horizontal.
};

/// Returns whether a text, 7 cells high and 6 cells per letter, has ink in a cell; `column` counts from its left end.
[[nodiscard]] bool textCell(const std::string& text, int column, int row);

}  // namespace vitrine::printing
