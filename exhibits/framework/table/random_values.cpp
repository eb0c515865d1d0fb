#include "exhibits/framework/table/random_values.h"

#include "exhibits/framework/table/morph.h"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

double between(double low, double high, Scale scale, double t)
{
    if (scale == Scale::logarithmic && low > 0) return low * std::pow(high / low, t);
    return low + (high - low) * t;
}

bool costsTime(const ParameterInfo& parameter)
{
    return parameter.kind == Kind::count && parameter.qualityReference.has_value() &&
           *parameter.qualityReference > parameter.range.low;
}

}  // namespace

glm::dvec3 RandomNumbers::point(const glm::dvec3& low, const glm::dvec3& high)
{
    const double x = number(low.x, high.x);
    const double y = number(low.y, high.y);
    return {x, y, number(low.z, high.z)};
}

glm::dvec3 RandomNumbers::direction()
{
    for (;;) {
        const glm::dvec3 p = point(glm::dvec3(-1), glm::dvec3(1));
        const double squared = glm::dot(p, p);
        if (squared > 1e-4 && squared <= 1) return p / std::sqrt(squared);
    }
}

Value randomValue(const ParameterInfo& parameter, RandomNumbers& random, RandomReach reach)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: {
        // Only words for values outside of the range count. If there is none, the parameter keeps its random number.
        const auto beyond = [&](const Word& word) {
            return word.value < parameter.range.low || word.value > parameter.range.high;
        };
        if (std::any_of(parameter.words.begin(), parameter.words.end(), beyond) && random.chance(0.2))
            return parameter.words[static_cast<std::size_t>(random.index(static_cast<int>(parameter.words.size())))]
                .value;
        const bool wild = random.chance(0.5);
        const double low = wild ? parameter.range.low : parameter.range.softLow;
        double high = wild ? parameter.range.high : parameter.range.softHigh;
        if (reach.affordable && costsTime(parameter)) high = std::clamp(std::get<double>(parameter.initial), low, high);
        const double t = random.number(0, 1);
        return between(low, high, parameter.range.scale, random.chance(0.2) ? std::round(t) : t);
    }
    case Kind::toggle: return static_cast<double>(random.index(2));
    case Kind::choice: return static_cast<double>(random.index(static_cast<int>(parameter.choices.size())));
    case Kind::color:
        return random.chance(0.2) ? glm::round(random.point({}, glm::dvec3(1))) : random.point({}, glm::dvec3(1));
    case Kind::direction: return random.direction();
    case Kind::file:
    case Kind::text: break;
    }
    return parameter.initial;
}

ParameterValues randomValues(const Parameters& table, RandomNumbers& random, double share, RandomReach reach)
{
    ParameterValues values(table);
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const bool drawn = random.chance(share);
        const Value value = randomValue(table.rows()[i], random, reach);
        if (drawn) values.setParameter(i, value);
    }
    return values;
}

ParameterValues cheapestValues(const Parameters& table)
{
    ParameterValues values(table);
    for (std::size_t i = 0; i < table.rows().size(); ++i)
        if (costsTime(table.rows()[i])) values.setParameter(i, table.rows()[i].range.low);
    return values;
}

namespace {

/// Returns another value for a parameter; each kind uses one of the given random numbers.
Value anotherValue(const ParameterInfo& parameter, const Value& from, double t, const glm::dvec3& color,
                   const glm::dvec3& direction)
{
    const Range& range = parameter.range;
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: return between(range.softLow, range.softHigh, range.scale, t);
    case Kind::toggle: return t < 0.5 ? 0.0 : 1.0;
    case Kind::choice: return std::min(std::floor(t * static_cast<double>(parameter.choices.size())), range.high);
    case Kind::color: return color;
    case Kind::direction: return direction;
    case Kind::file:
    case Kind::text: break;
    }
    return from;
}

/// Returns whether no intermediate value between `a` and `b` exists.
bool isSwitched(const ParameterInfo& parameter, const Value& a, const Value& b)
{
    if (parameter.kind == Kind::toggle || parameter.kind == Kind::choice) return true;
    const auto isWord = [&parameter](const Value& value) {
        const auto* x = std::get_if<double>(&value);
        return x && parameter.wordFor(*x);
    };
    return isWord(a) || isWord(b);
}

}  // namespace

ParameterValues variation(const ParameterValues& from, std::uint64_t seed,
                          const std::function<bool(std::size_t row)>& locked, double strength)
{
    ParameterValues values = from;
    RandomNumbers random(seed), switches(seed + 0x9e3779b97f4a7c15U);
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& row = values.rows()[i];
        // Numbers are drawn for every parameter, so that a lock changes no other parameter.
        const double t = random.number(0, 1);
        const glm::dvec3 color = random.point(glm::dvec3(0), glm::dvec3(1)), direction = random.direction();
        const bool switched = switches.chance(strength);
        if (row.isWritten() || row.qualityReference || locked(i)) continue;
        const Value other = anotherValue(row, from.row(i), t, color, direction);
        if (isSwitched(row, from.row(i), other))
            values.setParameter(i, switched ? other : from.row(i));
        else
            values.setParameter(i, morphed(row, from.row(i), other, strength));
    }
    return values;
}

}  // namespace vitrine
