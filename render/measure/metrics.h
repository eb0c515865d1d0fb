#pragma once

#include "render/image/image.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace vitrine::render {

/// Metric for the distance of a picture from its reference. All are 0 for equal pictures and grow with the difference,
/// except `psnr`, which falls and is infinite for equal pictures. `allMetrics` (distance.h) declares them.
enum class Metric : std::uint8_t { rmse, psnr, max, beyond, mape, relmse, dssim, flip, hdrflip, normal, depth };

/// Returns the name in options and files: "rmse", "psnr", ...
[[nodiscard]] std::string_view toString(Metric);
[[nodiscard]] std::optional<Metric> metricNamed(std::string_view);
/// Returns the name for people, with its unit: "RMS error of linear light", "mean angle between normals, degrees".
[[nodiscard]] std::string_view title(Metric);

/// Keeps relative errors finite where the reference is black; of linear light, peak 1.
inline constexpr double relativeFloor = 0.01;

/// Distance of the colors of two pictures.
struct ColorDifference {
    double rmse = 0;    ///< Root of the mean squared difference of linear R, G and B; peak 1.
    double max = 0;     ///< Largest difference of one component.
    double beyond = 0;  ///< Share of pixels with a component whose sRGB code differs by more than 1/255; 0 to 1.
    double mape = 0;    ///< Mean of |test - reference| / (|reference| + `relativeFloor`) over all components.
    /// Mean of (test - reference)² / (reference² + `relativeFloor`) over all components (Rousselle, Knaus and Zwicker
    /// 2011, "Adaptive Sampling and Reconstruction using Greedy Error Minimization").
    double relativeMse = 0;

    /// Peak signal to noise ratio in decibels, 20 log10(1 / rmse); infinite for equal pictures.
    [[nodiscard]] double psnr() const;
};

/// Compares the first three channels (or the only one) of two pictures of one size. Alpha, if there is any, is
/// composited over black first, so that the color of transparent pixels does not count. A component that is finite in
/// only one picture counts as an infinite difference; equal infinities count as none.
[[nodiscard]] ColorDifference colorDifference(const Image& a, const Image& b);

/// Distance of two normal maps (three channels from `first`, unit length). A pixel of length below 1/2 has no normal.
struct NormalDifference {
    double mean = 0;     ///< Degrees, over the pixels that have a normal in both.
    double max = 0;      ///< Degrees.
    double missing = 0;  ///< Share of pixels with a normal in only one picture, among those with one in either.
};
[[nodiscard]] NormalDifference normalDifference(const Image& a, const Image& b, int first);

/// Distance of two depth maps (one channel, meters, infinite where nothing was hit).
struct DepthDifference {
    double rms = 0;      ///< Meters, over the pixels where both are finite.
    double max = 0;      ///< Meters.
    double missing = 0;  ///< Share of pixels with a finite depth in only one picture, among those with one in either.
};
[[nodiscard]] DepthDifference depthDifference(const Image& a, const Image& b, int channel);

/// Returns the color error of each pixel, one channel: the root mean squared difference of the three components.
[[nodiscard]] Image differenceMap(const Image& a, const Image& b);
/// The same of relative errors: the mean over the components of |b - a| / (|a| + `relativeFloor`).
[[nodiscard]] Image relativeDifferenceMap(const Image& a, const Image& b);

/// Returns a false-color picture of one-channel errors, as linear light: black at 0, through violet and orange to white
/// at `full` and beyond; values that are not finite are green. `full` must be positive.
[[nodiscard]] Image heatMap(const Image& errors, double full);

/// Returns the signed color difference as a picture in linear light. Each component, as an sRGB code from 0 to 1, is
/// 1/2 plus gain/2 times (the code of `test` minus that of `reference`), clamped to [0, 1]. Gain 1 shows every possible
/// difference without clamping. Colors are clamped to [0, 1] first; alpha is handled as in `colorDifference`. `gain`
/// must be positive.
[[nodiscard]] Image signedDifference(const Image& reference, const Image& test, double gain);

}  // namespace vitrine::render
