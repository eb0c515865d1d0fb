#include "exhibits/framework/morph.h"

#include "render/image/oklab.h"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;

double evenly(double a, double b, double t)
{
    return (1 - t) * a + t * b;
}

bool isTurn(const ParameterInfo& row)
{
    return row.kind == Kind::real && row.unit == Unit::degree &&
           std::abs(row.range.high - row.range.low - fullTurn) < 1e-9;
}

/// The shorter way round, within one turn from `low`.
double turned(double a, double b, double t, double low)
{
    const double angle = a + t * std::remainder(b - a, fullTurn);
    return angle - fullTurn * std::floor((angle - low) / fullTurn);
}

bool isWord(const ParameterInfo& row, double value)
{
    return row.word && row.word->value == value;
}

Value morphedNumber(const ParameterInfo& row, double a, double b, double t)
{
    if (a != b && (isWord(row, a) || isWord(row, b))) return t < 0.5 ? a : b;
    if (isTurn(row)) return turned(a, b, t, row.range.low);
    const bool logarithmic = row.range.scale == Scale::logarithmic && a > 0 && b > 0;
    const double x = logarithmic ? std::exp(evenly(std::log(a), std::log(b), t)) : evenly(a, b, t);
    const double between = std::clamp(x, std::min(a, b), std::max(a, b));
    return row.kind == Kind::count ? std::round(between) : between;
}

glm::dvec3 alongGreatCircle(const glm::dvec3& a, const glm::dvec3& b, double t)
{
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    if (angle < 1e-9) return glm::normalize(glm::mix(a, b, t));
    glm::dvec3 aside = b - glm::dot(a, b) * a;
    if (glm::length(aside) < 1e-9) {  // Opposite: any way is as short.
        const glm::dvec3 axis = std::abs(a.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        aside = axis - glm::dot(a, axis) * a;
    }
    return std::cos(t * angle) * a + std::sin(t * angle) * glm::normalize(aside);
}

}  // namespace

Value morphed(const ParameterInfo& row, const Value& a, const Value& b, double t)
{
    if (t <= 0 || a == b) return a;
    if (t >= 1) return b;
    switch (row.kind) {
    case Kind::real:
    case Kind::count: return morphedNumber(row, std::get<double>(a), std::get<double>(b), t);
    case Kind::color: {
        const glm::dvec3 lab = glm::mix(render::oklabFromLinear(std::get<glm::dvec3>(a)),
                                        render::oklabFromLinear(std::get<glm::dvec3>(b)), t);
        return glm::clamp(render::linearFromOklab(lab), 0.0, 1.0);
    }
    case Kind::direction: return alongGreatCircle(std::get<glm::dvec3>(a), std::get<glm::dvec3>(b), t);
    case Kind::toggle:
    case Kind::choice:
    case Kind::file:
    case Kind::text: break;
    }
    return t < 0.5 ? a : b;
}

ParameterValues morphed(const ParameterValues& a, const ParameterValues& b, double t)
{
    if (t <= 0) return a;
    if (t >= 1) return b;
    ParameterValues result = t < 0.5 ? a : b;
    for (std::size_t i = 0; i < result.rows().size(); ++i) {
        const ParameterInfo& row = result.rows()[i];
        const std::optional<std::size_t> inA = a.table().find(row.name), inB = b.table().find(row.name);
        if (!inA || !inB || a.rows()[*inA].kind != b.rows()[*inB].kind) continue;
        result.setRow(i, morphed(row, a.row(*inA), b.row(*inB), t));
    }
    return result;
}

}  // namespace vitrine
