#include "render/scene/cube_views.h"

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine::render {

View cubeFaceView(const glm::dvec3& eye, int face, int size, double nearPlane)
{
    static const glm::dvec3 forward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    static const glm::dvec3 up[] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
    View view;
    view.eye = eye;
    view.viewFromWorld = glm::lookAt(eye, eye + forward[face], up[face]);
    view.tanHalfFov = glm::dvec2(1);
    view.nearPlane = nearPlane;
    view.clipFromView = reversedPerspective(view.tanHalfFov, view.nearPlane);
    view.clipFromWorld = view.clipFromView * view.viewFromWorld;
    view.raster.size = glm::ivec2(size);
    return view;
}

}  // namespace vitrine::render
