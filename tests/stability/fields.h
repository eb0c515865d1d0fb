#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace vitrine::test {

/// The same points on every machine: std distributions differ between libraries, this does not.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [low, high).
    double number(double low, double high) { return low + (high - low) * (double(engine_() >> 11) * 0x1p-53); }
    glm::dvec3 point(double halfSize)
    {
        return {number(-halfSize, halfSize), number(-halfSize, halfSize), number(-halfSize, halfSize)};
    }
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

inline bool isFinite(double x)
{
    return std::isfinite(x);
}
inline bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace vitrine::test
