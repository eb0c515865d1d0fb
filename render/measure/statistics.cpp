#include "render/measure/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine::render {
namespace {

std::vector<double> sorted(std::span<const double> samples)
{
    std::vector<double> copy(samples.begin(), samples.end());
    std::sort(copy.begin(), copy.end());
    return copy;
}

double quantileOfSorted(const std::vector<double>& values, double share)
{
    assert(!values.empty());
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

/// Returns the probability that at most `k` of `n` tosses of a fair coin show heads.
double coinDistribution(std::size_t n, std::size_t k)
{
    const auto logChoose = [](double a, double b) {
        return std::lgamma(a + 1) - std::lgamma(b + 1) - std::lgamma(a - b + 1);
    };
    double sum = 0;
    for (std::size_t i = 0; i <= k; ++i)
        sum += std::exp(logChoose(static_cast<double>(n), static_cast<double>(i)) -
                        static_cast<double>(n) * std::numbers::ln2);
    return sum;
}

}  // namespace

double quantile(std::span<const double> samples, double share)
{
    return quantileOfSorted(sorted(samples), share);
}

Interval medianInterval(std::span<const double> samples, double confidence)
{
    assert(!samples.empty());
    const std::vector<double> values = sorted(samples);
    const std::size_t n = values.size();
    Interval interval{values.front(), values.back(), 1 - 2 * coinDistribution(n, 0)};
    for (std::size_t k = 1; 2 * k + 1 < n + 1; ++k) {
        const double promised = 1 - 2 * coinDistribution(n, k);
        if (promised < confidence) break;
        interval = {values[k], values[n - 1 - k], promised};
    }
    interval.confidence = std::max(interval.confidence, 0.0);
    return interval;
}

Summary summarize(std::span<const double> samples)
{
    assert(!samples.empty());
    const std::vector<double> values = sorted(samples);
    Summary summary;
    summary.runs = values.size();
    summary.median = quantileOfSorted(values, 0.5);
    summary.low = values.front();
    summary.high = values.back();
    std::vector<double> deviations;
    for (const double v : values) deviations.push_back(std::abs(v - summary.median));
    summary.spread = quantile(deviations, 0.5);
    summary.interval = medianInterval(values);
    return summary;
}

bool indistinguishable(const Summary& a, const Summary& b)
{
    const auto variance = [](const Summary& s) {
        const double deviation = s.spread / 0.6744897501960817;
        return std::numbers::pi / 2 * deviation * deviation / static_cast<double>(s.runs);
    };
    return std::abs(a.median - b.median) <= 2 * std::sqrt(variance(a) + variance(b));
}

PowerLaw fitPowerLaw(std::span<const double> x, std::span<const double> y, double confidence)
{
    assert(x.size() == y.size());
    std::vector<double> u;
    std::vector<double> v;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(x[i] > 0 && y[i] > 0 && std::isfinite(x[i]) && std::isfinite(y[i]))) continue;
        u.push_back(std::log(x[i]));
        v.push_back(std::log(y[i]));
    }
    PowerLaw law;
    const auto n = static_cast<double>(u.size());
    if (u.size() < 2) return law;
    double meanU = 0;
    double meanV = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        meanU += u[i] / n;
        meanV += v[i] / n;
    }
    double uu = 0;
    double uv = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        uu += (u[i] - meanU) * (u[i] - meanU);
        uv += (u[i] - meanU) * (v[i] - meanV);
    }
    if (!(uu > 0)) return law;
    law.points = u.size();
    law.slope = uv / uu;
    law.offset = meanV - law.slope * meanU;
    law.slopeInterval = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 1};
    if (u.size() == 2) return law;
    double residual = 0;
    for (std::size_t i = 0; i < u.size(); ++i) residual += std::pow(v[i] - law.offset - law.slope * u[i], 2);
    const double half = studentQuantile(0.5 + confidence / 2, n - 2) * std::sqrt(residual / (n - 2) / uu);
    law.slopeInterval = {law.slope - half, law.slope + half, confidence};
    return law;
}

double studentQuantile(double probability, double degrees)
{
    assert(probability > 0.5 && probability < 1 && degrees >= 1);
    const double p = 2 * (1 - probability);  // Both tails.
    constexpr double halfPi = std::numbers::pi / 2;
    if (degrees == 1) return std::cos(p * halfPi) / std::sin(p * halfPi);
    if (degrees == 2) return std::sqrt(2 / (p * (2 - p)) - 2);
    const double n = degrees;
    const double a = 1 / (n - 0.5);
    const double b = 48 / (a * a);
    double c = ((20700 * a / b - 98) * a - 16) * a + 96.36;
    const double d = ((94.5 / (b + c) - 3) / b + 1) * std::sqrt(a * halfPi) * n;
    double x = d * p;
    double y = std::pow(x, 2 / n);
    if (y > 0.05 + a) {
        // Normal quantile, by Newton's method on erfc.
        x = 0;
        for (int i = 0; i < 60; ++i)
            x -= (0.5 * std::erfc(x / std::numbers::sqrt2) - p / 2) /
                 (-std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi));
        x = -x;
        y = x * x;
        if (n < 5) c += 0.3 * (n - 4.5) * (x + 0.6);
        c = (((0.05 * d * x - 5) * x - 7) * x - 2) * x + b + c;
        y = (((((0.4 * y + 6.3) * y + 36) * y + 94.5) / c - y - 3) / b + 1) * x;
        y = a * y * y;
        y = y > 0.002 ? std::expm1(y) : 0.5 * y * y + y;
    } else {
        y = ((1 / (((n + 6) / (n * y) - 0.089 * d - 0.822) * (n + 2) * 3) + 0.5 / (n + 4)) * y - 1) * (n + 1) /
                (n + 2) +
            1 / y;
    }
    return std::sqrt(n * y);
}

std::vector<std::size_t> interleaved(std::size_t count, std::size_t round)
{
    std::vector<std::size_t> order;
    // Starting a third of the list later each round varies the start faster than single steps.
    const std::size_t start = count == 0 ? 0 : round * (count / 3 + 1) % count;
    for (std::size_t i = 0; i < count; ++i) order.push_back((start + i) % count);
    if (round % 2 == 1) std::reverse(order.begin(), order.end());
    return order;
}

}  // namespace vitrine::render
