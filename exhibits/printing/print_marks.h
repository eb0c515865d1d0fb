#pragma once

#include "exhibits/printing/interlace.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// Marks for the press in the border of a print: crop marks at the corners of the trim and at cuts, registration marks
/// at the middle of each side, a bar of colors below, and a strip of lines at the pitch of the lenses along the edge
/// that crosses them. Nothing lies on trim or bleed.
class PrintMarks {
public:
    /// `cuts`: columns of `tileCuts`. Throws Failure (ErrorKind::usage) if the print is too narrow for the marks that
    /// the layout asks for.
    explicit PrintMarks(const PrintLayout&, const std::vector<std::int64_t>& cuts = {});

    /// Draws the marks over a region of the raster in sRGB, rows without padding.
    void draw(const Region&, std::uint8_t* rgb) const;
    void draw(const Region&, std::uint16_t* rgb) const;

private:
    using Color = std::array<double, 3>;
    struct Box {
        Region at;
        Color color{};
    };
    struct Ring {
        double x = 0, y = 0;             ///< Center in pixels.
        double radius = 0, width = 0.1;  ///< Millimeters.
    };

    void addCropMarks(const std::vector<std::int64_t>& cuts);
    void addRegistration(double x, double y);
    void addColorBar();
    void addPitchStrip();
    void addBox(double x0, double y0, double x1, double y1, const Color& color = {});
    template <typename Code> void drawCodes(const Region&, Code* rgb) const;
    template <typename Code> void drawRing(const Ring&, const Region&, Code* rgb) const;

    PrintLayout layout_;
    double perMmX_, perMmY_;    ///< Pixels per millimeter.
    double borderX_, borderY_;  ///< Pixels.
    std::vector<Box> boxes_;
    std::vector<Ring> rings_;
    std::vector<Region> lensLines_;  ///< Areas of lines at lens pitch.
};

}  // namespace vitrine::printing
