#pragma once

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_set.h"

#include <cstddef>
#include <vector>

namespace vitrine::printing {

/// A square matrix over the views: `at(i, k)` weighs view k in what belongs to view i. Rows sum to 1.
struct ViewMatrix {
    int views = 0;
    std::vector<double> weights{};  ///< Row by row; empty stands for "as they are".

    [[nodiscard]] double at(int i, int k) const
    {
        return weights[static_cast<std::size_t>(i) * static_cast<std::size_t>(views) + static_cast<std::size_t>(k)];
    }
    [[nodiscard]] double& at(int i, int k)
    {
        return weights[static_cast<std::size_t>(i) * static_cast<std::size_t>(views) + static_cast<std::size_t>(k)];
    }
};

/// What an eye at the angle of each view sees of all views: the exact optics of the lens, the print's own pixels, as
/// they lie under lenses all over it, and a Gaussian of the ink's spread. Neighboring lenses count as showing the
/// same. Sampled: good to about 0.005.
[[nodiscard]] ViewMatrix viewMixing(const PrintLayout&);

/// The views to print so that the mixed ones come near the wanted ones: the v' that makes
/// |M v' - v|^2 + weight |v' - v|^2 least (A. N. Tikhonov, Solution of incorrectly formulated problems, 1963), which is
/// (M^T M + weight)^-1 (M^T + weight) v. The larger the weight, the nearer to the views themselves: it keeps
/// noise and contrast in bounds.
[[nodiscard]] ViewMatrix compensation(const ViewMatrix& mixing, double weight = 0.02);

/// Cross-talk of a set of views, simulated at the views' own angles, in linear light.
struct CrossTalk {
    double before = 0;   ///< Root mean square of what is seen of other views, printed as they are.
    double after = 0;    ///< The same of compensated views, held to black and white.
    double clipped = 0;  ///< Share of compensated samples that lay beyond black or white.
};
/// Over a grid of places on the views.
[[nodiscard]] CrossTalk crossTalkOf(const ViewSet&, const ViewMatrix& mixing, const ViewMatrix& compensated);

}  // namespace vitrine::printing
