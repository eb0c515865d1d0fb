#pragma once

#include "render/scene/camera.h"

namespace vitrine::render {

/// Returns the view through one face (0 to 5: +x -x +y -y +z -z, in OpenGL's orientation) of a cube map around `eye`:
/// 90 degrees, `size` pixels along each side.
[[nodiscard]] View cubeFaceView(const glm::dvec3& eye, int face, int size, double nearPlane = 0.02);

}  // namespace vitrine::render
