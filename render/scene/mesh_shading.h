#pragma once

#include "render/scene/mesh.h"

namespace vitrine::render {

/// Drops the vertices that no triangle has, as meshes that share accessors hold them. The others keep their order.
void keepUsedVertices(Mesh&);

/// Gives every triangle vertices of its own, with the triangle's normal: three vertices per triangle.
void makeFlatNormals(Mesh&);

/// Tangents along +u from normals and texture coordinates, orthogonal to the normal; w is the sign
/// that makes cross(normal, tangent) * w point up in the picture (along -v, glTF's convention). Each vertex sums the
/// tangents of its triangles, weighted by area; where texture coordinates say nothing it gets any tangent. Charts
/// mirrored across a shared vertex cancel there: such meshes should bring their own tangents.
void makeTangents(Mesh&);

}  // namespace vitrine::render
