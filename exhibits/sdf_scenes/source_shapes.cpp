#include "exhibits/sdf_scenes/source_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::scenes {
namespace {

using render::Json;

glm::dvec3 vectorOf(const SourceNumbers& n, std::string_view key)
{
    const std::array<double, 3>& v = n.find(key)->second;
    return {v[0], v[1], v[2]};
}

double numberOf(const SourceNumbers& n, std::string_view key)
{
    return n.find(key)->second[0];
}

Json arrayOf(const glm::dvec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

Json nodeAt(const char* kind, const glm::dvec3& center)
{
    Json node = {{"kind", kind}};
    if (center != glm::dvec3(0)) node["translate"] = arrayOf(center);
    return node;
}

/// Applies "rotation_x" and the others, which the reference has for some shapes only.
void turn(Json& node, const SourceNumbers& n)
{
    const glm::dvec3 degrees(numberOf(n, "rotation_x"), numberOf(n, "rotation_y"), numberOf(n, "rotation_z"));
    if (degrees != glm::dvec3(0)) node["rotate"] = arrayOf(degrees);
}

double positive(double x, const char* what)
{
    if (!(x > 0)) throw std::string(what) + " must be above 0";
    return x;
}

Json sphereNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("sphere", vectorOf(n, "center"));
    node["radius"] = numberOf(n, "radius");
    return node;
}

/// Converts a plane, a sheet in the reference, to a solid half space that looks the same from the eye.
Json planeNode(const SourceNumbers& n, const glm::dvec3& eye)
{
    const glm::dvec3 normal = vectorOf(n, "normal");
    const double length = glm::length(normal);
    if (!(length > 0)) throw std::string("the normal is 0, 0, 0; give a direction");
    const glm::dvec3 center = vectorOf(n, "center");
    const glm::dvec3 toEye = glm::dot(eye - center, normal) < 0 ? -normal : normal;
    return {{"kind", "plane"}, {"normal", arrayOf(toEye)}, {"height", glm::dot(center, toEye) / length}};
}

Json cylinderNode(const SourceNumbers& n, const glm::dvec3&)
{
    const glm::dvec3 axis = vectorOf(n, "axis");
    const double length = glm::length(axis);
    if (!(length > 0)) throw std::string("the axis is 0, 0, 0; give a direction");
    const glm::dvec3 center = vectorOf(n, "center");
    const glm::dvec3 half = axis * (0.5 * positive(numberOf(n, "height"), "the height") / length);
    if (numberOf(n, "is_capsule") != 0)
        return {{"kind", "capsule"},
                {"start", arrayOf(center - half)},
                {"end", arrayOf(center + half)},
                {"radius", numberOf(n, "radius")}};
    Json node = nodeAt("cylinder", center);
    const glm::dvec3 unit = axis / length;
    // Rotation around z, then x, that maps +y to the axis.
    const double aboutZ = -std::asin(std::clamp(unit.x, -1.0, 1.0));
    const double aboutX = std::atan2(unit.z, unit.y);
    constexpr double degrees = 180 / std::numbers::pi;
    if (aboutX != 0 || aboutZ != 0) node["rotate"] = arrayOf({aboutX * degrees, 0, aboutZ * degrees});
    node["radius"] = numberOf(n, "radius");
    node["height"] = numberOf(n, "height");
    return node;
}

/// Converts a box. In the reference, rounding makes it larger, and the edges of a frame are a tenth of a meter.
Json boxNode(const SourceNumbers& n, const glm::dvec3&)
{
    const glm::dvec3 edges(numberOf(n, "length"), numberOf(n, "width"), numberOf(n, "height"));
    const double rounding = numberOf(n, "rounded_edges_radius");
    if (numberOf(n, "is_frame") != 0) {
        Json node = {{"kind", "boxFrame"}, {"size", arrayOf(edges)}, {"thickness", 0.1}};
        if (rounding > 0) node = {{"kind", "round"}, {"radius", rounding}, {"child", node}};
        node["translate"] = arrayOf(vectorOf(n, "center"));
        turn(node, n);
        return node;
    }
    Json node = nodeAt(rounding > 0 ? "roundBox" : "box", vectorOf(n, "center"));
    turn(node, n);
    node["size"] = arrayOf(edges + 2 * std::max(rounding, 0.0));
    if (rounding > 0) node["rounding"] = rounding;
    return node;
}

Json torusNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("torus", vectorOf(n, "center"));
    turn(node, n);
    node["majorRadius"] = vectorOf(n, "radi").x;
    node["minorRadius"] = vectorOf(n, "radi").y;
    return node;
}

Json triangleNode(const SourceNumbers& n, const glm::dvec3&)
{
    const glm::dvec3 a = vectorOf(n, "vertice1");
    const glm::dvec3 b = vectorOf(n, "vertice2");
    const glm::dvec3 c = vectorOf(n, "vertice3");
    if (!(glm::length(glm::cross(b - a, c - a)) > 0))
        throw std::string("the corners lie on one line, so it has no area; move one of them aside");
    return {{"kind", "triangle"}, {"a", arrayOf(a)}, {"b", arrayOf(b)}, {"c", arrayOf(c)}};
}

Json linkNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("link", vectorOf(n, "center"));
    node["length"] = 2 * numberOf(n, "length");
    node["majorRadius"] = numberOf(n, "radius1");
    node["minorRadius"] = numberOf(n, "radius2");
    return node;
}

Json coneNode(const SourceNumbers& n, const glm::dvec3&)
{
    const glm::dvec3 slope = vectorOf(n, "sin_cos");
    const double height = positive(numberOf(n, "height"), "the height");
    if (!(slope.x * slope.y > 0)) throw std::string("both numbers of \"sin_cos\" must be above 0");
    Json node = nodeAt("cone", vectorOf(n, "center") - glm::dvec3(0, height, 0));
    node["radius"] = height * slope.x / slope.y;
    node["height"] = height;
    return node;
}

Json hexagonalNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("hexagonalPrism", vectorOf(n, "center"));
    node["inradius"] = vectorOf(n, "heights").x;
    node["height"] = 2 * vectorOf(n, "heights").y;
    return node;
}

Json triangularNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("triangularPrism", vectorOf(n, "center"));
    node["inradius"] = 0.5 * vectorOf(n, "heights").x;
    node["height"] = 2 * vectorOf(n, "heights").y;
    return node;
}

Json ellipsoidNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("ellipsoid", vectorOf(n, "center"));
    node["radii"] = arrayOf(vectorOf(n, "radius"));
    return node;
}

Json octahedronNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("octahedron", vectorOf(n, "center"));
    node["radius"] = numberOf(n, "length");
    return node;
}

Json pyramidNode(const SourceNumbers& n, const glm::dvec3&)
{
    Json node = nodeAt("pyramid", vectorOf(n, "center"));
    node["base"] = 1;
    node["height"] = numberOf(n, "height");
    return node;
}

}  // namespace

const std::vector<SourceKind>& sourceKinds()
{
    const SourceKey center{"center", 3};
    const SourceKey aboutX{"rotation_x", 1, false};
    const SourceKey aboutY{"rotation_y", 1, false};
    const SourceKey aboutZ{"rotation_z", 1, false};
    static const std::vector<SourceKind> kinds{
        {"sphere", "spheres", {center, {"radius"}}, sphereNode},
        {"plane", "planes", {center, {"normal", 3}}, planeNode},
        {"cylinder",
         "cylinders",
         {center, {"axis", 3}, {"radius"}, {"height"}, {"is_capsule", 1, false}},
         cylinderNode},
        {"box",
         "boxes",
         {center,
          {"length"},
          {"width"},
          {"height"},
          aboutX,
          aboutY,
          aboutZ,
          {"rounded_edges_radius", 1, false},
          {"is_frame", 1, false}},
         boxNode},
        {"torus", "toruses", {center, {"radi", 2}, aboutX, aboutY, aboutZ}, torusNode},
        {"triangle", "triangles", {{"vertice1", 3}, {"vertice2", 3}, {"vertice3", 3}}, triangleNode},
        {"link", "links", {center, {"length"}, {"radius1"}, {"radius2"}}, linkNode},
        {"cone", "cones", {center, {"sin_cos", 2}, {"height"}}, coneNode},
        {"hexagonal", "hexagonals", {center, {"heights", 2}}, hexagonalNode},
        {"triangular", "triangulars", {center, {"heights", 2}}, triangularNode},
        {"ellipsoid", "ellipsoids", {center, {"radius", 3}}, ellipsoidNode},
        {"octahedron", "octahedrons", {center, {"length"}}, octahedronNode},
        {"pyramid", "pyramids", {center, {"height"}}, pyramidNode}};
    return kinds;
}

}  // namespace vitrine::scenes
