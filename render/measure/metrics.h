#pragma once

#include "render/image/image.h"

#include <array>
#include <optional>
#include <string_view>

namespace vitrine::render {

/// How the distance of a picture from its reference is counted. All are 0 for equal pictures and grow with
/// the difference, but for `psnr`, which falls and is infinite for equal ones.
enum class Metric : std::uint8_t { rmse, psnr, max, beyond, flip, normal, depth };
inline constexpr std::array<Metric, 7> allMetrics{Metric::rmse, Metric::psnr,   Metric::max,  Metric::beyond,
                                                  Metric::flip, Metric::normal, Metric::depth};

/// "rmse", "psnr", ... as options and files spell it.
[[nodiscard]] std::string_view toString(Metric);
[[nodiscard]] std::optional<Metric> metricNamed(std::string_view);
/// For people, with its unit: "RMS error of linear light", "mean angle between normals, degrees".
[[nodiscard]] std::string_view title(Metric);

/// Distance of the colors of two pictures.
struct ColorDifference {
    double rmse = 0;    ///< Root of the mean squared difference of linear R, G and B; peak 1.
    double max = 0;     ///< Largest difference of one component.
    double beyond = 0;  ///< Share of pixels of which a component, as an sRGB code, is off by more than 1/255; 0 to 1.

    /// Peak signal to noise ratio in decibels, 20 log10(1 / rmse); infinite for equal pictures.
    [[nodiscard]] double psnr() const;
};

/// Compares the first three channels (or the only one) of two pictures of one size. Alpha, where a picture has
/// it, is composed onto black first, so that the color of what is not there counts nothing. A component that is
/// finite in one picture only counts as infinite; equal infinities count nothing.
[[nodiscard]] ColorDifference colorDifference(const Image& a, const Image& b);

/// Distance of two pictures of unit normals (three channels from `first`); a pixel of length under 1/2 has none.
struct NormalDifference {
    double mean = 0;     ///< Degrees, over the pixels that have a normal in both.
    double max = 0;      ///< Degrees.
    double missing = 0;  ///< Share of pixels that have one in only one of them, of those that have one in either.
};
[[nodiscard]] NormalDifference normalDifference(const Image& a, const Image& b, int first);

/// Distance of two pictures of depth (one channel, meters, infinite where nothing is).
struct DepthDifference {
    double rms = 0;      ///< Meters, over the pixels where both are finite.
    double max = 0;      ///< Meters.
    double missing = 0;  ///< Share of pixels where one is finite and the other is not, of those where either is.
};
[[nodiscard]] DepthDifference depthDifference(const Image& a, const Image& b, int channel);

/// Where the colors differ, one channel: per pixel the root mean squared difference of the three components.
[[nodiscard]] Image differenceMap(const Image& a, const Image& b);

/// A picture of one-channel errors, as linear light: black at 0, through violet and orange to white at `full`
/// and beyond; what is not finite is green. `full` is positive.
[[nodiscard]] Image heatMap(const Image& errors, double full);

/// Which way the colors differ, as a picture in linear light: each component, as an sRGB code from 0 to 1, is 1/2 where
/// both are equal, and gain/2 times how far the code of `test` lies above that of `reference` is added to it. Gain 1
/// shows every difference that there can be; what goes beyond black or white is clamped. Colors are clamped to [0, 1]
/// first, alpha as in `colorDifference`. `gain` is positive.
[[nodiscard]] Image signedDifference(const Image& reference, const Image& test, double gain);

}  // namespace vitrine::render
