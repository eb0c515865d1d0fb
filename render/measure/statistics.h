#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::render {

/// A closed interval and how sure it is.
struct Interval {
    double low = 0;
    double high = 0;
    double confidence = 0;  ///< Probability that it holds the truth, 0 to 1.

    [[nodiscard]] bool holds(double x) const { return x >= low && x <= high; }
};

/// Several runs of one measurement.
struct Summary {
    std::size_t runs = 0;
    double median = 0;
    double spread = 0;  ///< Median absolute deviation from the median.
    double low = 0;     ///< Smallest and largest run.
    double high = 0;
    Interval interval;  ///< Of the median.
};
/// Of at least one finite sample.
[[nodiscard]] Summary summarize(std::span<const double> samples);

/// Whether the medians differ by no more than twice the standard error of their difference. That of a median is taken
/// from the spread, as for normally distributed runs (1.2533 times the mean's; the spread is 0.6745 of a standard
/// deviation), so that a few outliers count for little. Both have at least one run.
[[nodiscard]] bool indistinguishable(const Summary&, const Summary&);

/// Linear between neighbors for `share` 0 to 1 of at least one finite sample (type 7 of Hyndman and Fan 1996).
[[nodiscard]] double quantile(std::span<const double> samples, double share);

/// The narrowest pair of samples, as far from either end, that holds the median with at least this confidence, by
/// the binomial distribution of how many samples fall below it: no assumption about their distribution. Where so
/// few samples cannot promise that much (under 6 for 95 %), the smallest and the largest with what they do promise.
[[nodiscard]] Interval medianInterval(std::span<const double> samples, double confidence = 0.95);

/// y = exp(offset) x^slope, fitted by least squares in the logarithms of both.
struct PowerLaw {
    double slope = 0;
    double offset = 0;
    Interval slopeInterval;  ///< By Student's t over the residuals; infinite for two points.
    std::size_t points = 0;  ///< Those with positive x and y: only they are fitted.

    [[nodiscard]] bool found() const { return points >= 2; }
};
/// `x` and `y` are of one length. Nothing is found unless two different x are positive with a positive y.
[[nodiscard]] PowerLaw fitPowerLaw(std::span<const double> x, std::span<const double> y, double confidence = 0.95);

/// Student's t below which a share of `probability` (over 1/2 and under 1) lies, to about four digits; `degrees`
/// of freedom at least 1. Hill 1970, "Algorithm 396: Student's t-quantiles".
[[nodiscard]] double studentQuantile(double probability, double degrees);

/// The order in which `count` things are measured in round `round`: forth and back in turn, and begun elsewhere
/// each time, so that a slow drift of the machine falls on all alike.
[[nodiscard]] std::vector<std::size_t> interleaved(std::size_t count, std::size_t round);

}  // namespace vitrine::render
