#include "exhibits/printing/crosstalk.h"

#include "exhibits/printing/optics.h"
#include "exhibits/printing/proof.h"
#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::printing {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int places = 64;  ///< Number of places on the print, at which its pixels lie differently under the lens.
constexpr int partsOfAperture = 128;

double fraction(double x)
{
    return x - std::floor(x);
}

/// Returns numbers evenly distributed over 0 to 1, in a different order for each `stream` (Kronecker sequences of
/// square roots of primes).
double spread(int stream, double index)
{
    constexpr std::array<double, 5> roots{1.4142135623730951, 1.7320508075688772, 2.2360679774997898,
                                          2.6457513110645907, 3.3166247903554};
    return fraction(0.5 + index * roots.at(static_cast<std::size_t>(stream)));
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
    const double axis = 0.5 + s.phase;  // Axis of a lens, in lenses of the layout.
    const double pixelsX = layout.printPitch() * s.dpiX / mmPerInch * layout.cosine();  // Pixels between lenses.
    const double pixelsY = layout.printPitch() * s.dpiY / mmPerInch * layout.sine();
    ViewMatrix mixing = zeros(s.views);
    std::vector<ViewWeight> taps;
    for (int i = 0; i < s.views; ++i) {
        const Aperture seen = aperture(s.sheet, angleOfView(layout, i), 0, partsOfAperture);
        double sum = 0;
        for (int place = 0; place < places; ++place) {
            const double x = spread(0, place) * static_cast<double>(layout.width());
            const double y = spread(1, place) * static_cast<double>(layout.height());
            const double u = layout.lensAt(x, y);
            const double toAxis = std::round(u - axis) + axis - u;
            double index = place;
            for (const Aperture::Part& part : seen.parts) {
                index += places;
                const double ink = s.inkSpread * std::sqrt(-2 * std::log(std::max(spread(3, index), 1e-9))) *
                                   std::cos(2 * pi * spread(4, index));
                const double at =
                    toAxis + (part.from + (part.to - part.from) * spread(2, index) + ink) / s.sheet.pitch();
                viewWeightsAt(layout, std::floor(x + at * pixelsX) + 0.5, std::floor(y + at * pixelsY) + 0.5, taps);
                for (const ViewWeight& tap : taps) mixing.at(i, tap.view) += part.share * tap.weight;
                sum += part.share;
            }
        }
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
                    plain[k] = views.row(static_cast<int>(k), y)[static_cast<std::size_t>(x) * 3 + c] / 65535.0;
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

}  // namespace vitrine::printing
