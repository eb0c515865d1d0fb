#pragma once

#include "exhibits/study/kept_study.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// Reason why milliseconds of several studies cannot be compared.
enum class TimesDiffer : std::uint8_t { no, notTaken, unknownMachine, machine, size, surroundings, clock };
[[nodiscard]] TimesDiffer timesDiffer(const std::vector<KeptStudy>&);

/// Returns the units of cost that all these studies share. "ms" is included if their times may be compared, and comes
/// first if their clock is trusted. Then follow the counters that every study has and that differ among its settings,
/// the most telling first.
[[nodiscard]] std::vector<std::string> sharedCosts(const std::vector<KeptStudy>&);

/// One study in a comparison. Counted costs are per pixel and view, so studies of any size can be compared.
struct ComparedCurve {
    std::string label;
    bool leftOut = false;  ///< Whether it is left out because its metric differs from that of the first.
    struct Point {
        std::size_t point = 0;  ///< Index in the study.
        std::string text;
        double cost = 0, costLow = 0, costHigh = 0;
        double costConfidence = 1;                      ///< Confidence that the true cost is between low and high.
        double error = 0, errorLow = 0, errorHigh = 0;  ///< Over the views.
        bool uncertain = false;
        bool onFront = false;
    };
    std::vector<Point> points;  ///< By increasing cost; only measured points.

    [[nodiscard]] std::vector<Point> front() const;
};

/// Comparison of another study with one point on the first one's front.
struct StudyDifference {
    std::size_t study = 0;  ///< Index among the compared studies; at least 1.
    std::string text;       ///< Setting of the first study's point.
    double cost = 0, error = 0;
    /// The other's error at this cost, interpolated along its front on logarithmic scales. Nothing if the other
    /// measured nothing as cheap.
    std::optional<double> errorAtCost;
    /// The other's cost at this error; nothing if it measured nothing as exact.
    std::optional<double> costAtError;
    /// Ratio of the other's cost to this one's. The confidence is 1 for counted work. For times it follows from the
    /// confidences of both.
    std::optional<render::Interval> costRatio;
    bool uncertain = false;  ///< Whether one of the errors is close to the uncertainty of its reference.
};

struct StudyComparison {
    std::string cost;  ///< "ms" or a counter.
    render::Metric metric = render::Metric::rmse;
    std::vector<ComparedCurve> curves;  ///< In the order of the studies.
    std::vector<StudyDifference> differences;
};

/// Compares two or more studies. `cost` is one of `sharedCosts`; `labels` are displayed names in the order of the
/// studies.
[[nodiscard]] StudyComparison compareStudies(const std::vector<KeptStudy>&, const std::vector<std::string>& labels,
                                             const std::string& cost);

/// Returns unique displayed names: the given ones, otherwise what was measured, and if that is the same, when.
[[nodiscard]] std::vector<std::string> labelsOf(const std::vector<KeptStudy>&);

/// Return a comparison as JSON with "format": "vitrine-study-comparison", and as a table of its points.
[[nodiscard]] render::Json comparisonJson(const std::vector<KeptStudy>&, const StudyComparison&);
[[nodiscard]] std::string comparisonCsv(const StudyComparison&);

}  // namespace vitrine::study
