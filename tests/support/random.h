#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace vitrine::test {

/// Random numbers that are equal on every machine, unlike std distributions, which differ between libraries.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Returns a number in [low, high).
    double number(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    /// Returns a whole number in [0, count).
    int below(int count) { return static_cast<int>(number(0, count)); }
    glm::dvec3 point(double halfSize)
    {
        return {number(-halfSize, halfSize), number(-halfSize, halfSize), number(-halfSize, halfSize)};
    }
    /// Returns a unit vector.
    glm::dvec3 direction()
    {
        for (;;) {
            const glm::dvec3 p = point(1);
            const double squared = glm::dot(p, p);
            if (squared > 1e-4 && squared < 1) return p / std::sqrt(squared);
        }
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace vitrine::test
