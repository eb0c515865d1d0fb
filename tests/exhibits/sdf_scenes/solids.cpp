#include "tests/exhibits/sdf_scenes/solids.h"

#include "tests/exhibits/sdf_scenes/support.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace vitrine::test {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec3 at(const double* v, int i)
{
    return {v[i], v[i + 1], v[i + 2]};
}

bool isInBox(const dvec3& p, const dvec3& size)
{
    return std::abs(p.x) < size.x / 2 && std::abs(p.y) < size.y / 2 && std::abs(p.z) < size.z / 2;
}

double toSegment(const dvec3& p, const dvec3& a, const dvec3& b)
{
    double low = 0;
    double high = 1;
    for (int i = 0; i < 100; ++i) {  // The distance is convex along the segment.
        const double third = (high - low) / 3;
        if (glm::distance(p, glm::mix(a, b, low + third)) < glm::distance(p, glm::mix(a, b, high - third)))
            high -= third;
        else
            low += third;
    }
    return glm::distance(p, glm::mix(a, b, low));
}

double toTriangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c)
{
    const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const dvec3 foot = p - n * glm::dot(p - a, n);
    const auto area = [&](const dvec3& x, const dvec3& y, const dvec3& z) {
        return glm::dot(glm::cross(y - x, z - x), n);
    };
    if (area(a, b, foot) >= 0 && area(b, c, foot) >= 0 && area(c, a, foot) >= 0) return glm::distance(p, foot);
    return std::min({toSegment(p, a, b), toSegment(p, b, c), toSegment(p, c, a)});
}

/// Returns the distance from the axis through a and b, and the position along it from 0 at a to 1 at b.
dvec2 besideAxis(const dvec3& p, const dvec3& a, const dvec3& b)
{
    const dvec3 ab = b - a;
    const double along = glm::dot(p - a, ab) / glm::dot(ab, ab);
    return {glm::length(p - a - ab * along), along};
}

/// Returns whether a point is in one of the balls whose centers and radii are interpolated between both ends.
bool isInHull(const dvec3& p, const dvec3& a, const dvec3& b, double ra, double rb)
{
    double low = 0;
    double high = 1;
    const auto depth = [&](double t) { return ra + (rb - ra) * t - glm::distance(p, glm::mix(a, b, t)); };
    for (int i = 0; i < 100; ++i) {  // Concave along the segment.
        const double third = (high - low) / 3;
        (depth(low + third) > depth(high - third) ? high : low) =
            depth(low + third) > depth(high - third) ? high - third : low + third;
    }
    return depth(low) > 0;
}

using Make = std::function<Inside(const double* v)>;

bool isInCone(double beside, double along, double ra, double rb)
{
    return along > 0 && along < 1 && beside < ra + (rb - ra) * along;
}

void addRound(std::map<std::string_view, Make>& all)
{
    all["sphere"] = [](const double* v) { return [r = v[0]](const dvec3& p) { return glm::length(p) < r; }; };
    all["plane"] = [](const double* v) {
        return [n = glm::normalize(at(v, 0)), h = v[3]](const dvec3& p) { return glm::dot(p, n) < h; };
    };
    all["torus"] = [](const double* v) {
        return [R = v[0], r = v[1]](const dvec3& p) { return std::hypot(std::hypot(p.x, p.z) - R, p.y) < r; };
    };
    all["cappedTorus"] = [](const double* v) {
        return [end = v[0], R = v[1], r = v[2]](const dvec3& p) {
            const double angle = std::clamp(std::atan2(p.x, p.y), -end, end);
            return glm::distance(p, dvec3(R * std::sin(angle), R * std::cos(angle), 0)) < r;
        };
    };
    all["link"] = [](const double* v) {
        return [half = v[0] / 2, R = v[1], r = v[2]](const dvec3& p) {
            const dvec2 q(p.x, p.y - std::clamp(p.y, -half, half));
            return std::hypot(glm::length(q) - R, p.z) < r;
        };
    };
    all["capsule"] = [](const double* v) {
        return [a = at(v, 0), b = at(v, 3), r = v[6]](const dvec3& p) { return toSegment(p, a, b) < r; };
    };
    all["roundCone"] = [](const double* v) {
        return [a = v[0], b = v[1], h = v[2]](const dvec3& p) { return isInHull(p, dvec3(0), {0, h, 0}, a, b); };
    };
    all["roundConeBetween"] = [](const double* v) {
        return [a = at(v, 0), b = at(v, 3), ra = v[6], rb = v[7]](const dvec3& p) { return isInHull(p, a, b, ra, rb); };
    };
    all["ellipsoid"] = [](const double* v) {
        return [r = at(v, 0)](const dvec3& p) { return glm::length(p / r) < 1; };
    };
    all["solidAngle"] = [](const double* v) {
        return [r = v[0], half = v[1]](const dvec3& p) {
            return glm::length(p) < r && std::atan2(std::hypot(p.x, p.z), p.y) < half;
        };
    };
    all["cutSphere"] = [](const double* v) {
        return [r = v[0], cut = v[1]](const dvec3& p) { return glm::length(p) < r && p.y < cut; };
    };
    all["cutHollowSphere"] = [](const double* v) {
        return [r = v[0], rim = std::acos(std::clamp(v[1] / v[0], -1.0, 1.0)), wall = v[2]](const dvec3& p) {
            const double angle = std::max(std::atan2(std::hypot(p.x, p.z), p.y), rim);  // Measured from +y downward.
            return std::hypot(std::hypot(p.x, p.z) - r * std::sin(angle), p.y - r * std::cos(angle)) < wall / 2;
        };
    };
    all["deathStar"] = [](const double* v) {
        return [r = v[0], hole = v[1], up = v[2]](const dvec3& p) {
            return glm::length(p) < r && glm::distance(p, dvec3(0, up, 0)) > hole;
        };
    };
    all["vesica"] = [](const double* v) {
        return [a = at(v, 0), b = at(v, 3), radius = v[6]](const dvec3& p) {
            const double half = glm::distance(a, b) / 2;
            const double w = std::min(radius, half);
            const double arc = (half * half + w * w) / (2 * w);
            const dvec2 q = besideAxis(p, a, b);
            return std::hypot(q.x + arc - w, (q.y - 0.5) * 2 * half) < arc;
        };
    };
}

void addFlat(std::map<std::string_view, Make>& all)
{
    const double root3 = std::sqrt(3.0);
    all["box"] = [](const double* v) { return [s = at(v, 0)](const dvec3& p) { return isInBox(p, s); }; };
    all["roundBox"] = [](const double* v) {
        const double r = std::min({v[3], v[0] / 2, v[1] / 2, v[2] / 2});
        return [r, inner = at(v, 0) / 2.0 - r](const dvec3& p) {
            return glm::distance(p, glm::clamp(p, -inner, inner)) < r;
        };
    };
    all["boxFrame"] = [](const double* v) {
        return [s = at(v, 0), t = v[3]](const dvec3& p) {
            int edges = 0;
            for (int i = 0; i < 3; ++i) edges += std::abs(p[i]) > s[i] / 2 - t ? 1 : 0;
            return isInBox(p, s) && edges >= 2;
        };
    };
    all["infiniteCylinder"] = [](const double* v) {
        return [r = v[0]](const dvec3& p) { return std::hypot(p.x, p.z) < r; };
    };
    all["cylinder"] = [](const double* v) {
        return [r = v[0], h = v[1]](const dvec3& p) { return std::hypot(p.x, p.z) < r && std::abs(p.y) < h / 2; };
    };
    all["roundCylinder"] = [](const double* v) {
        return [r = v[0], h = v[1], c = std::min({v[2], v[0], v[1] / 2})](const dvec3& p) {
            const dvec2 q(std::hypot(p.x, p.z), std::abs(p.y));
            return glm::distance(q, glm::min(q, dvec2(r - c, h / 2 - c))) < c;
        };
    };
    all["cone"] = [](const double* v) {
        return [r = v[0], h = v[1]](const dvec3& p) { return isInCone(std::hypot(p.x, p.z), p.y / h, r, 0); };
    };
    all["infiniteCone"] = [](const double* v) {
        return [half = v[0]](const dvec3& p) { return std::atan2(std::hypot(p.x, p.z), -p.y) < half; };
    };
    all["cappedCone"] = [](const double* v) {
        return [h = v[0], a = v[1], b = v[2]](const dvec3& p) {
            return isInCone(std::hypot(p.x, p.z), p.y / h + 0.5, a, b);
        };
    };
    all["cappedConeBetween"] = [](const double* v) {
        return [a = at(v, 0), b = at(v, 3), ra = v[6], rb = v[7]](const dvec3& p) {
            const dvec2 q = besideAxis(p, a, b);
            return isInCone(q.x, q.y, ra, rb);
        };
    };
    all["hexagonalPrism"] = [root3](const double* v) {
        return [root3, r = v[0], h = v[1]](const dvec3& p) {
            const bool flat = std::abs(p.y) < r && (root3 * std::abs(p.x) + std::abs(p.y)) / 2 < r;
            return flat && std::abs(p.z) < h / 2;
        };
    };
    all["triangularPrism"] = [root3](const double* v) {
        return [root3, r = v[0], h = v[1]](const dvec3& p) {
            return p.y > -r && (root3 * std::abs(p.x) + p.y) / 2 < r && std::abs(p.z) < h / 2;
        };
    };
    all["rhombus"] = [](const double* v) {
        return [x = v[0] / 2, z = v[1] / 2, h = v[2]](const dvec3& p) {
            return std::abs(p.x) / x + std::abs(p.z) / z < 1 && std::abs(p.y) < h / 2;
        };
    };
    all["octahedron"] = [](const double* v) {
        return [r = v[0]](const dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < r; };
    };
    all["pyramid"] = [](const double* v) {
        return [r = v[0] / 2, h = v[1]](const dvec3& p) {
            return p.y > 0 && p.y < h && std::max(std::abs(p.x), std::abs(p.z)) < r * (1 - p.y / h);
        };
    };
    all["triangle"] = [](const double* v) {
        return [a = at(v, 0), b = at(v, 3), c = at(v, 6), t = v[9]](const dvec3& p) {
            return toTriangle(p, a, b, c) < t / 2;
        };
    };
    all["quad"] = [](const double* v) {
        return [a = at(v, 0), b = at(v, 3), c = at(v, 6), d = at(v, 9), t = v[12]](const dvec3& p) {
            return std::min(toTriangle(p, a, b, c), toTriangle(p, a, c, d)) < t / 2;
        };
    };
    all["circle"] = [](const double* v) { return [r = v[0]](const dvec3& p) { return std::hypot(p.x, p.y) < r; }; };
    all["rectangle"] = [](const double* v) {
        return [w = v[0], h = v[1]](const dvec3& p) { return std::abs(p.x) < w / 2 && std::abs(p.y) < h / 2; };
    };
    all["equilateralTriangle"] = [root3](const double* v) {
        return [root3, r = v[0]](const dvec3& p) { return p.y > -r && (root3 * std::abs(p.x) + p.y) / 2 < r; };
    };
    all["hexagon"] = [root3](const double* v) {
        return [root3, r = v[0]](const dvec3& p) {
            return std::abs(p.y) < r && (root3 * std::abs(p.x) + std::abs(p.y)) / 2 < r;
        };
    };
}

}  // namespace

Inside insideOf(std::string_view kind, const double* v)
{
    static const std::map<std::string_view, Make> all = [] {
        std::map<std::string_view, Make> kinds;
        addRound(kinds);
        addFlat(kinds);
        return kinds;
    }();
    const auto found = all.find(kind);
    return found == all.end() ? Inside() : found->second(v);
}

bool isBound(const Inside& inside, const dvec3& p, double d, Random& random)
{
    for (int i = 0; i < 100; ++i) {
        const double within = (std::abs(d) - 1e-9) * std::cbrt(random.number(0.5, 1));
        if (within > 0 && inside(p + within * random.direction()) != inside(p)) return false;
    }
    return true;
}

bool isOnSurface(const Inside& inside, const dvec3& p, double near, Random& random)
{
    const bool side = inside(p + near * random.direction());
    for (int i = 0; i < 3000; ++i)
        if (inside(p + near * random.direction() * std::cbrt(random.number(0, 1))) != side) return true;
    return false;
}

}  // namespace vitrine::test
