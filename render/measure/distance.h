#pragma once

#include "render/measure/flip.h"
#include "render/measure/metrics.h"

#include <map>
#include <optional>
#include <vector>

namespace vitrine::render {

/// Two pictures of one size that are compared. What several metrics need is computed once.
class ComparedPictures {
public:
    /// The pictures must outlive it.
    ComparedPictures(const Image& reference, const Image& test, double pixelsPerDegree)
        : reference_(reference), test_(test), pixelsPerDegree_(pixelsPerDegree)
    {
    }

    [[nodiscard]] const Image& reference() const { return reference_; }
    [[nodiscard]] const Image& test() const { return test_; }
    [[nodiscard]] double pixelsPerDegree() const { return pixelsPerDegree_; }
    [[nodiscard]] const ColorDifference& color() const;

private:
    const Image &reference_, &test_;
    double pixelsPerDegree_;
    mutable std::optional<ColorDifference> color_;
};

/// Way in which the errors of several views become one.
enum class ViewPooling : std::uint8_t { mean, rootMeanSquare, largest };

/// Declaration of a metric. Options, help, tables, charts and heat maps are derived from it.
struct MetricInfo {
    Metric metric{};
    std::string_view name;   ///< In options and files: "rmse".
    std::string_view title;  ///< For people, with its unit: "mean angle between normals, degrees".
    /// Distance of the pictures. Nothing if they lack the channels that it compares ("normal.X" to "normal.Z" in both).
    std::optional<double> (*distance)(const ComparedPictures&) = nullptr;
    /// Error of each pixel, one channel. A value that only one picture has gives infinity. Nothing as `distance`.
    std::optional<Image> (*map)(const ComparedPictures&) = nullptr;
    ViewPooling pooling = ViewPooling::mean;
    std::optional<double> fullScale = {};  ///< Error that a heat map shows white. Unset: the largest one.
    bool ofColor = true;                   ///< Compares colors, not another channel.
    /// Made for light beyond 1: `distances` computes it only if a picture has such light. It takes some ten times as
    /// long as the others together.
    bool ofHighRange = false;
    bool falls = false;  ///< Falls with the difference, from infinity for equal pictures.
};

/// All metrics, in the order of the enumerators.
[[nodiscard]] const std::vector<MetricInfo>& allMetrics();
[[nodiscard]] const MetricInfo& metricInfo(Metric);

/// Returns the distance of two pictures of one size by any metric. Returns nothing if they lack the channels that it
/// compares.
[[nodiscard]] std::optional<double> distance(Metric, const Image& reference, const Image& test,
                                             double pixelsPerDegree = flipPixelsPerDegree);
/// Returns the distance by every metric whose channels, and range of light, the pictures have.
[[nodiscard]] std::map<Metric, double> distances(const ComparedPictures&);

/// Returns the error of each pixel, one channel. Returns nothing as `distance` does.
[[nodiscard]] std::optional<Image> errorMap(Metric, const Image& reference, const Image& test,
                                            double pixelsPerDegree = flipPixelsPerDegree);

/// Returns the value that a heat map of these errors shows white: that of the metric, else the largest finite error (1
/// if there is none).
[[nodiscard]] double fullScale(Metric, const Image& errors);

/// Returns whether `value` is worse than `limit`: above it, or below it for a metric that falls.
[[nodiscard]] bool isBeyond(Metric, double value, double limit);

/// Returns the error of all views of which these are the errors; 0 without any.
[[nodiscard]] double pooledError(Metric, const std::vector<double>& errors);

/// Returns the index of the channel of that name, or -1.
[[nodiscard]] int channelNamed(const Image&, std::string_view name);

}  // namespace vitrine::render
