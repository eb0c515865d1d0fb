#include "tests/exhibits/sdf_morph/truth.h"

#include "exhibits/sdf_morph/sdf_morph.h"
#include "exhibits/sdf_morph/torus_mug_cpu.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::test {
namespace {

glsl::TorusMug torusMug(const ParameterValues& v)
{
    static const sdf_morph::SdfMorphTable t;
    return {v[t.morph],         v[t.majorRadius],  v[t.minorRadius],     v[t.mugRadius], v[t.mugHeight],
            v[t.wallThickness], v[t.handleRadius], v[t.handleThickness], v[t.blend]};
}

}  // namespace

Ray pixelRay(const render::View& view, int x, int y)
{
    const glm::dvec2 size(view.raster.size);
    const glm::dvec2 ndc = glm::dvec2(x + 0.5, size.y - y - 0.5) / size * 2.0 - 1.0;
    return {view.eye, view.direction(ndc)};
}

Solid::Solid(const ParameterValues& values, const glm::dmat4& worldFromLocal)
    : values_(values), worldFromLocal_(worldFromLocal), localFromWorld_(glm::affineInverse(worldFromLocal))
{
    static const sdf_morph::SdfMorph exhibit;
    box_ = exhibit.bounds(values);
    const glm::dmat3 linear(worldFromLocal);
    largestScale_ = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    tolerance_ = values[exhibit.parameters().hitTolerance];
}

double Solid::distance(const glm::dvec3& local) const
{
    const glsl::TorusMug m = torusMug(values_);
    // The pure shapes at the ends, without blending.
    if (m.morph <= 0) return glsl::sdfUprightTorus(local, m);
    if (m.morph >= 1) return glsl::sdfMug(local, m);
    return glsl::sdfTorusMug(local, glsl::torusMugShape(m));
}

glm::dvec3 Solid::gradient(const glm::dvec3& p) const
{
    const double h = 1e-6;
    glm::dvec3 g;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = h;
        g[axis] = (distance(p + step) - distance(p - step)) / (2 * h);
    }
    return g;
}

glm::dvec3 Solid::normalAt(const glm::dvec3& world) const
{
    return glm::normalize(glm::transpose(glm::dmat3(localFromWorld_)) * gradient(toLocal(world)));
}

bool Solid::meetsBox(const Ray& ray, double margin) const
{
    const glm::dvec3 origin = toLocal(ray.origin);
    const glm::dvec3 direction = glm::dmat3(localFromWorld_) * ray.direction;
    double enter = 0;
    double exit = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box_.low[axis] - margin - origin[axis]) / direction[axis];
        const double b = (box_.high[axis] + margin - origin[axis]) / direction[axis];
        if (direction[axis] == 0) continue;
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    return enter <= exit;
}

Found Solid::trace(const Ray& ray, double nearest, double halfPixel, double halfTexel) const
{
    Found found;
    found.closest = 1e30;
    const glm::dvec3 origin = toLocal(ray.origin);
    const glm::dvec3 scaled = glm::dmat3(localFromWorld_) * ray.direction;
    const double length = glm::length(scaled);
    const glm::dvec3 direction = scaled / length;
    double enter = nearest * length;
    double exit = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double a = (box_.low[axis] - origin[axis]) / direction[axis];
        const double b = (box_.high[axis] - origin[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    const auto toleranceAt = [&](double t) {
        const double pixel = halfPixel * t / (length * largestScale_) * tolerance_;
        return std::max({pixel, halfTexel / largestScale_, 1e-5});
    };
    double t = enter;
    double side = 0;
    for (int i = 0; i < 20000 && t <= exit; ++i) {
        const double value = distance(origin + direction * t);
        if (side == 0) side = value < 0 ? -1 : 1;
        const double d = side * value;
        const double share = d / toleranceAt(t);
        found.grazed = found.grazed || (found.closest < 1.05 && share > found.closest);
        found.closest = std::min(found.closest, share);
        if (d < 1e-9) {
            const glm::dvec3 local = origin + direction * t;
            found.hit = true;
            found.distance = t / length;
            found.world = glm::dvec3(worldFromLocal_ * glm::dvec4(local, 1));
            found.normal = normalAt(found.world);
            found.cosine = side * -glm::dot(glm::normalize(gradient(local)), direction);
            return found;
        }
        t += std::max(0.3 * d, 1e-9);  // Short steps, so that the closest approach is found, too.
    }
    return found;
}

Found Solid::trace(const render::View& view, int x, int y) const
{
    return trace(pixelRay(view, x, y), view.nearPlane, view.tanHalfFov.y / view.raster.size.y);
}

}  // namespace vitrine::test
