#pragma once

#include "render/scene/mesh.h"

namespace vitrine::render {

/// Removes the vertices that no triangle uses, as in meshes that share accessors. The others keep their order.
void keepUsedVertices(Mesh&);

/// Gives every triangle vertices of its own, with the triangle's normal: three vertices per triangle.
void makeFlatNormals(Mesh&);

/// Computes tangents along +u, orthogonal to the normal, from normals and texture coordinates. w is the sign that makes
/// cross(normal, tangent) * w point up in the picture (along -v, glTF's convention). Each vertex sums the tangents of
/// its triangles, weighted by area. It gets an arbitrary tangent if the texture coordinates determine none. Charts
/// mirrored across a shared vertex cancel there: such meshes should bring their own tangents.
void makeTangents(Mesh&);

}  // namespace vitrine::render
