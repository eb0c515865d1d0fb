#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

namespace vitrine::test {

/// Ray in world space. `direction` has any length; distances are multiples of it.
struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};
};

/// Returns the ray through the center of a pixel (from the top left). Its direction has length 1 along the view axis,
/// so that distances are depths.
[[nodiscard]] Ray pixelRay(const render::View&, int x, int y);

/// Result of a ray at float64, with short unrelaxed steps.
struct Found {
    bool hit = false;
    double distance = 0;   ///< Distance in lengths of the ray's direction.
    glm::dvec3 world{0};   ///< Position in world space.
    glm::dvec3 normal{0};  ///< Outward normal of the field in world space.
    double cosine = 0;     ///< Cosine between the normal and the reversed ray.
    /// Closest distance of the ray to the surface, relative to the tolerance there: 1 and less is a hit by the rules of
    /// the exhibit, even if `hit` is false.
    double closest = 0;
    bool grazed = false;  ///< Came within the tolerance and left it again before.
};

/// Torus-mug at float64.
class Solid {
public:
    /// Field of these values (not animated), traced within its bounding box.
    Solid(const ParameterValues&, const glm::dmat4& worldFromLocal);

    /// Traces a ray. `halfPixel`: half a pixel's width in meters at distance 1 of the ray's direction (perspective).
    /// `halfTexel`: half a texel's width in meters at any distance (parallel rays). `tolerance` is that of the table.
    [[nodiscard]] Found trace(const Ray&, double nearest, double halfPixel, double halfTexel = 0) const;
    /// The same for the ray through the center of a pixel.
    [[nodiscard]] Found trace(const render::View&, int x, int y) const;
    /// Returns whether the ray hits the object's bounding box, enlarged by `margin` meters of its own space.
    [[nodiscard]] bool meetsBox(const Ray&, double margin = 0) const;
    [[nodiscard]] double distance(const glm::dvec3& local) const;
    [[nodiscard]] glm::dvec3 toLocal(const glm::dvec3& world) const
    {
        return glm::dvec3(localFromWorld_ * glm::dvec4(world, 1));
    }
    /// Returns the outward unit normal of the field at a point in world space.
    [[nodiscard]] glm::dvec3 normalAt(const glm::dvec3& world) const;
    [[nodiscard]] const render::Box& box() const { return box_; }

private:
    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& local) const;

    ParameterValues values_;
    render::Box box_;  ///< Bounds in its own space.
    glm::dmat4 worldFromLocal_, localFromWorld_;
    double largestScale_ = 1;
    double tolerance_ = 1;
};

}  // namespace vitrine::test
