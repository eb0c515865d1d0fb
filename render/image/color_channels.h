#pragma once

#include <string>
#include <vector>

namespace vitrine::render {

/// Indices of the channels of a picture that carry its color; -1 for a missing one.
struct ColorChannels {
    int red = -1, green = -1, blue = -1;
    int gray = -1;  ///< Set where red, green and blue are not.
    int alpha = -1;
    std::string layer{};                     ///< Name of the layer or view that was chosen; empty for the main one.
    std::vector<std::string> otherLayers{};  ///< Further layers that have color.
    bool isLuminanceChroma = false;          ///< None is color, and a layer has Y, RY and BY.
    std::string problem{};  ///< Half sentence that names the channels found, if none of them is color; else empty.

    /// Returns the indices in the order gray, red, green, blue, alpha, without missing ones.
    [[nodiscard]] std::vector<int> numbers() const;
};

/// Chooses the color channels by their OpenEXR names ("R", "ViewLayer.Combined.R", "left.Y"). It takes the main layer,
/// else a layer whose name says that it is the finished picture ("Combined", "rgba", "beauty"), else the first one. A
/// layer has color if it contains R, G and B, or Y. Y does not count if it is a coordinate (beside X or Z) or a
/// luminance (beside RY, BY).
[[nodiscard]] ColorChannels colorChannels(const std::vector<std::string>& names);

}  // namespace vitrine::render
