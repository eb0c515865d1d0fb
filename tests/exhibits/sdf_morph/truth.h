#pragma once

#include "exhibits/framework/parameters.h"
#include "render/scene/camera.h"

#include <glm/glm.hpp>

namespace vitrine::test {

/// A ray of the world; `direction` may have any length: distances along it are multiples of it.
struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};
};

/// Through the middle of a pixel (from the top left); its direction has length 1 along the view axis, so
/// that distances along it are depths.
[[nodiscard]] Ray pixelRay(const render::View&, int x, int y);

/// What a ray found, at float64 by short unrelaxed steps.
struct Found {
    bool hit = false;
    double distance = 0;   ///< In lengths of the ray's direction.
    glm::dvec3 world{0};   ///< Where.
    glm::dvec3 normal{0};  ///< Of the field there, world space, outward.
    double cosine = 0;     ///< Between normal and the way back.
    /// How near the ray came to the surface, as a share of the tolerance there: 1 and less is a hit by the
    /// rules of the exhibit, even where `hit` is false.
    double closest = 0;
    bool grazed = false;  ///< Came within the tolerance before, and left it again.
};

/// The torus-mug as float64 sees it.
class Solid {
public:
    /// The field of these values (not animated), marched inside their box.
    Solid(const ParameterValues&, const glm::dmat4& worldFromLocal);

    /// `halfPixel`: half a pixel's width at distance 1 of the ray's direction (perspective), meters.
    /// `halfTexel`: half a texel's width everywhere (parallel rays), meters. `tolerance` is the table's.
    [[nodiscard]] Found trace(const Ray&, double nearest, double halfPixel, double halfTexel = 0) const;
    /// The same through the middle of a pixel.
    [[nodiscard]] Found trace(const render::View&, int x, int y) const;
    /// Whether the ray meets the box that the object is marched in, grown by `margin` meters of its own space.
    [[nodiscard]] bool meetsBox(const Ray&, double margin = 0) const;
    [[nodiscard]] double distance(const glm::dvec3& local) const;
    [[nodiscard]] glm::dvec3 toLocal(const glm::dvec3& world) const
    {
        return glm::dvec3(localFromWorld_ * glm::dvec4(world, 1));
    }
    /// Of the field at a point of the world, world space, unit length, outward.
    [[nodiscard]] glm::dvec3 normalAt(const glm::dvec3& world) const;
    [[nodiscard]] const render::Box& box() const { return box_; }

private:
    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& local) const;

    ParameterValues values_;
    render::Box box_;  ///< In its own space.
    glm::dmat4 worldFromLocal_, localFromWorld_;
    double largestScale_ = 1;
    double tolerance_ = 1;
};

}  // namespace vitrine::test
