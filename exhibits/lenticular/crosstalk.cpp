#include "exhibits/lenticular/crosstalk.h"

#include "exhibits/lenticular/optics.h"
#include "exhibits/lenticular/proof.h"

#include <algorithm>
#include <cmath>

namespace vitrine::lenticular {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The integral of the normal distribution's integral; of a step when `sigma` is 0.
double ramp(double x, double sigma)
{
    if (!(sigma > 0)) return std::max(x, 0.0);
    const double t = x / sigma;
    return x * 0.5 * std::erfc(-t / std::sqrt(2.0)) + sigma * std::exp(-t * t / 2) / std::sqrt(2 * pi);
}

/// The share before `x` of a box of `width` around 0 that a Gaussian has spread.
double shareBefore(double x, double width, double sigma)
{
    return (ramp(x + width / 2, sigma) - ramp(x - width / 2, sigma)) / width;
}

/// Solves a x = b for all columns of b by elimination; `a` is symmetric and positive definite.
void solve(ViewMatrix& a, ViewMatrix& b)
{
    const int n = a.views;
    for (int pivot = 0; pivot < n; ++pivot) {
        for (int row = 0; row < n; ++row) {
            if (row == pivot) continue;
            const double factor = a.at(row, pivot) / a.at(pivot, pivot);
            if (factor == 0) continue;
            for (int column = pivot; column < n; ++column) a.at(row, column) -= factor * a.at(pivot, column);
            for (int column = 0; column < n; ++column) b.at(row, column) -= factor * b.at(pivot, column);
        }
    }
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) b.at(row, column) /= a.at(row, row);
}

ViewMatrix zeros(int views)
{
    return {views, std::vector<double>(static_cast<std::size_t>(views) * static_cast<std::size_t>(views), 0.0)};
}

}  // namespace

ViewMatrix viewMixing(const PrintLayout& layout)
{
    const PrintSettings& s = layout.settings();
    const double pitch = s.sheet.pitch();
    const double strip = pitch / s.views;
    const double pixel = pitch / layout.pixelsPerLens();
    ViewMatrix mixing = zeros(s.views);
    for (int i = 0; i < s.views; ++i) {
        for (const Aperture::Part& part : aperture(s.sheet, angleOfView(layout, i)).parts) {
            // In lenses from the left cusp of the lens looked through, so that strips count as in the layout.
            const double center = (part.from + part.to) / 2 + (0.5 + s.phase) * pitch;
            const double width = pixel + std::abs(part.to - part.from);
            const double reach = width / 2 + 5 * s.inkSpread;
            for (auto at = static_cast<std::int64_t>(std::floor((center - reach) / strip)); static_cast<double>(at) * strip < center + reach; ++at) {
                const double from = static_cast<double>(at) * strip - center;
                mixing.at(i, layout.viewOfStrip(at)) += part.share * (shareBefore(from + strip, width, s.inkSpread) - shareBefore(from, width, s.inkSpread));
            }
        }
        double sum = 0;
        for (int k = 0; k < s.views; ++k) sum += mixing.at(i, k);
        for (int k = 0; k < s.views && sum > 0; ++k) mixing.at(i, k) /= sum;
    }
    return mixing;
}

ViewMatrix compensation(const ViewMatrix& mixing, double weight)
{
    const int n = mixing.views;
    ViewMatrix normal = zeros(n);
    ViewMatrix wanted = zeros(n);
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) {
            for (int j = 0; j < n; ++j) normal.at(i, k) += mixing.at(j, i) * mixing.at(j, k);
            wanted.at(i, k) = mixing.at(k, i);
        }
        normal.at(i, i) += weight;
        wanted.at(i, i) += weight;
    }
    solve(normal, wanted);
    return wanted;
}

CrossTalk crossTalkOf(const ViewSet& views, const ViewMatrix& mixing, const ViewMatrix& compensated)
{
    constexpr int places = 64;  // Each way.
    const auto n = static_cast<std::size_t>(views.count());
    std::vector<double> plain(n);
    std::vector<double> printed(n);
    double before = 0;
    double after = 0;
    double clipped = 0;
    double count = 0;
    const auto apply = [&](const ViewMatrix& matrix, const std::vector<double>& from, std::size_t i) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k) sum += matrix.weights[i * n + k] * from[k];
        return sum;
    };
    for (int v = 0; v < places; ++v) {
        const int y = static_cast<int>((v + 0.5) / places * views.height());
        for (int u = 0; u < places; ++u) {
            for (std::size_t c = 0; c < 3; ++c, count += static_cast<double>(n)) {
                for (std::size_t k = 0; k < n; ++k) {
                    const int x = static_cast<int>((u + 0.5) / places * views.view(static_cast<int>(k)).width);
                    plain[k] = views.row(static_cast<int>(k), y)[static_cast<std::size_t>(x) * 4 + c] / 65535.0;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const double value = apply(compensated, plain, k);
                    printed[k] = std::clamp(value, 0.0, 1.0);
                    clipped += std::abs(value - printed[k]) > 1e-6 ? 1 : 0;
                }
                for (std::size_t i = 0; i < n; ++i) {
                    before += std::pow(apply(mixing, plain, i) - plain[i], 2);
                    after += std::pow(apply(mixing, printed, i) - plain[i], 2);
                }
            }
        }
        views.rowIsRead(y);
    }
    return {std::sqrt(before / count), std::sqrt(after / count), clipped / count};
}

}  // namespace vitrine::lenticular
