// Morphing among four settings with any legal values: exact at the corners, symmetric, within all ranges, and on an
// edge equal to the morph between two.

#include "exhibits/framework/table/morph.h"
#include "tests/exhibits/framework/table/every_kind.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>  // After gtest, which it needs.

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using namespace vitrine;
using test::everyKind;

using Four = std::array<ParameterValues, 4>;
using Weights = std::array<double, 4>;

/// Returns a share from 0 to 1, in steps that binary fractions represent exactly.
double share()
{
    return *rc::gen::inRange<int>(0, 1025) / 1024.0;
}

Value legalValue(const ParameterInfo& parameter)
{
    switch (parameter.kind) {
    case Kind::color: return glm::dvec3(share(), share(), share());
    // Within half of the sphere or circle, where the mean is unique.
    case Kind::direction: return glm::dvec3(8 * (share() - 0.5), 8 * (share() - 0.5), 1.0);
    case Kind::file:
    case Kind::text: return "picture " + std::to_string(*rc::gen::inRange(0, 9)) + ".png";
    default: break;
    }
    if (parameter.unit == Unit::degree) return 2.5 + 2.8 * (share() - 0.5);  // Also beyond the end of its range.
    return parameter.range.low + share() * (parameter.range.high - parameter.range.low);
}

ParameterValues legalValues()
{
    ParameterValues values = everyKind.initial();
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        Value value = legalValue(values.rows()[i]);
        if (values.rows()[i].unit == Unit::degree)
            value = std::remainder(std::get<double>(value), 2 * 3.14159265358979323846);
        values.setParameter(i, value);
    }
    return values;
}

Four fourSettings()
{
    return {legalValues(), legalValues(), legalValues(), legalValues()};
}

/// Returns the weights of a point in a square whose corners are the settings, row by row.
Weights weightsAt(double x, double y)
{
    return {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
}

ParameterValues among(const Four& four, const Weights& weights)
{
    std::array<WeightedValues, 4> parts{};
    for (std::size_t i = 0; i < 4; ++i) parts.at(i) = {&four.at(i), weights.at(i)};
    return morphed(parts);
}

/// Returns whether two values are equal up to rounding, including directions, colors, and angles on the circle.
bool nearlyEqual(const ParameterInfo& parameter, const Value& a, const Value& b)
{
    if (parameter.isWritten() || parameter.kind == Kind::toggle || parameter.kind == Kind::choice) return a == b;
    if (const auto* three = std::get_if<glm::dvec3>(&a)) return glm::distance(*three, std::get<glm::dvec3>(b)) < 1e-9;
    const double x = std::get<double>(a), y = std::get<double>(b);
    if (parameter.unit == Unit::degree) return std::abs(std::remainder(x - y, 2 * 3.14159265358979323846)) < 1e-9;
    return std::abs(x - y) <= 1e-12 * std::max(std::abs(x), std::abs(y)) + (parameter.kind == Kind::count ? 1 : 0);
}

bool nearlyEqual(const ParameterValues& a, const ParameterValues& b)
{
    for (std::size_t i = 0; i < a.rows().size(); ++i)
        if (!nearlyEqual(a.rows()[i], a.row(i), b.row(i))) return false;
    return true;
}

RC_GTEST_PROP(MorphProperty, AtACornerThereIsExactlyThatSetting, ())
{
    const Four four = fourSettings();
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const Weights weights = weightsAt(corner % 2 == 1 ? 1 : 0, corner >= 2 ? 1 : 0);
        RC_ASSERT(among(four, weights) == four.at(corner));
    }
}

RC_GTEST_PROP(MorphProperty, WhichSettingStandsAtWhichCornerDoesNotMatter, ())
{
    const Four four = fourSettings();
    const Weights weights = weightsAt(share(), share());
    // For equal weights the first setting decides, so symmetry holds only without ties.
    Weights sorted = weights;
    std::sort(sorted.begin(), sorted.end());
    RC_PRE(sorted[3] > sorted[2]);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    for (std::size_t i = 3; i > 0; --i) std::swap(order.at(i), order.at(*rc::gen::inRange<std::size_t>(0, i + 1)));
    const Four turned{four.at(order[0]), four.at(order[1]), four.at(order[2]), four.at(order[3])};
    const Weights theirs{weights.at(order[0]), weights.at(order[1]), weights.at(order[2]), weights.at(order[3])};
    RC_ASSERT(nearlyEqual(among(four, weights), among(turned, theirs)));
}

RC_GTEST_PROP(MorphProperty, NothingLeavesTheFourNorItsRange, ())
{
    const Four four = fourSettings();
    const ParameterValues result = among(four, weightsAt(share(), share()));
    for (std::size_t i = 0; i < result.rows().size(); ++i) {
        const ParameterInfo& row = result.rows()[i];
        const auto isOneOfThem = [&] {
            return std::any_of(four.begin(), four.end(),
                               [&](const auto& each) { return each.row(i) == result.row(i); });
        };
        if (row.isWritten() || row.kind == Kind::toggle || row.kind == Kind::choice) {
            RC_ASSERT(isOneOfThem());
        } else if (row.isNumeric()) {
            const double x = std::get<double>(result.row(i));
            RC_ASSERT(x >= row.range.low && x <= row.range.high);
            RC_ASSERT(row.kind != Kind::count || x == std::round(x));
            if (row.unit == Unit::degree) continue;  // On a circle there is no order.
            double low = row.range.high, high = row.range.low;
            for (const ParameterValues& each : four) {
                low = std::min(low, std::get<double>(each.row(i)));
                high = std::max(high, std::get<double>(each.row(i)));
            }
            RC_ASSERT(x >= low && x <= high);
        } else if (row.kind == Kind::color) {
            const auto color = std::get<glm::dvec3>(result.row(i));
            RC_ASSERT(color == glm::clamp(color, 0.0, 1.0));
        } else {
            RC_ASSERT(std::abs(glm::length(std::get<glm::dvec3>(result.row(i))) - 1) < 1e-12);
        }
    }
}

RC_GTEST_PROP(MorphProperty, OnAnEdgeItIsTheWayBetweenTheTwo, ())
{
    const Four four = fourSettings();
    const double t = share();
    const auto same = [&](const Weights& weights, std::size_t from, std::size_t to) {
        // In the middle the first corner decides, which is the end of the reversed morph.
        return nearlyEqual(among(four, weights), morphed(four.at(to), four.at(from), 1 - t));
    };
    RC_ASSERT(same(weightsAt(t, 0), 0, 1));
    RC_ASSERT(same(weightsAt(t, 1), 2, 3));
    RC_ASSERT(same(weightsAt(0, t), 0, 2));
    RC_ASSERT(same(weightsAt(1, t), 1, 3));
}

RC_GTEST_PROP(MorphProperty, BesideAnEdgeItIsNearlyAsOnIt, ())
{
    const Four four = fourSettings();
    const double t = share();
    RC_PRE(std::abs(t - 0.5) > 0.01);
    const ParameterValues on = among(four, weightsAt(t, 0)), beside = among(four, weightsAt(t, 1e-9));
    for (std::size_t i = 0; i < on.rows().size(); ++i) {
        const ParameterInfo& row = on.rows()[i];
        if (const auto* three = std::get_if<glm::dvec3>(&on.row(i)))
            RC_ASSERT(glm::distance(*three, std::get<glm::dvec3>(beside.row(i))) < 1e-6);
        else if (row.kind == Kind::real && row.unit == Unit::degree)
            RC_ASSERT(nearlyEqual(row, on.row(i), beside.row(i)) ||
                      std::abs(std::get<double>(on.row(i)) - std::get<double>(beside.row(i))) < 1e-6);
        else if (row.kind == Kind::real)
            RC_ASSERT(std::abs(std::get<double>(on.row(i)) - std::get<double>(beside.row(i))) <
                      1e-6 * (row.range.high - row.range.low));
        else if (row.kind != Kind::count)
            RC_ASSERT(on.row(i) == beside.row(i));
    }
}

}  // namespace
