#pragma once

#include <string>
#include <vector>

namespace vitrine::render {

/// The channels of a picture that carry its color, by their numbers; -1 where there is none.
struct ColorChannels {
    int red = -1, green = -1, blue = -1;
    int gray = -1;  ///< Set where red, green and blue are not.
    int alpha = -1;
    std::string layer{};                     ///< Name of the layer or view that was chosen; empty for the main one.
    std::vector<std::string> otherLayers{};  ///< Further layers that have color.
    std::string problem{};  ///< A half sentence where there is no color: it names the channels that were found.

    /// The numbers in the order gray, red, green, blue, alpha, without those that are missing.
    [[nodiscard]] std::vector<int> numbers() const;
};

/// Chooses the color among channel names of OpenEXR ("R", "ViewLayer.Combined.R", "left.Y"): the main layer, else a
/// layer whose name says that it is the finished picture ("Combined", "rgba", "beauty"), else the first one. A layer
/// has color when it holds R, G and B, or Y that is neither a coordinate (beside X or Z) nor a luminance (beside RY,
/// BY).
[[nodiscard]] ColorChannels colorChannels(const std::vector<std::string>& names);

}  // namespace vitrine::render
