#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace vitrine::hall {
struct Collider;
}

namespace vitrine {

/// Colliders that stop visitors and cameras; world space, meters.
class Obstacles {
public:
    explicit Obstacles(std::vector<hall::Collider>);

    /// Returns where a visitor ends up who walks from `from` towards `to` (eye positions), sliding along obstacles.
    [[nodiscard]] glm::dvec3 walk(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Returns whether the visitor reaches `to`, to a thousandth of a millimeter.
    [[nodiscard]] bool walks(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Returns whether a camera can move straight from `from` to `to`. A visitor need not be able to stand there.
    [[nodiscard]] bool cameraPasses(const glm::dvec3& from, const glm::dvec3& to) const;

    [[nodiscard]] std::size_t count() const;

private:
    std::shared_ptr<const std::vector<hall::Collider>> colliders_;
};

}  // namespace vitrine
