#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::render {

/// Cost and error of one setting; both at least 0, less is better.
struct CostAndError {
    double cost = 0;
    double error = 0;
};

/// Returns whether `a` is at least as good as `b` in both and better in one.
[[nodiscard]] bool dominates(const CostAndError& a, const CostAndError& b);

/// Returns the indices of the settings that no other dominates, by growing cost; of equal ones, the first. Settings
/// with values that are not finite are never included.
[[nodiscard]] std::vector<std::size_t> paretoFront(std::span<const CostAndError>);

/// Returns the index in `front` of the knee, beyond which higher cost brings little. It is the point furthest below the
/// chord from the cheapest to the most expensive, in logarithms of cost and error. An error or cost of 0 is replaced by
/// half the smallest positive one of the front. Returns nothing if no point lies below the chord (fewer than three
/// points, or no bend).
[[nodiscard]] std::optional<std::size_t> knee(std::span<const CostAndError>, std::span<const std::size_t> front);

}  // namespace vitrine::render
