#pragma once

#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <vector>

namespace vitrine {

#include "shaders/kit/surface_object_block.glsl"

/// What turns a model's normals into the world's, up to a positive factor: the direction of the inverse
/// transpose, its largest column of length 1. Made of cofactors, so that a model which is scaled to a plane keeps
/// the normals of that plane; the identity for what is scaled to a line or a point.
[[nodiscard]] glm::dmat3 normalMatrix(const glm::dmat3& worldFromModel);

/// Whether a transform turns what is right-handed into what is left-handed: its determinant is negative.
[[nodiscard]] bool isMirrored(const glm::dmat4& worldFromModel);

/// The block of a mesh that stands at `worldFromModel`; normals by `normalMatrix`, so that non-uniform scale and
/// mirroring are right.
[[nodiscard]] SurfaceObject surfaceObject(const glm::dmat4& worldFromModel, const render::Material&,
                                          double textureTile = 1);

/// A draw with every map of the surface shaders bound; where the material has none, a neutral pixel is.
[[nodiscard]] render::Draw surfaceDraw(std::shared_ptr<const render::Mesh>, const glm::dmat4& worldFromModel,
                                       const render::Material&, double textureTile = 1);

/// A mesh that is blended over what is behind it.
struct TranslucentPart {
    render::Draw draw;
    render::Box box;  ///< World space.
    bool doubleSided = false;
};
/// The draws of parts in the order in which they are blended: back faces of double-sided parts by the farthest point of
/// their box, front faces by the nearest one, so that a part inside another one lies between the two sides of that.
/// Triangles of one side of a part keep their order.
[[nodiscard]] std::vector<render::Draw> farToNear(const std::vector<TranslucentPart>&, const glm::dvec3& eye);

/// Half a sphere of radius 1 on y = 0, dome up: a button.
[[nodiscard]] std::shared_ptr<const render::Mesh> domeMesh();

/// A box from -1 to 1, outward faces.
[[nodiscard]] std::shared_ptr<const render::Mesh> boxMesh();

}  // namespace vitrine
