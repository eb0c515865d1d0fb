#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::render {

/// What one setting costs and how wrong it is; both at least 0, less is better.
struct CostAndError {
    double cost = 0;
    double error = 0;
};

/// Whether `a` is at least as good as `b` in both and better in one.
[[nodiscard]] bool dominates(const CostAndError& a, const CostAndError& b);

/// The settings that no other dominates, by growing cost; of equal ones, the first. What is not finite is never
/// on the front.
[[nodiscard]] std::vector<std::size_t> paretoFront(std::span<const CostAndError>);

/// The place in `front` where paying more stops being worth it: furthest below the chord from the cheapest to the
/// dearest, in logarithms of cost and error. An error or cost of 0 stands for half the smallest positive one of the
/// front. Nothing where no point of the front lies below the chord (under three, or no bend).
[[nodiscard]] std::optional<std::size_t> knee(std::span<const CostAndError>, std::span<const std::size_t> front);

}  // namespace vitrine::render
