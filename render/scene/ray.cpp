#include "render/scene/ray.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Returns the distance to the triangle; infinity if the ray misses it, or hits its back and `faces` excludes that.
double hitTriangle(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, Faces faces)
{
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    // The determinant is 0 for a ray within the plane, and for a triangle without area.
    if (faces == Faces::front ? !(determinant > 0) : !(determinant != 0)) return never;
    const glm::dvec3 fromA = ray.origin - a;
    const double u = glm::dot(fromA, p) / determinant;
    if (!(u >= 0 && u <= 1)) return never;
    const glm::dvec3 q = glm::cross(fromA, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (!(v >= 0 && u + v <= 1)) return never;
    const double t = glm::dot(ac, q) / determinant;
    return t > 0 ? t : never;
}

}  // namespace

Ray Ray::transformed(const glm::dmat4& transform) const
{
    return {glm::dvec3(transform * glm::dvec4(origin, 1)), glm::dvec3(transform * glm::dvec4(direction, 0))};
}

RayInterval insideBox(const Ray& ray, const Box& box)
{
    RayInterval s{0, never};
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0) {
            // The ray is parallel to the faces: always inside this slab, or never. A division would be 0 / 0 on a face.
            if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return {never, 0};
            continue;
        }
        const double a = (box.low[axis] - ray.origin[axis]) / ray.direction[axis];
        const double b = (box.high[axis] - ray.origin[axis]) / ray.direction[axis];
        s.enter = std::max(s.enter, std::min(a, b));
        s.exit = std::min(s.exit, std::max(a, b));
    }
    return s;
}

double firstHit(const Ray& ray, const Box& box)
{
    const RayInterval s = insideBox(ray, box);
    return s.enter <= s.exit ? s.enter : never;
}

double firstHit(const Ray& ray, const glm::dvec3& center, double radius)
{
    const glm::dvec3 from = ray.origin - center;
    const double a = glm::dot(ray.direction, ray.direction);
    const double b = glm::dot(from, ray.direction);
    const double c = glm::dot(from, from) - radius * radius;
    if (c <= 0) return 0;
    const double root = b * b - a * c;
    if (!(root >= 0) || b >= 0 || !(a > 0)) return never;
    return (-b - std::sqrt(root)) / a;
}

double firstHit(const Ray& ray, const Mesh& mesh, Faces faces)
{
    if (firstHit(ray, mesh.bounds) == never) return never;
    double nearest = never;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t n) { return glm::dvec3(mesh.vertices[mesh.indices[i + n]].position); };
        nearest = std::min(nearest, hitTriangle(ray, corner(0), corner(1), corner(2), faces));
    }
    return nearest;
}

double firstHit(const Ray& ray, const MeshInstance& part, Faces faces)
{
    if (!part.mesh) return never;
    const Ray local = ray.transformed(glm::inverse(part.modelFromPart));
    // A mirrored transform turns front faces into back faces, so both are tested.
    return firstHit(local, *part.mesh, part.mirrored ? Faces::both : faces);
}

}  // namespace vitrine::render
