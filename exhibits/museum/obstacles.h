#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace vitrine {

struct Collider;

/// What stops visitors and cameras in the world, meters.
class Obstacles {
public:
    explicit Obstacles(std::vector<Collider>);

    /// Where a visitor who wants to go from `from` to `to` (eye positions) ends up: he slides along what stops him.
    [[nodiscard]] glm::dvec3 walk(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Whether he gets to `to`, to a thousandth of a millimeter.
    [[nodiscard]] bool walks(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Whether a camera gets straight from `from` to `to`: it need not be where a visitor can stand.
    [[nodiscard]] bool cameraPasses(const glm::dvec3& from, const glm::dvec3& to) const;

    [[nodiscard]] std::size_t count() const;

private:
    std::shared_ptr<const std::vector<Collider>> colliders_;
};

}  // namespace vitrine
