#include "render/plan/contribution_bound.h"

#include "render/files/number_text.h"

#include <cassert>
#include <cmath>

namespace vitrine::render {
namespace {

double product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

}  // namespace

std::string whyZero(std::initializer_list<Factor> factors)
{
    for (const Factor& factor : factors)
        if (factor.value <= 0) return std::string(factor.whenZero);
    return {};
}

ContributionBound boundOf(double relative, double absolute, std::initializer_list<Factor> factors)
{
    ContributionBound bound{relative, absolute, {}};
    for (const Factor& factor : factors) {
        const double value =
            std::isnan(factor.value) ? std::numeric_limits<double>::infinity() : std::max(factor.value, 0.0);
        bound.relative = product(bound.relative, value);
        bound.absolute = product(bound.absolute, value);
    }
    bound.whyNone = whyZero(factors);
    assert(!bound.isZero() || !bound.whyNone.empty());
    return bound;
}

std::string toString(const ContributionBound& bound)
{
    if (!bound.isKnown()) return {};
    if (bound.isZero()) return "changes nothing";
    // A white pixel has the value 1, so a change of 1 can give a pixel any color.
    if (bound.relative >= 1 || bound.absolute >= 1) return "may change any pixel";
    const std::string absolute = shortNumber(bound.absolute) + " of the light of white";
    if (bound.relative == 0) return "changes a pixel by at most " + absolute;
    return "changes a pixel by at most " + shortNumber(100 * bound.relative) + " % of its light" +
           (bound.absolute > 0 ? " and " + absolute : "");
}

}  // namespace vitrine::render
