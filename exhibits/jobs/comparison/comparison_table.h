#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/measure/flip.h"

#include <array>

namespace vitrine::jobs {

/// Factors by which differences are multiplied. Each has pictures of its own.
inline constexpr std::array<int, 7> comparisonGains{1, 2, 4, 8, 16, 32, 64};
/// Returns the factors as texts.
[[nodiscard]] const std::vector<std::string>& comparisonGainTexts();

/// Parameters of a comparison of two settings.
struct ComparisonTable final : Parameters {
    Group settingsGroup = group("Settings");
    Text with = text("with", "Name of a comparison that the exhibit of A offers (see `list --json`), in place of B.",
                     labeled("Other technique"));

    Group pictureGroup = group("Pictures");
    Count width = count("width", 640, Range{1, 1000000, logarithmic}.soft(16, 3840), "Size of a picture in pixels.",
                        tuple("size", 'x'));
    Count height = count("height", 360, Range{1, 1000000, logarithmic}.soft(9, 2160), "Size of a picture in pixels.",
                         tuple("size", 'x'));
    Count samples =
        count("samples", 0, Range{1, 4096, logarithmic}.soft(1, 64),
              "Samples per pixel. Auto: the supersamples of a setting that changes them, else 4.", reads(0, "auto"));

    Group measureGroup = group("Measurement");
    Count runs = count("runs", 5, {1, 99}, "Number of timed frames per setting.");
    Real pixelsPerDegree = real("pixelsPerDegree", render::flipPixelsPerDegree, none, Range{1, 1000}.soft(20, 100),
                                "Pixels per degree of the viewer's field of view, for the metric flip.");
    Choice<int> gain = choice("gain", 3, comparisonGainTexts(), "Initial gain of the difference pictures.");
};

[[nodiscard]] const ComparisonTable& comparisonTable();

}  // namespace vitrine::jobs
