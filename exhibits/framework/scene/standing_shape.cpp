#include "exhibits/framework/scene/standing_shape.h"

#include <algorithm>

namespace vitrine {

double contactReach(const StandingShape& shape)
{
    return std::clamp(6.0 * static_cast<double>(shape.halfHeight), 0.15, 1.5);
}

StandingShape standingBox(const render::Box& box, const glm::dvec3& color)
{
    StandingShape shape;
    shape.kind = STANDING_BOX;
    shape.center = glm::vec3(box.center());
    shape.axis = {1, 0};
    const glm::dvec3 half = box.halfSize();
    shape.halfSize = {half.x, half.z};
    shape.halfHeight = static_cast<float>(half.y);
    shape.color = glm::vec3(color);
    shape.strength = 1;
    shape.reach = static_cast<float>(contactReach(shape));
    return shape;
}

StandingShape standingCylinder(const render::Box& box, const glm::dvec3& color)
{
    StandingShape shape = standingBox(box, color);
    shape.kind = STANDING_CYLINDER;
    shape.halfSize = glm::vec2(std::min(shape.halfSize.x, shape.halfSize.y));
    return shape;
}

StandingShape moved(const StandingShape& shape, const glm::dmat4& worldFromShape)
{
    StandingShape result = shape;
    result.center = glm::vec3(worldFromShape * glm::dvec4(shape.center, 1));
    const glm::dvec3 side(worldFromShape * glm::dvec4(shape.axis.x, 0, shape.axis.y, 0));
    const auto scale = static_cast<float>(glm::length(side));
    const glm::dvec2 flat(side.x, side.z);
    if (glm::length(flat) > 0) result.axis = glm::vec2(glm::normalize(flat));
    result.halfSize *= scale;
    result.halfHeight *= scale;
    result.reach *= scale;
    return result;
}

render::Box boundsOf(const StandingShape& shape)
{
    const glm::dvec2 axis = glm::abs(glm::dvec2(shape.axis));
    const glm::dvec2 size(shape.halfSize);
    const glm::dvec2 half = shape.kind == STANDING_BOX
                                ? glm::dvec2(axis.x * size.x + axis.y * size.y, axis.y * size.x + axis.x * size.y)
                                : glm::dvec2(size.x);
    const glm::dvec3 reach(half.x, shape.halfHeight, half.y);
    return {glm::dvec3(shape.center) - reach, glm::dvec3(shape.center) + reach};
}

}  // namespace vitrine
