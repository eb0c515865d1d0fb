#pragma once

#include "exhibits/framework/parameters.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>

namespace vitrine {

/// The same numbers from a seed on every machine, which the distributions of the standard library do not promise.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

    /// In [low, high).
    double number(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
    }
    /// In [0, count), `count` > 0.
    int index(int count) { return static_cast<int>(number(0, count)); }
    bool chance(double probability) { return number(0, 1) < probability; }
    glm::dvec3 point(const glm::dvec3& low, const glm::dvec3& high);
    /// Unit length, evenly over the sphere.
    glm::dvec3 direction();

private:
    std::mt19937_64 engine_;
};

/// How far random values may go.
struct RandomReach {
    /// Counts that trade accuracy for time go no higher than their initial value: above it they cost minutes and
    /// show nothing new.
    bool affordable = true;
};

/// A legal value for a row: half of the time from its comfortable range, else from all that is legal, and its ends
/// more often than chance would. A file keeps its initial value.
[[nodiscard]] Value randomValue(const ParameterInfo&, RandomNumbers&, RandomReach = {});

/// Random legal values for a share of the rows, 0 to 1; the others initial.
[[nodiscard]] ParameterValues randomValues(const Parameters&, RandomNumbers&, double share = 1, RandomReach = {});

/// All initial, but every count that trades accuracy for time as low as it goes.
[[nodiscard]] ParameterValues cheapestValues(const Parameters&);

/// Other values to explore from: numbers evenly over their comfortable ranges (by factors on a logarithmic scale, whole
/// for counts), colors, directions, toggles and choices over all there are. `strength`, 0 to 1, says how far: the
/// values are led so far towards those (`morphed`), and what has nothing between becomes them with that probability.
/// What shows nothing else stays as in `from`: files, texts, and rows that trade accuracy for time; so does a row that
/// `locked` (by its index) keeps. The same seed gives every other row the same value, whatever is locked.
[[nodiscard]] ParameterValues variation(const ParameterValues& from, std::uint64_t seed,
                                        const std::function<bool(std::size_t row)>& locked, double strength = 1);

}  // namespace vitrine
