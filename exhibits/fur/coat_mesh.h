#pragma once

#include "render/scene/mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::fur {

// Skins for coats. Vertex::extra.x is the mean curvature in 1/m, at least 0: concave parts count as flat. Vertices at
// the same place share one normal, so shells have no gaps along edges.

/// Returns a sphere made of a cube with 6 × cells × cells quads. The tangent of the angle evens out their sizes.
[[nodiscard]] std::shared_ptr<const render::Mesh> ballSkin(double radius, int cells);

/// Returns a cylinder along x from -halfLength to halfLength with hemispheres on its ends.
[[nodiscard]] std::shared_ptr<const render::Mesh> rollSkin(double radius, double halfLength, int segments);

/// Returns a torus around y: `radius` is that of its center line, `tube` that of the tube.
[[nodiscard]] std::shared_ptr<const render::Mesh> ringSkin(double radius, double tube, int segments);

/// Returns the user's model as one skin, scaled to fit into a sphere of `radius` around the origin. Coincident vertices
/// are merged and triangles without area are dropped. Normals are those of the faces around each place, weighted by
/// their angles (Thürmer and Wüthrich 1998); the curvature follows from them. Mirrored parts are turned the right way
/// round.
///
/// Everything dropped or repaired is added to `notes`, one sentence each. Throws Failure (ErrorKind::file) naming
/// `file` if nothing is left.
[[nodiscard]] std::shared_ptr<const render::Mesh> modelSkin(const render::Model&, const std::string& file,
                                                            double radius, std::vector<std::string>& notes);

/// Returns the mean distance of the vertices from the origin: the radius of a ball that approximates a model.
[[nodiscard]] double meanRadius(const render::Mesh&);

/// Returns how many rows of quads the fins of a skin can have: at most 6, with at most 600,000 triangles in total. It
/// is 0 if one row is too many.
[[nodiscard]] int finRows(const render::Mesh& skin);

/// Returns a quad on every edge of a skin, upright. Vertex::extra.y is the height, from 0 to 1 in `rows` steps.
[[nodiscard]] std::shared_ptr<const render::Mesh> finsOf(const render::Mesh& skin, int rows);

/// Returns a flat disk of radius 1 at y = 0, facing up, fine enough for lighting at its vertices.
[[nodiscard]] std::shared_ptr<const render::Mesh> diskMesh();

}  // namespace vitrine::fur
