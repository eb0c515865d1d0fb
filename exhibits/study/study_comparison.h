#pragma once

#include "exhibits/study/kept_study.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// Why milliseconds of several studies may not be held against each other.
enum class TimesDiffer : std::uint8_t { no, notTaken, unknownMachine, machine, size, surroundings, clock };
[[nodiscard]] TimesDiffer timesDiffer(const std::vector<KeptStudy>&);

/// The units of cost that all these studies share: "ms" if their times may be compared, listed first if their clock is
/// trusted; then the counters that every study has and that differ among its settings, the most telling first.
[[nodiscard]] std::vector<std::string> sharedCosts(const std::vector<KeptStudy>&);

/// One study in a comparison. Counted costs are per pixel and view, so that those of any size can be compared.
struct ComparedCurve {
    std::string label;
    bool leftOut = false;  ///< Its errors are of another metric than those of the first.
    struct Point {
        std::size_t point = 0;  ///< Of the study.
        std::string text;
        double cost = 0, costLow = 0, costHigh = 0;
        double costConfidence = 1;                      ///< That the true cost is between low and high.
        double error = 0, errorLow = 0, errorHigh = 0;  ///< Over the views.
        bool uncertain = false;
        bool onFront = false;
    };
    std::vector<Point> points;  ///< By growing cost; only what was measured.

    [[nodiscard]] std::vector<Point> front() const;
};

/// How another study stands to one point of the first one's front.
struct StudyDifference {
    std::size_t study = 0;  ///< Of those compared; at least 1.
    std::string text;       ///< Of the first study's point.
    double cost = 0, error = 0;
    /// The other's error at this cost: along its front, between two settings on logarithmic scales. Nothing where the
    /// other measured nothing so cheap.
    std::optional<double> errorAtCost;
    /// What the other pays for this error; nothing where it measured nothing so exact.
    std::optional<double> costAtError;
    /// Of the other's cost to this one's. Confidence 1: of counted work. Beside costs that were timed, as sure as the
    /// two times are together.
    std::optional<render::Interval> costRatio;
    bool uncertain = false;  ///< One of the errors is close to what the references themselves are sure of.
};

struct StudyComparison {
    std::string cost;  ///< "ms" or a counter.
    render::Metric metric = render::Metric::rmse;
    std::vector<ComparedCurve> curves;  ///< In the order of the studies.
    std::vector<StudyDifference> differences;
};

/// `cost` is one of `sharedCosts`; `labels` are for people and stand in the order of the studies, of which there are
/// two or more.
[[nodiscard]] StudyComparison compareStudies(const std::vector<KeptStudy>&, const std::vector<std::string>& labels,
                                             const std::string& cost);

/// Names for people, none of which stands twice: those that were given, else what was measured, and where that is the
/// same, when.
[[nodiscard]] std::vector<std::string> labelsOf(const std::vector<KeptStudy>&);

/// What a comparison found, as "format": "vitrine-study-comparison", and as a table of its points.
[[nodiscard]] render::Json comparisonJson(const std::vector<KeptStudy>&, const StudyComparison&);
[[nodiscard]] std::string comparisonCsv(const StudyComparison&);

}  // namespace vitrine
