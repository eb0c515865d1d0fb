#pragma once

#include "exhibits/ice_cream/ice_cream_shape.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace vitrine::test {

/// Reference evaluation of the ice cream: all solids at every point, at float64, with formulas of its own.
/// shaders/ice_cream/solids.glsl, which skips solids, is compared with it.
class EverySolid {
public:
    struct Sprinkle {
        glm::dvec3 start, finish;
    };

    explicit EverySolid(const ice_cream::IceCreamShape& shape, std::vector<Sprinkle> sprinkles = {})
        : s_(shape), sprinkles_(std::move(sprinkles))
    {
    }

    /// Returns the number of solids in one evaluation.
    [[nodiscard]] int solids() const
    {
        int count = 0;
        for (const int part : {PART_FOOT, PART_COLLAR, PART_BOWL, PART_PLINTH}) count += has(part);
        if (has(PART_RINGS)) count += s_.rings;
        if (has(PART_BARS)) count += s_.bars;
        for (int i = 0; i < CREAM_LAYERS; ++i)
            if (has(PART_CREAM + i)) count += s_.layers[static_cast<std::size_t>(i)].lobes;
        for (int i = 0; i < CANDIES; ++i) count += has(PART_CANDY + i);
        return count + static_cast<int>(has(PART_SPRINKLES) ? sprinkles_.size() : 0);
    }

    [[nodiscard]] double level(const glm::dvec3& p) const
    {
        double d = smooth(wafer(p), cream(p), s_.waferBlend);
        for (int i = 0; i < CANDIES; ++i)
            if (has(PART_CANDY + i)) d = std::min(d, candy(s_.candies[static_cast<std::size_t>(i)], p));
        if (has(PART_SPRINKLES))
            for (const Sprinkle& one : sprinkles_)
                d = std::min(d, capsule(p, one.start, one.finish) - double{s_.sprinkleRadius});
        if (has(PART_PLINTH)) {
            const double r = s_.plinth.z, h = s_.plinth.y;
            const glm::dvec2 q(std::hypot(p.x, p.z) - (s_.plinth.x - r), std::abs(p.y + 0.5 * h) - (0.5 * h - r));
            d = std::min(d, glm::length(glm::max(q, 0.0)) + std::min(std::max(q.x, q.y), 0.0) - r);
        }
        return d;
    }

    [[nodiscard]] double wafer(const glm::dvec3& p) const
    {
        const double r = std::hypot(p.x, p.z);
        double ring = far, bar = far;
        const glm::dvec2 bottom(s_.foot.x, 0), top(s_.foot.y, s_.foot.z);
        for (int i = 1; has(PART_RINGS) && i <= s_.rings; ++i) {
            const glm::dvec2 at = glm::mix(bottom, top, i / (s_.rings + 1.0));
            ring = std::min(ring, glm::distance({r, p.y}, at) - double{s_.ringTube});
        }
        for (int i = 0; has(PART_BARS) && i < s_.bars; ++i) {
            const double a = 2 * std::numbers::pi * i / s_.bars;
            const glm::dvec3 out(std::cos(a), 0, std::sin(a)), up(0, 1, 0);
            bar = std::min(bar, capsule(p, out * bottom.x, out * top.x + up * top.y) - double{s_.barRadius});
        }
        const double foot = has(PART_FOOT) ? frustum({r, p.y}, 0, s_.foot.z, s_.foot.x, s_.foot.y) : far;
        double d = smooth(smooth(ring, bar, s_.reliefBlend), foot, s_.footBlend);
        if (has(PART_COLLAR)) d = std::min(d, frustum({r, p.y}, s_.collar.z, s_.collar.w, s_.collar.x, s_.collar.y));
        if (has(PART_BOWL)) d = std::min(d, bowl({r, p.y}));
        return d;
    }

    [[nodiscard]] double cream(const glm::dvec3& p) const { return smooth(layer(0, p), layer(1, p), s_.layerBlend); }

    /// Returns the distance to the two nearest cones of a layer.
    [[nodiscard]] double layer(int i, const glm::dvec3& p) const
    {
        if (!has(PART_CREAM + i)) return far;
        const ice_cream::CreamLayer& layer = s_.layers[static_cast<std::size_t>(i)];
        std::vector<double> cones;
        for (int k = 0; k < layer.lobes; ++k) cones.push_back(lobe(layer, p, k));
        cones.push_back(far);
        std::partial_sort(cones.begin(), cones.begin() + 2, cones.end());
        return smooth(cones[0], cones[1], layer.blend);
    }

    /// Returns the distance to one cone of a layer, with space rotated and twisted like in the reference.
    [[nodiscard]] static double lobe(const ice_cream::CreamLayer& layer, const glm::dvec3& p, int k)
    {
        const double a = double{layer.twist} * p.y + 2 * std::numbers::pi * k / layer.lobes;
        const glm::dvec3 q(std::cos(a) * p.x + std::sin(a) * p.z, p.y, std::cos(a) * p.z - std::sin(a) * p.x);
        const glm::dvec3 v = q - glm::dvec3(layer.foot);
        const double along = glm::dot(v, glm::dvec3(layer.axis));
        const double away = glm::length(v - glm::dvec3(layer.axis) * along);
        return frustum({away, along}, 0, 2.0 * layer.halfHeight, layer.radius, 0) - double{layer.corner};
    }

    /// Returns the distance to a frustum from the edges of its profile and the signs of its half-planes.
    [[nodiscard]] static double frustum(const glm::dvec2& q, double low, double high, double bottom, double top)
    {
        const glm::dvec2 a(bottom, low), b(top, high);
        const double side = segment(q, a, b);
        const double cap = std::min(segment(q, {0, low}, a), segment(q, {0, high}, b));
        const double over = (q.x - a.x) * (b.y - a.y) - (q.y - a.y) * (b.x - a.x);
        const bool inside = q.y > low && q.y < high && over < 0;
        return inside ? -std::min(side, cap) : std::min(side, cap);
    }

    /// Returns the distance to the bowl: the nearest of its two disks and the ball between them.
    [[nodiscard]] double bowl(const glm::dvec2& p) const
    {
        // Differences of two floats would be rounded to floats.
        const double radius = s_.bowl.x, middle = s_.bowl.y;
        const double low = s_.bowl.z - middle, high = s_.bowl.w - middle;
        const glm::dvec2 q(p.x, p.y - middle);
        const auto edge = [&](double y) { return glm::dvec2(std::sqrt(std::max(radius * radius - y * y, 0.0)), y); };
        double d = std::min(segment(q, {0, low}, edge(low)), segment(q, {0, high}, edge(high)));
        const glm::dvec2 onBall = glm::length(q) > 0 ? q * (radius / glm::length(q)) : glm::dvec2(radius, 0);
        if (onBall.y >= low && onBall.y <= high) d = std::min(d, glm::distance(q, onBall));
        return glm::length(q) < radius && q.y > low && q.y < high ? -d : d;
    }

    [[nodiscard]] bool has(int part) const { return (s_.parts >> part & 1) != 0; }

private:
    static constexpr double far = 1e9;

    static double smooth(double a, double b, double k)
    {
        if (k < 1e-12) return std::min(a, b);
        const double h = std::max(k - std::abs(a - b), 0.0) / k;
        return std::min(a, b) - h * h * k / 4;
    }
    static double segment(const glm::dvec2& q, const glm::dvec2& a, const glm::dvec2& b)
    {
        const glm::dvec2 ab = b - a;
        const double squared = glm::dot(ab, ab);
        const double t = squared > 0 ? std::clamp(glm::dot(q - a, ab) / squared, 0.0, 1.0) : 0;
        return glm::distance(q, a + ab * t);
    }
    static double capsule(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
    {
        const glm::dvec3 ab = b - a;
        return glm::distance(p, a + ab * std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0));
    }
    static double candy(const ice_cream::Candy& c, const glm::dvec3& p)
    {
        const glm::dvec3 x(c.axisX), y(c.axisY), v = p - glm::dvec3(c.center), half(c.halfSize);
        const double corner = std::min({double{c.corner}, half.x, half.y, half.z});
        const glm::dvec3 q =
            glm::abs(glm::dvec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, glm::cross(x, y)))) - half + corner;
        return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0) - corner;
    }

    ice_cream::IceCreamShape s_;
    std::vector<Sprinkle> sprinkles_;
};

}  // namespace vitrine::test
