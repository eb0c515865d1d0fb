#pragma once

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_set.h"

#include <cstddef>
#include <vector>

namespace vitrine::printing {

/// Square matrix over the views: `at(i, k)` is the weight of view k in view i. Rows sum to 1.
struct ViewMatrix {
    int views = 0;
    std::vector<double> weights{};  ///< Row by row; empty means the identity.

    [[nodiscard]] double at(int i, int k) const
    {
        return weights[static_cast<std::size_t>(i) * static_cast<std::size_t>(views) + static_cast<std::size_t>(k)];
    }
    [[nodiscard]] double& at(int i, int k)
    {
        return weights[static_cast<std::size_t>(i) * static_cast<std::size_t>(views) + static_cast<std::size_t>(k)];
    }
};

/// Returns how much of each view an eye sees at the angle of every view. Includes the exact optics of the lens, the
/// print's pixels at their positions under the lenses, and a Gaussian of the ink's spread. Neighboring lenses are
/// assumed to show the same. Sampled, with an error of about 0.005.
[[nodiscard]] ViewMatrix viewMixing(const PrintLayout&);

/// Returns the matrix of views to print so that their mixture is close to the original views. It minimizes |M v' - v|^2
/// + weight |v' - v|^2 (A. N. Tikhonov, Solution of incorrectly formulated problems, 1963), so v' is (M^T M +
/// weight)^-1 (M^T + weight) v. A larger weight keeps v' closer to the views, which limits noise and contrast.
[[nodiscard]] ViewMatrix compensation(const ViewMatrix& mixing, double weight = 0.02);

/// Cross-talk of a set of views, simulated at the views' own angles, in linear light.
struct CrossTalk {
    double before = 0;   ///< Root mean square of what is seen of other views, without compensation.
    double after = 0;    ///< The same with compensated views, clamped to black and white.
    double clipped = 0;  ///< Share of compensated samples beyond black or white.
};
/// Returns the cross-talk over a grid of places on the views.
[[nodiscard]] CrossTalk crossTalkOf(const ViewSet&, const ViewMatrix& mixing, const ViewMatrix& compensated);

}  // namespace vitrine::printing
