#pragma once

#include "render/scene/mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine {

// Skins that can wear a coat. Vertex::extra.x carries the mean curvature, 1/meter (never below 0: a
// hollow bulges nothing). Vertices that share a place share a normal, so that shells do not
// tear along edges.

/// A sphere from a cube of 6 × cells × cells quads, corners evened out by the tangent of the angle.
[[nodiscard]] std::shared_ptr<const render::Mesh> ballSkin(double radius, int cells);

/// A cylinder along x from -halfLength to halfLength with half balls on its ends.
[[nodiscard]] std::shared_ptr<const render::Mesh> rollSkin(double radius, double halfLength, int segments);

/// A torus around y: `radius` to the middle of the tube, `tube` its own.
[[nodiscard]] std::shared_ptr<const render::Mesh> ringSkin(double radius, double tube, int segments);

/// The visitor's model as one skin, scaled to fit a sphere of `radius` around the origin: places merged,
/// triangles without area left out, normals made anew from the faces around each place (weighted by their
/// angle, Thürmer and Wüthrich 1998) and curvature from them, sides of mirrored parts turned back. What was left out or
/// mended is said in `notes`, one sentence each. Throws Failure (Blame::file), naming `file`, when nothing is left.
[[nodiscard]] std::shared_ptr<const render::Mesh> modelSkin(const render::Model&, const std::string& file,
                                                            double radius, std::vector<std::string>& notes);

/// Mean distance of the corners from the origin: how large a ball stands for a model where its shape does not matter.
[[nodiscard]] double meanRadius(const render::Mesh&);

/// Rows of quads that the fins of a skin can have, 6 at most, so that all of them have no more than 600,000 triangles;
/// 0: its edges alone are too many.
[[nodiscard]] int finRows(const render::Mesh& skin);

/// A quad on every edge of a skin, standing on it; Vertex::extra.y is the height, 0 or 1 in `rows` steps.
[[nodiscard]] std::shared_ptr<const render::Mesh> finsOf(const render::Mesh& skin, int rows);

/// A flat disk of radius 1 on y = 0, facing up, in rings fine enough for light computed at its vertices.
[[nodiscard]] std::shared_ptr<const render::Mesh> diskMesh();

}  // namespace vitrine
