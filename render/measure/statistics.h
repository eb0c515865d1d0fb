#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::render {

/// A closed interval with its confidence.
struct Interval {
    double low = 0;
    double high = 0;
    double confidence = 0;  ///< Probability that it contains the true value, 0 to 1.

    [[nodiscard]] bool holds(double x) const { return x >= low && x <= high; }
};

/// Statistics of several runs of one measurement.
struct Summary {
    std::size_t runs = 0;
    double median = 0;
    double spread = 0;  ///< Median absolute deviation from the median.
    double low = 0;     ///< Smallest and largest run.
    double high = 0;
    Interval interval;  ///< Confidence interval of the median.
};
/// Summarizes at least one sample; all must be finite.
[[nodiscard]] Summary summarize(std::span<const double> samples);

/// Returns whether the medians differ by no more than twice the standard error of their difference. The standard error
/// of a median is estimated from the spread, assuming normally distributed runs (1.2533 times that of the mean; the
/// spread is 0.6745 standard deviations). So a few outliers have little effect. Both need at least one run.
[[nodiscard]] bool indistinguishable(const Summary&, const Summary&);

/// Returns the quantile for `share` from 0 to 1, interpolated linearly (type 7 of Hyndman and Fan 1996). Needs at least
/// one sample; all must be finite.
[[nodiscard]] double quantile(std::span<const double> samples, double share);

/// Returns the narrowest interval between two samples, equally far from either end, that contains the median with at
/// least this confidence. It uses the binomial distribution of how many samples fall below the median, and assumes
/// nothing about their distribution. With too few samples (under 6 for 95 %), returns the smallest and the largest with
/// the confidence that they give.
[[nodiscard]] Interval medianInterval(std::span<const double> samples, double confidence = 0.95);

/// Power law y = exp(offset) x^slope, fitted by least squares in the logarithms of both.
struct PowerLaw {
    double slope = 0;
    double offset = 0;
    Interval slopeInterval;  ///< By Student's t over the residuals; infinite for two points.
    std::size_t points = 0;  ///< Number of fitted points: those with positive x and y.

    [[nodiscard]] bool found() const { return points >= 2; }
};
/// Fits a power law. `x` and `y` have the same length. At least two different positive x with positive y are needed.
[[nodiscard]] PowerLaw fitPowerLaw(std::span<const double> x, std::span<const double> y, double confidence = 0.95);

/// Returns the quantile of Student's t: a share of `probability` (over 1/2 and under 1) lies below it. Accurate to
/// about four digits; `degrees` of freedom must be at least 1. Hill 1970, "Algorithm 396: Student's t-quantiles".
[[nodiscard]] double studentQuantile(double probability, double degrees);

/// Returns the order in which `count` things are measured in round `round`. The direction alternates and the start
/// moves from round to round, so that a slow drift of the machine affects all alike.
[[nodiscard]] std::vector<std::size_t> interleaved(std::size_t count, std::size_t round);

}  // namespace vitrine::render
