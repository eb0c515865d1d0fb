#include "exhibits/framework/table/morph.h"

#include "render/image/oklab.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;
constexpr int mostSteps = 200;  // Limit of iterations for a mean on a circle or sphere; close values need only a few.

template <typename T> struct Weighted {
    T value;
    double weight;
};
template <typename T> using WeightedParts = std::vector<Weighted<T>>;

template <typename T> WeightedParts<T> partsOf(std::span<const Value> values, std::span<const double> weights)
{
    WeightedParts<T> parts;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (weights[i] > 0) parts.push_back({std::get<T>(values[i]), weights[i]});
    return parts;
}

/// Returns the index of the largest weight; the first one if equal.
std::size_t heaviest(std::span<const double> weights)
{
    return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

template <typename T> T mean(const WeightedParts<T>& parts)
{
    T sum{0};
    for (const auto& [value, weight] : parts) sum += weight * value;
    return sum;
}

bool isTurn(const ParameterInfo& parameter)
{
    return parameter.kind == Kind::real && parameter.unit == Unit::degree &&
           std::abs(parameter.range.high - parameter.range.low - fullTurn) < 1e-9;
}

/// Returns the mean of angles on the circle, in the turn that starts at `low`.
double turned(const WeightedParts<double>& parts, double low)
{
    double angle = parts[0].value;
    if (parts.size() == 2) {
        angle += parts[1].weight * std::remainder(parts[1].value - angle, fullTurn);
    } else {
        glm::dvec2 sum{0};
        for (const auto& [value, weight] : parts) sum += weight * glm::dvec2(std::cos(value), std::sin(value));
        if (glm::length(sum) > 1e-9) angle = std::atan2(sum.y, sum.x);
        double off = 1;
        for (int step = 0; step < mostSteps && std::abs(off) > 1e-14; ++step) {
            off = 0;
            for (const auto& [value, weight] : parts) off += weight * std::remainder(value - angle, fullTurn);
            angle += off;
        }
    }
    return angle - fullTurn * std::floor((angle - low) / fullTurn);
}

bool isWord(const ParameterInfo& parameter, double value)
{
    return parameter.wordFor(value) != nullptr;
}

const Weighted<double>& heaviest(const WeightedParts<double>& parts)
{
    return *std::max_element(parts.begin(), parts.end(),
                             [](const auto& a, const auto& b) { return a.weight < b.weight; });
}

/// Removes values that stand for words and normalizes the other weights to the sum 1. Returns nothing if a word has the
/// largest weight.
WeightedParts<double> withoutWords(const ParameterInfo& parameter, const WeightedParts<double>& parts)
{
    if (isWord(parameter, heaviest(parts).value)) return {};
    WeightedParts<double> rest;
    double whole = 0;
    for (const Weighted<double>& part : parts)
        if (!isWord(parameter, part.value)) {
            rest.push_back(part);
            whole += part.weight;
        }
    for (Weighted<double>& part : rest) part.weight /= whole;
    return rest;
}

double morphedNumber(const ParameterInfo& parameter, WeightedParts<double> parts)
{
    const auto word = [&](const Weighted<double>& part) { return isWord(parameter, part.value); };
    if (std::any_of(parts.begin(), parts.end(), word)) {
        const double most = heaviest(parts).value;
        parts = withoutWords(parameter, parts);
        if (parts.empty()) return most;
    }
    if (parts.size() == 1) return parts[0].value;
    if (isTurn(parameter)) return turned(parts, parameter.range.low);
    const auto [low, high] =
        std::minmax_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    const double lowest = low->value, highest = high->value;
    const bool logarithmic = parameter.range.scale == Scale::logarithmic && lowest > 0;
    if (logarithmic)
        for (Weighted<double>& part : parts) part.value = std::log(part.value);
    const double between = std::clamp(logarithmic ? std::exp(mean(parts)) : mean(parts), lowest, highest);
    return parameter.kind == Kind::count ? std::round(between) : between;
}

/// Returns the tangent at `at` toward `to` along the great circle. Its length is the angle in radians. Both points have
/// unit length.
glm::dvec3 wayTo(const glm::dvec3& at, const glm::dvec3& to)
{
    const double angle = std::atan2(glm::length(glm::cross(at, to)), glm::dot(at, to));
    glm::dvec3 aside = to - glm::dot(at, to) * at;
    if (angle < 1e-9) return aside;
    if (glm::length(aside) < 1e-9) {  // Opposite points: all directions are equally short.
        const glm::dvec3 axis = std::abs(at.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        aside = axis - glm::dot(at, axis) * at;
    }
    return angle * glm::normalize(aside);
}

glm::dvec3 gone(const glm::dvec3& from, const glm::dvec3& way)
{
    const double angle = glm::length(way);
    if (angle < 1e-9) return glm::normalize(from + way);
    return std::cos(angle) * from + std::sin(angle) * (way / angle);
}

glm::dvec3 meanDirection(const WeightedParts<glm::dvec3>& parts)
{
    if (parts.size() == 2) return gone(parts[0].value, parts[1].weight * wayTo(parts[0].value, parts[1].value));
    const glm::dvec3 sum = mean(parts);
    glm::dvec3 at = glm::length(sum) > 1e-9 ? glm::normalize(sum) : parts[0].value;
    for (int step = 0; step < mostSteps; ++step) {
        glm::dvec3 way{0};
        for (const auto& [value, weight] : parts) way += weight * wayTo(at, value);
        at = glm::normalize(gone(at, way));
        if (glm::length(way) < 1e-13) break;
    }
    return at;
}

bool sameButForTheEnds(Motion a, const Motion& b)
{
    a.from = b.from;
    a.to = b.to;
    return a == b;
}

/// Values of a setting that contains the parameter, and the index of the parameter there.
struct AnimatedParameter {
    const ParameterValues* values;
    std::size_t row;
};

/// Returns the interpolated motion of a parameter. `nearest` is the motion with the largest weight; returned unchanged
/// if the motions differ in more than their ends.
Motion morphedMotion(const ParameterInfo& info, const Motion& nearest, const std::vector<AnimatedParameter>& owners,
                     std::span<const double> weights)
{
    std::vector<Value> from, to;
    for (const AnimatedParameter& owner : owners) {
        const Motion* motion = owner.values->motion(owner.row);
        if (!motion || !sameButForTheEnds(*motion, nearest)) return nearest;
        from.push_back(motion->from);
        to.push_back(motion->to);
    }
    Motion result = nearest;
    result.from = morphed(info, from, weights);
    result.to = morphed(info, to, weights);
    return result;
}

}  // namespace

Value morphed(const ParameterInfo& parameter, std::span<const Value> values, std::span<const double> weights)
{
    const Value& nearest = values[heaviest(weights)];
    bool alike = true;
    for (std::size_t i = 0; i < values.size(); ++i) alike = alike && (weights[i] <= 0 || values[i] == nearest);
    if (alike) return nearest;
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: return morphedNumber(parameter, partsOf<double>(values, weights));
    case Kind::color: {
        WeightedParts<glm::dvec3> parts = partsOf<glm::dvec3>(values, weights);
        for (Weighted<glm::dvec3>& part : parts) part.value = render::oklabFromLinear(part.value);
        return glm::clamp(render::linearFromOklab(mean(parts)), 0.0, 1.0);
    }
    case Kind::direction: return meanDirection(partsOf<glm::dvec3>(values, weights));
    case Kind::toggle:
    case Kind::choice:
    case Kind::file:
    case Kind::text: break;
    }
    return nearest;
}

Value morphed(const ParameterInfo& parameter, const Value& a, const Value& b, double t)
{
    if (t <= 0) return a;
    if (t >= 1) return b;
    // If weights are equal, the first one counts: `b` from the middle on.
    const std::array<Value, 2> values{b, a};
    return morphed(parameter, values, std::array{t, 1 - t});
}

ParameterValues morphed(std::span<const WeightedValues> settings)
{
    std::vector<double> weights;
    for (const WeightedValues& each : settings) weights.push_back(each.weight);
    const ParameterValues& nearest = *settings[heaviest(weights)].values;
    ParameterValues result = nearest;
    for (std::size_t i = 0; i < result.rows().size(); ++i) {
        const ParameterInfo& row = result.rows()[i];
        std::vector<AnimatedParameter> owners;
        std::vector<Value> values;
        weights.clear();
        double whole = 0;
        bool missing = false;
        for (const auto& [each, weight] : settings) {
            if (weight <= 0) continue;
            const std::optional<std::size_t> twin = each->table().find(row.name);
            if (!twin || each->rows()[*twin].kind != row.kind) {
                missing = true;
                continue;
            }
            owners.push_back({each, *twin});
            values.push_back(each->row(*twin));
            weights.push_back(weight);
            whole += weight;
        }
        if (missing)
            for (double& weight : weights) weight /= whole;
        if (const Motion* motion = nearest.motion(i)) result.setMotion(i, morphedMotion(row, *motion, owners, weights));
        result.setParameter(i, morphed(row, values, weights));
    }
    return result;
}

ParameterValues morphed(const ParameterValues& a, const ParameterValues& b, double t)
{
    if (t <= 0) return a;
    if (t >= 1) return b;
    return morphed(std::array{WeightedValues{&b, t}, WeightedValues{&a, 1 - t}});
}

}  // namespace vitrine
