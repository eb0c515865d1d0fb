#pragma once

#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine {

#include "shaders/kit/surface_object_block.glsl"

/// Returns the matrix from a model's normals to the world's, up to a positive factor. It is the inverse transpose,
/// scaled so that its largest column has length 1. It is made of cofactors, so a model scaled to a plane keeps the
/// normals of that plane. For a model scaled to a line or a point it is the identity.
[[nodiscard]] glm::dmat3 normalMatrix(const glm::dmat3& worldFromModel);

/// Returns whether a transform changes handedness: its determinant is negative.
[[nodiscard]] bool isMirrored(const glm::dmat4& worldFromModel);

/// Returns the block of a mesh at `worldFromModel`. Normals use `normalMatrix`, so non-uniform scale and mirroring are
/// right.
[[nodiscard]] SurfaceObject surfaceObject(const glm::dmat4& worldFromModel, const render::Material&,
                                          double textureTile = 1);

/// Adds the permutations that a material needs besides its maps: SECOND_UV and UNLIT.
void addMaterialDefines(const render::Material&, std::vector<std::string>& defines);

/// Returns a draw with every map of the surface shaders bound; missing ones are replaced by a neutral pixel.
[[nodiscard]] render::Draw surfaceDraw(std::shared_ptr<const render::Mesh>, const glm::dmat4& worldFromModel,
                                       const render::Material&, double textureTile = 1);

/// Mesh that is blended over what is behind it.
struct TranslucentPart {
    render::Draw draw;
    render::Box box;  ///< World space.
    bool doubleSided = false;
};
/// Returns the draws of parts in blending order. Back faces of double-sided parts are sorted by the farthest point of
/// their box, front faces by the nearest. So a part inside another is drawn between the two sides of the outer one.
/// Triangles of one side of a part keep their order.
[[nodiscard]] std::vector<render::Draw> farToNear(const std::vector<TranslucentPart>&, const glm::dvec3& eye);

/// Returns a hemisphere of radius 1 above y = 0: a button.
[[nodiscard]] std::shared_ptr<const render::Mesh> domeMesh();

/// Returns a box from -1 to 1 with outward faces.
[[nodiscard]] std::shared_ptr<const render::Mesh> boxMesh();

}  // namespace vitrine
