#include "render/plan/bound.h"

#include "render/files/number_text.h"

#include <cmath>

namespace vitrine::render {
namespace {

double product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

}  // namespace

Bound boundOf(double share, double radiance, std::initializer_list<Factor> factors)
{
    Bound bound{share, radiance, {}};
    for (const Factor& factor : factors) {
        const double value =
            std::isnan(factor.value) ? std::numeric_limits<double>::infinity() : std::max(factor.value, 0.0);
        bound.share = product(bound.share, value);
        bound.radiance = product(bound.radiance, value);
        if (value == 0 && bound.whyNone.empty()) bound.whyNone = factor.whenZero;
    }
    return bound;
}

std::string toString(const Bound& bound)
{
    if (!bound.isKnown()) return {};
    if (bound.isZero()) return "changes nothing";
    // White is 1 of light: with as much, a pixel can become anything.
    if (bound.share >= 1 || bound.radiance >= 1) return "may change any pixel";
    const std::string radiance = shortNumber(bound.radiance) + " of the light of white";
    if (bound.share == 0) return "changes a pixel by at most " + radiance;
    return "changes a pixel by at most " + shortNumber(100 * bound.share) + " % of its light" +
           (bound.radiance > 0 ? " and " + radiance : "");
}

}  // namespace vitrine::render
