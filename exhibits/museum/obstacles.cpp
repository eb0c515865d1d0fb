#include "exhibits/museum/obstacles.h"

#include "exhibits/hall/walk.h"

#include <utility>

namespace vitrine {

Obstacles::Obstacles(std::vector<hall::Collider> colliders)
    : colliders_(std::make_shared<const std::vector<hall::Collider>>(std::move(colliders)))
{
}

std::size_t Obstacles::count() const
{
    return colliders_->size();
}

glm::dvec3 Obstacles::walk(const glm::dvec3& from, const glm::dvec3& to) const
{
    return hall::walkAround(*colliders_, from, to);
}

bool Obstacles::walks(const glm::dvec3& from, const glm::dvec3& to) const
{
    return glm::length(walk(from, to) - to) < 1e-6;
}

bool Obstacles::cameraPasses(const glm::dvec3& from, const glm::dvec3& to) const
{
    return hall::cameraPasses(*colliders_, from, to);
}

}  // namespace vitrine
