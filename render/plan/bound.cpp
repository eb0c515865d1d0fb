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
        const double value = std::isnan(factor.value) ? std::numeric_limits<double>::infinity() : std::max(factor.value, 0.0);
        bound.share = product(bound.share, value);
        bound.radiance = product(bound.radiance, value);
        if (value == 0 && bound.whyNone.empty()) bound.whyNone = factor.whenZero;
    }
    return bound;
}

std::string toString(const Bound& bound)
{
    if (!bound.isKnown()) return {};
    if (bound.isZero()) return "nothing: its bound is 0";
    const std::string share = bound.share > 0 ? shortNumber(100 * bound.share) + " % of the light" : std::string();
    const std::string radiance = bound.radiance > 0 ? shortNumber(bound.radiance) : std::string();
    if (share.empty()) return "at most " + radiance + " of light";
    return "at most " + share + (radiance.empty() ? std::string() : " and " + radiance + " more");
}

}  // namespace vitrine::render
