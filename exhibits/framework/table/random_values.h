#pragma once

#include "exhibits/framework/table/parameters.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>

namespace vitrine {

/// Random numbers that are the same for a seed on every machine; the distributions of the standard library are not.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

    /// Returns a number in [low, high).
    double number(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
    }
    /// Returns an index in [0, count); requires `count` > 0.
    int index(int count) { return static_cast<int>(number(0, count)); }
    bool chance(double probability) { return number(0, 1) < probability; }
    glm::dvec3 point(const glm::dvec3& low, const glm::dvec3& high);
    /// Returns a unit vector, uniformly distributed over the sphere.
    glm::dvec3 direction();

private:
    std::mt19937_64 engine_;
};

/// Limits of random values.
struct RandomReach {
    /// True: counts that trade speed for accuracy stay at or below their initial value. Higher counts cost minutes and
    /// show nothing new.
    bool affordable = true;
};

/// Returns a legal random value: in half of the cases from the comfortable range, otherwise from all legal values. The
/// ends of the range are more frequent than in a uniform distribution. In one of five cases it is the word for a number
/// outside of the range, if there is one. A file keeps its initial value.
[[nodiscard]] Value randomValue(const ParameterInfo&, RandomNumbers&, RandomReach = {});

/// Returns random legal values for a share of the parameters (0 to 1); the others keep their initial value.
[[nodiscard]] ParameterValues randomValues(const Parameters&, RandomNumbers&, double share = 1, RandomReach = {});

/// Returns the initial values, with every count that trades speed for accuracy at its minimum.
[[nodiscard]] ParameterValues cheapestValues(const Parameters&);

/// Returns random values for exploration. Numbers are uniform over their comfortable ranges (logarithmic if the scale
/// is, integers for counts). Colors, directions, toggles and choices are uniform over all values. `strength` (0 to 1)
/// interpolates from `from` to these values (`morphed`). Parameters without intermediate values switch with the
/// probability `strength`. Unchanged are files, texts, parameters that trade speed for accuracy, and parameters for
/// which `locked(index)` is true. With the same seed, the other parameters get the same values, whatever is locked.
[[nodiscard]] ParameterValues variation(const ParameterValues& from, std::uint64_t seed,
                                        const std::function<bool(std::size_t row)>& locked, double strength = 1);

}  // namespace vitrine
