#pragma once

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/taps.h"

#include <string>
#include <vector>

namespace vitrine::printing {

enum class ChartKind : std::uint8_t {
    pitch,     ///< Bands of black and white views at LPI around the sheet's: the right one is evenly lit.
    phase,     ///< Bands at phases 0 to 1.
    views,     ///< Bands of 1 to N views, one of them white: as many as still show apart can be used.
    rotation,  ///< The middle view black and all others white over the full height: uniform when straight.
};

/// A sheet to print and lay the lenses on. Its patterns come from the same weights as prints, so that they
/// show the printer and the sheet, not the drawing of the chart.
///
/// Each band carries its value in ink at both ends and in the middle. Around the bands: lines that are not at
/// lens pitch, to square the sheet by; a ruler in millimeters along both sides, to see whether the printer
/// scaled; the two feed directions to tick one of, since a printer's scale
/// differs between them: print the chart once each way.
class Chart {
public:
    /// Makes a chart of the layout's size, sheet, direction and (for views and rotation) number of views.
    /// `span` is how far the LPI of a pitch chart goes each way, 0.01 for 1 %. Throws Failure (Blame::usage)
    /// when the print is too small for it.
    Chart(const PrintLayout&, ChartKind, double span);

    void fill(const Region&, std::uint8_t* out) const;
    void fill(const Region&, std::uint16_t* out) const;

    struct Band {
        double from = 0, to = 0;  ///< Along the lenses, in millimeters from the print's top or left edge.
        PrintLayout layout;
        std::vector<double> views;  ///< The linear level of each.
        std::string label{};
    };
    [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }

private:
    [[nodiscard]] double level(double x, double y, std::vector<Tap>& taps) const;
    [[nodiscard]] bool inked(double along, double across) const;
    template <typename Code> void fillCodes(const Region&, Code* out) const;

    PrintLayout layout_;
    std::vector<Band> bands_;
    std::string title_;
    double along_ = 0, across_ = 0;  ///< The print's sides in millimeters, along the lenses and across them.
    bool upright_ = true;            ///< The lenses run up rather than sideways.
};

/// Whether the text, 7 cells high and 6 cells a letter, has ink in a cell; `column` counts from its left end.
[[nodiscard]] bool textCell(const std::string& text, int column, int row);

}  // namespace vitrine::printing
