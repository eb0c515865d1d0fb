#include "exhibits/fur/coat.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::fur {
namespace {

/// Returns the thickness of a body around its spine, meters.
double bodyRadius(int body)
{
    return body == furBall ? ballRadius : body == furRoll ? rollRadius : ringTube;
}

glm::vec4 vec4Of(const glm::dquat& q)
{
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

}  // namespace

double colliderRadius(const FurTable& table, const ParameterValues& values, int body, double skinScale)
{
    return bodyRadius(body) * skinScale +
           (1 - values[table.flattening]) * values[table.coats[static_cast<std::size_t>(body)].length];
}

double shellsAtDistance(int wanted, double length, double distance, double pixelAngle)
{
    const double pixels = length / std::max(distance * pixelAngle, 1e-9);
    return std::clamp(pixels / 4.5, std::min<double>(wanted, 5), static_cast<double>(wanted));
}

double Coats::radius(int index) const
{
    return index == furRing && modelRadius > 0 ? modelRadius : bodyRadius(index);
}

glm::dvec3 Coats::spinePoint(int index, const glm::dvec3& p) const
{
    const FurState& state = states[static_cast<std::size_t>(index)];
    if (index == furBall || (index == furRing && modelRadius > 0)) return state.position;
    const glm::dvec3 local = glm::conjugate(state.rotation) * (p - state.position);
    if (index == furRoll)
        return state.position + state.rotation * glm::dvec3(std::clamp(local.x, -rollHalfLength, rollHalfLength), 0, 0);
    glm::dvec3 flat(local.x, 0, local.z);
    const double length = glm::length(flat);
    flat = length > 1e-9 ? flat * (ringRadius / length) : glm::dvec3(ringRadius, 0, 0);
    return state.position + state.rotation * flat;
}

glm::dmat4 Coats::worldFromBody(int index) const
{
    const FurState& state = states[static_cast<std::size_t>(index)];
    return worldFromPit * glm::translate(glm::dmat4(1), state.position) * glm::mat4_cast(state.rotation);
}

render::Box Coats::space(int index, const render::Box& skin) const
{
    // Strands keep their length within 1 %. A millimeter is added as a margin.
    const double reach = 1.02 * values[table.coats[static_cast<std::size_t>(index)].length] + 1e-3;
    const double skinScale = states[static_cast<std::size_t>(index)].skinScale;
    return {skin.low * skinScale - reach, skin.high * skinScale + reach};
}

render::Box Coats::bounds(int index, const render::Box& skin) const
{
    return space(index, skin).transformed(worldFromBody(index));
}

FurBody Coats::body(int index) const
{
    const auto which = static_cast<std::size_t>(index);
    const FurState& state = states[which];
    const CoatParameters rows = table.coats[static_cast<std::size_t>(index)];
    const double length = values[rows.length];
    const glm::dquat bodyFromPit = glm::conjugate(state.rotation);
    FurBody body;
    body.worldFromBody = glm::mat4(worldFromBody(index));
    body.bodyFromWorld = glm::mat4(glm::inverse(worldFromBody(index)));
    body.tipOffset = glm::vec3(bodyFromPit * state.tipOffset);
    body.skinScale = static_cast<float>(state.skinScale);
    body.tipRotation = vec4Of(bodyFromPit * state.tipRotation * state.rotation);
    body.wind = glm::vec3(bodyFromPit * (values[table.windDirection].value * values[table.wind]));
    body.gustPhase = static_cast<float>(std::fmod(0.35 * time, 1.0) * 2 * std::numbers::pi);

    body.strandLength = static_cast<float>(length);
    body.cellSize = static_cast<float>(1 / std::sqrt(std::sqrt(3.0) * values[rows.density]));
    body.strandRadius = static_cast<float>(0.5 * values[rows.thickness]);
    body.leastLength = static_cast<float>(values[rows.uniformity]);
    body.rootColor = glm::vec3(values[rows.root].value);
    body.tipColor = glm::vec3(values[rows.tip].value);
    body.markColor = glm::vec3(values[rows.markColor].value);
    body.markSize = static_cast<float>(values[rows.markSize]);
    body.marking = static_cast<int>(FurMarking(values[rows.marking]));
    body.number = index + 1;
    body.shellCount = static_cast<float>(length > 0 ? values[table.shellCount] : 1);
    body.samplesBetween = values[table.silhouette] == FurSilhouette::march ? values[table.samplesBetween] : 1;
    body.innerFirst = values[table.drawOrder] == FurOrder::innerFirst;
    body.seed = (seed + 131U * static_cast<unsigned>(index)) % 65536U;
    body.halfLength = static_cast<float>(index == furRoll ? rollHalfLength : 0);
    body.ringRadius = static_cast<float>(index == furRing && !(modelRadius > 0) ? ringRadius : 0);
    body.radius = static_cast<float>(radius(index));

    for (const FreeSide& side : freeSides(index)) {
        if (body.planeCount == FUR_PLANES) break;
        body.planes[static_cast<std::size_t>(body.planeCount++)] =
            glm::vec4(glm::vec3(bodyFromPit * side.normal),
                      static_cast<float>(side.distance - glm::dot(side.normal, state.position)));
    }
    return body;
}

std::vector<Coats::FreeSide> Coats::freeSides(int index) const
{
    const FurState& state = states[static_cast<std::size_t>(index)];
    const double length = values[table.coats[static_cast<std::size_t>(index)].length];
    std::vector<FreeSide> sides{{{0, 1, 0}, 0}};
    const double out = std::hypot(state.position.x, state.position.z);
    // Outside the pit, its wall presses nothing, and the ground is as high as the rim.
    if (out > pitRadius)
        sides.push_back({{0, 1, 0}, pitRim});
    else if (out > 0.3 && state.position.y < pitRim + 0.3)
        sides.push_back({-glm::dvec3(state.position.x, 0, state.position.z) / out, -pitRadius});
    for (int other = 0; other < furBodyCount; ++other) {
        if (other == index) continue;
        // The plane is in the middle of the gap between the nearest points of the two spines, which are found by
        // alternating projection.
        const FurState& theirs = states[static_cast<std::size_t>(other)];
        glm::dvec3 mine = state.position;
        glm::dvec3 its = theirs.position;
        for (int round = 0; round < 4; ++round) {
            its = spinePoint(other, mine);
            mine = spinePoint(index, its);
        }
        const double apart = glm::length(mine - its);
        const double myRadius = radius(index) * state.skinScale;
        const double itsRadius = radius(other) * theirs.skinScale;
        const double room = apart - myRadius - itsRadius;
        if (apart < 1e-6 || room > length + values[table.coats[static_cast<std::size_t>(other)].length]) continue;
        const glm::dvec3 normal = (mine - its) / apart;
        sides.push_back({normal, glm::dot(normal, its) + itsRadius + 0.5 * room});
    }
    return sides;
}

}  // namespace vitrine::fur
