#include "exhibits/hall/walk.h"

#include <algorithm>
#include <cmath>

namespace vitrine::hall {
namespace {

constexpr double visitorHeight = 1.8;
constexpr double longestStep = 0.1;
constexpr double longestWalk = 100;  ///< Longer walks end after this distance; the building is smaller.

/// Pushes a point out of a box, by the shortest way in the horizontal plane.
glm::dvec2 pushedOutOfBox(glm::dvec2 p, glm::dvec2 halfSize, double reach)
{
    const glm::dvec2 nearest = glm::clamp(p, -halfSize, halfSize);
    const glm::dvec2 away = p - nearest;
    const double distance = glm::length(away);
    if (distance >= reach) return p;
    if (distance > 1e-9) return nearest + away * (reach / distance);
    const glm::dvec2 toSide = halfSize + reach - glm::abs(p);
    if (toSide.x < toSide.y)
        p.x = std::copysign(halfSize.x + reach, p.x);
    else
        p.y = std::copysign(halfSize.y + reach, p.y);
    return p;
}

glm::dvec2 pushedOutOfDisk(glm::dvec2 p, double radius, double reach)
{
    const double distance = glm::length(p);
    const double least = radius + reach;
    if (distance >= least) return p;
    return distance > 1e-9 ? p * (least / distance) : glm::dvec2(least, 0);
}

/// Moves `eye` of a body that fills `reach` around it out of one obstacle. Colliders are upright, so only the
/// horizontal plane matters.
glm::dvec3 pushedOut(const Collider& collider, const glm::dvec3& eye, double reach = visitorRadius)
{
    const glm::dvec3 feet(eye.x, eye.y - 1.65, eye.z);
    glm::dvec3 local = glm::dvec3(collider.localFromWorld * glm::dvec4(feet, 1));
    const double bottom = -collider.halfSize.y;
    const double top = collider.halfSize.y;
    // An obstacle completely above the head or below the feet (a step up to 5 cm) does not block.
    if (local.y + visitorHeight < bottom || local.y + 0.05 > top) return eye;
    const glm::dvec2 flat(local.x, local.z);
    const glm::dvec2 out = collider.cylinder
                               ? pushedOutOfDisk(flat, collider.halfSize.x, reach)
                               : pushedOutOfBox(flat, glm::dvec2(collider.halfSize.x, collider.halfSize.z), reach);
    if (out == flat) return eye;
    const glm::dvec3 moved = glm::dvec3(glm::inverse(collider.localFromWorld) * glm::dvec4(out.x, local.y, out.y, 1));
    return {moved.x, eye.y, moved.z};
}

}  // namespace

glm::dvec3 walkAround(const std::vector<Collider>& colliders, const glm::dvec3& from, const glm::dvec3& to)
{
    glm::dvec3 whole = to - from;
    if (!std::isfinite(whole.x) || !std::isfinite(whole.y) || !std::isfinite(whole.z)) return from;
    const double length = std::hypot(whole.x, whole.z);
    if (length > longestWalk) whole *= longestWalk / length;
    const int steps = std::max(static_cast<int>(std::ceil(std::min(length, longestWalk) / longestStep)), 1);
    glm::dvec3 eye = from;
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 before = eye;
        eye += whole / static_cast<double>(steps);
        eye.y = to.y;
        // Two obstacles can push against each other in a corner. If the position does not settle, the walk ends here.
        bool settled = false;
        for (int round = 0; round < 4 && !settled; ++round) {
            const glm::dvec3 last = eye;
            for (const Collider& collider : colliders) eye = pushedOut(collider, eye);
            settled = glm::length(eye - last) < 1e-6;
        }
        if (!settled) return before;
    }
    return eye;
}

glm::dvec2 standingPlace(const std::vector<Collider>& colliders, const glm::dvec2& at, double radius)
{
    glm::dvec3 eye(at.x, 1.65, at.y);
    for (int round = 0; round < 16; ++round) {
        const glm::dvec3 last = eye;
        for (const Collider& collider : colliders) eye = pushedOut(collider, eye, radius);
        if (glm::length(eye - last) < 1e-6) return {eye.x, eye.z};
    }
    return at;
}

bool cameraPasses(const std::vector<Collider>& colliders, const glm::dvec3& from, const glm::dvec3& to)
{
    const double length = glm::length(to - from);
    if (!std::isfinite(length)) return false;
    const int steps = std::max(static_cast<int>(std::ceil(length / (cameraRadius / 2))), 1);
    for (const Collider& collider : colliders) {
        const glm::dvec3 first(collider.localFromWorld * glm::dvec4(from, 1));
        const glm::dvec3 last(collider.localFromWorld * glm::dvec4(to, 1));
        const glm::dvec3 half(collider.halfSize.x, collider.halfSize.y,
                              collider.cylinder ? collider.halfSize.x : collider.halfSize.z);
        const glm::dvec3 reach = half + cameraRadius;
        if (glm::any(glm::greaterThan(glm::min(first, last), reach)) ||
            glm::any(glm::lessThan(glm::max(first, last), -reach)))
            continue;
        for (int i = 0; i <= steps; ++i) {
            const glm::dvec3 p = glm::abs(glm::mix(first, last, static_cast<double>(i) / steps));
            const glm::dvec2 out = collider.cylinder ? glm::dvec2(std::hypot(p.x, p.z) - collider.halfSize.x, 0)
                                                     : glm::dvec2(p.x - collider.halfSize.x, p.z - collider.halfSize.z);
            const glm::dvec3 beyond = glm::max(glm::dvec3(out.x, p.y - collider.halfSize.y, out.y), 0.0);
            if (glm::length(beyond) < cameraRadius) return false;
        }
    }
    return true;
}

bool isBehind(const Occluder& occluder, const render::Box& box, const glm::dvec3& eye)
{
    const glm::dvec3 normal = glm::cross(occluder.halfU, occluder.halfV);
    const double eyeSide = glm::dot(normal, eye - occluder.center);
    if (box.empty() || std::abs(eyeSide) < 1e-9) return false;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                           (corner & 4) != 0 ? box.high.z : box.low.z);
        const double side = glm::dot(normal, p - occluder.center);
        if (side * eyeSide >= 0) return false;
        const glm::dvec3 hit = eye + (p - eye) * (eyeSide / (eyeSide - side)) - occluder.center;
        const double u = glm::dot(hit, occluder.halfU) / glm::dot(occluder.halfU, occluder.halfU);
        const double v = glm::dot(hit, occluder.halfV) / glm::dot(occluder.halfV, occluder.halfV);
        if (std::abs(u) > 1 || std::abs(v) > 1) return false;
    }
    return true;
}

}  // namespace vitrine::hall
