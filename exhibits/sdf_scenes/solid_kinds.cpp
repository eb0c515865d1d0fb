#include "exhibits/sdf_scenes/node_parameters.h"

#include <algorithm>
#include <cmath>

// Shapes around the origin, and shapes between points.

namespace vitrine::scenes {

namespace {

void addBoxes(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "box",
         .help = "A box around the origin.",
         .fields = {sizes("size", {1, 1, 1}, "Lengths of the edges along x, y and z.")},
         .distance = SCENE_DISTANCE(sdfBox(p, 0.5 * V3(0))),
         .extent = [](const double* v) { return evenExtent(0.5 * vec3At(v, 0)); }});
    add({.name = "roundBox",
         .help = "A box with round edges and corners.",
         .fields = {sizes("size", {1, 1, 1}, "Lengths of the outer sides along x, y and z."),
                    width("rounding", 0.1, "Radius of the edges; at most half the smallest size.")},
         .distance = SCENE_DISTANCE(sdfRoundBox(p, 0.5 * V3(0), V(3))),
         .extent = [](const double* v) { return evenExtent(0.5 * vec3At(v, 0)); }});
    add({.name = "boxFrame",
         .help = "The twelve edges of a box.",
         .fields = {sizes("size", {1, 1, 1}, "Lengths of the outer sides along x, y and z."),
                    size("thickness", 0.1, "Thickness of the edges.")},
         .exactness = Exactness::exactOutside,
         .distance = SCENE_DISTANCE(sdfBoxFrame(p, 0.5 * V3(0), V(3))),
         .extent = [](const double* v) { return evenExtent(glm::max(0.5 * vec3At(v, 0), glm::dvec3(v[3]))); }});
}

void addBalls(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "sphere",
         .help = "A solid sphere around the origin.",
         .fields = {size("radius", 0.5, "Radius of the sphere.")},
         .distance = SCENE_DISTANCE(sdfSphere(p, V(0))),
         .extent = [](const double* v) { return evenExtent(glm::dvec3(v[0])); }});
    add({.name = "plane",
         .help = "A half-space: everything below a plane.",
         .fields = {{"normal",
                     FieldType::direction,
                     Unit::none,
                     -1e6,
                     1e6,
                     -1,
                     1,
                     {0, 1, 0},
                     "Normal of the plane, out of the solid."},
                    height("height", 0, "Distance of the plane from the origin along the normal.")},
         .distance = SCENE_DISTANCE(sdfPlane(p, V3(0), V(3))),
         .extent = [](const double* v) {
             Bounds all{endlessBox(), 0, v[2] == 0};
             for (int i = 0; i < 3; ++i) {
                 if (v[i] == 0) all.even |= 1U << i;
                 if (v[i] == 1) all.box.high[i] = v[3];
                 if (v[i] == -1) all.box.low[i] = -v[3];
             }
             return all;
         }});
    add({.name = "torus",
         .help = "A torus (ring) around the y axis.",
         .fields = {size("majorRadius", 0.5, "Radius from the center to the middle of the tube."),
                    size("minorRadius", 0.2, "Radius of the tube.")},
         .distance = SCENE_DISTANCE(sdfTorus(p, V(0), V(1))),
         .extent = [](const double* v) {
             return evenExtent({v[0] + v[1], v[1], v[0] + v[1]});
         }});
}

void addBentTubes(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "cappedTorus",
         .help = "An arc of a torus in the xy plane, centered at +y, with round ends.",
         .fields = {angle("halfAngle", 60, 0, 180, "Angle from +y to each end of the arc."),
                    size("majorRadius", 0.5, "Radius from the center to the middle of the tube."),
                    size("minorRadius", 0.1, "Radius of the tube.")},
         .distance = SCENE_DISTANCE(sdfCappedTorus(p, V(0), V(1), V(2))),
         .extent = [](const double* v) {
             return Bounds{boxAround({v[1] + v[2], v[1] + v[2], v[2]}), evenInX | evenInZ};
         }});
    add({.name = "link",
         .help = "A chain link in the xy plane, elongated along y.",
         .fields = {width("length", 0.6, "Length of the straight parts."),
                    size("majorRadius", 0.3, "Radius of the bends, to the middle of the tube."),
                    size("minorRadius", 0.1, "Radius of the tube.")},
         .distance = SCENE_DISTANCE(sdfLink(p, 0.5 * V(0), V(1), V(2))),
         .extent = [](const double* v) {
             return evenExtent({v[1] + v[2], 0.5 * v[0] + v[1] + v[2], v[2]});
         }});
    add({.name = "capsule",
         .help = "A capsule: everything within a radius of the segment from start to end.",
         .fields = {point("start", {0, -0.4, 0}, "Start of the segment."),
                    point("end", {0, 0.4, 0}, "End of the segment."),
                    size("radius", 0.2, "Radius around the segment.")},
         .distance = SCENE_DISTANCE(sdfCapsule(p, V3(0), V3(3), V(6))),
         .extent = [](const double* v) { return ballsExtent(vec3At(v, 0), vec3At(v, 3), v[6]); }});
}

void addCylinders(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "infiniteCylinder",
         .help = "An infinite cylinder around the y axis.",
         .fields = {size("radius", 0.3, "Radius of the cylinder.")},
         .distance = SCENE_DISTANCE(sdfInfiniteCylinder(p, V(0))),
         .extent = [](const double* v) {
             return evenExtent({v[0], noEnd, v[0]});
         }});
    add({.name = "cylinder",
         .help = "A cylinder around the y axis.",
         .fields = {size("radius", 0.4, "Radius of the cylinder."), size("height", 1, "Height from end to end.")},
         .distance = SCENE_DISTANCE(sdfCylinder(p, V(0), 0.5 * V(1))),
         .extent = [](const double* v) {
             return evenExtent({v[0], 0.5 * v[1], v[0]});
         }});
    add({.name = "roundCylinder",
         .help = "A cylinder around the y axis with round edges.",
         .fields = {size("radius", 0.4, "Radius of the outside."), size("height", 1, "Height from end to end."),
                    width("rounding", 0.1, "Radius of the edges; at most the radius and half the height.")},
         .distance = SCENE_DISTANCE(sdfRoundCylinder(p, V(0), 0.5 * V(1), V(2))),
         .extent = [](const double* v) {
             return evenExtent({v[0], 0.5 * v[1], v[0]});
         }});
}

void addCones(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "cone",
         .help = "A cone around the y axis with its base at y = 0 and its tip up.",
         .fields = {size("radius", 0.5, "Radius of the base."), size("height", 1, "Height of the tip.")},
         .distance = SCENE_DISTANCE(sdfCone(p, V(0), V(1))),
         .extent = [](const double* v) {
             return Bounds{{{-v[0], 0, -v[0]}, {v[0], v[1], v[0]}}, evenInX | evenInZ};
         }});
    add({.name = "infiniteCone",
         .help = "An infinite cone with its tip at the origin, opening downward.",
         .fields = {angle("halfAngle", 30, 0.1, 89.9, "Angle between the axis and the side.")},
         .distance = SCENE_DISTANCE(sceneInfiniteCone(p, V(0))),
         .extent = [](const double*) {
             return Bounds{{glm::dvec3(-noEnd), {noEnd, 0, noEnd}}, evenInX | evenInZ};
         }});
    add({.name = "cappedCone",
         .help = "A truncated cone around the y axis.",
         .fields = {size("height", 1, "Height from end to end."),
                    width("bottomRadius", 0.5, "Radius at the lower end."),
                    width("topRadius", 0.2, "Radius at the upper end.")},
         .distance = SCENE_DISTANCE(sdfCappedCone(p, 0.5 * V(0), V(1), V(2))),
         .extent =
             [](const double* v) {
                 const double r = std::max(v[1], v[2]);
                 return Bounds{boxAround({r, 0.5 * v[0], r}), evenInX | evenInZ};
             },
         .fault =
             [](const double* v) {
                 return v[1] + v[2] > 0 ? std::string() : "both radii are 0; give one that is not";
             }});
    add({.name = "roundCone",
         .help = "The convex hull of two spheres on the y axis, the lower one at the origin.",
         .fields = {size("bottomRadius", 0.4, "Radius of the lower sphere."),
                    size("topRadius", 0.15, "Radius of the upper sphere."),
                    width("height", 0.8, "Height of the center of the upper sphere.")},
         .distance = SCENE_DISTANCE(sdfRoundCone(p, V(0), V(1), V(2))),
         .extent = [](const double* v) {
             const double r = std::max(v[0], v[1]);
             return Bounds{{{-r, std::min(-v[0], v[2] - v[1]), -r}, {r, std::max(v[0], v[2] + v[1]), r}},
                           evenInX | evenInZ};
         }});
}

}  // namespace

std::vector<NodeKind> solidKinds()
{
    std::vector<NodeKind> kinds;
    addBoxes(kinds);
    addBalls(kinds);
    addBentTubes(kinds);
    addCylinders(kinds);
    addCones(kinds);
    return kinds;
}

namespace {

std::string faultOfTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (glm::length(glm::cross(b - a, c - a)) > 1e-9 * longest * longest && longest > 0) return {};
    return "the corners lie on one line, so it has no area; move one of them aside";
}

std::string faultOfSegment(const double* v)
{
    return vec3At(v, 0) != vec3At(v, 3) ? std::string() : "start and end are the same point; move one of them";
}

std::vector<Field> endsOf(std::vector<Field> further)
{
    std::vector<Field> all{point("start", {0, -0.5, 0}, "Position of the first end."),
                           point("end", {0, 0.5, 0}, "Position of the second end.")};
    all.insert(all.end(), further.begin(), further.end());
    return all;
}

/// Returns the bounds of a profile around the z axis; x and y are its half sizes.
Bounds profileExtent(double x, double y)
{
    return {boxAround({x, y, noEnd}), evenInAll, true};
}

void addPrisms(std::vector<NodeKind>& kinds)
{
    kinds.push_back({.name = "hexagonalPrism",
                     .help = "A prism along z with a regular hexagon in the xy plane, flat sides up and down.",
                     .fields = {size("inradius", 0.4, "Distance from the center to a side."),
                                size("height", 0.6, "Length along z.")},
                     .distance = SCENE_DISTANCE(sdfHexPrism(p, V(0), 0.5 * V(1))),
                     .extent = [](const double* v) {
                         return evenExtent({v[0] * 2 / std::sqrt(3.0), v[0], 0.5 * v[1]});
                     }});
    kinds.push_back({.name = "triangularPrism",
                     .help = "A prism along z with an equilateral triangle in the xy plane, a corner up.",
                     .fields = {size("inradius", 0.3, "Distance from the center to a side."),
                                size("height", 0.6, "Length along z.")},
                     .distance = SCENE_DISTANCE(sdfTriangularPrism(p, V(0), 0.5 * V(1))),
                     .extent = [](const double* v) {
                         const double x = v[0] * std::sqrt(3.0);
                         return Bounds{{{-x, -v[0], -0.5 * v[1]}, {x, 2 * v[0], 0.5 * v[1]}}, evenInX | evenInZ};
                     }});
    kinds.push_back(
        {.name = "rhombus",
         .help = "A prism along y with a rhombus in the xz plane.",
         .fields = {size("alongX", 1, "Length of the diagonal along x."),
                    size("alongZ", 0.6, "Length of the diagonal along z."), size("height", 0.4, "Height along y.")},
         .distance = SCENE_DISTANCE(sceneRhombus(p, V(0), V(1), V(2))),
         .extent = [](const double* v) { return evenExtent(0.5 * glm::dvec3(v[0], v[2], v[1])); }});
    kinds.push_back({.name = "octahedron",
                     .help = "A regular octahedron with its corners on the axes.",
                     .fields = {size("radius", 0.6, "Distance from the center to a corner.")},
                     .distance = SCENE_DISTANCE(sdfOctahedron(p, V(0))),
                     .extent = [](const double* v) { return evenExtent(glm::dvec3(v[0])); }});
    kinds.push_back(
        {.name = "pyramid",
         .help = "A pyramid with a square base at y = 0.",
         .fields = {size("base", 1, "Length of an edge of the base."), size("height", 0.8, "Height of the tip.")},
         .distance = SCENE_DISTANCE(scenePyramid(p, V(0), V(1))),
         .extent = [](const double* v) {
             const double r = 0.5 * v[0];
             return Bounds{{{-r, 0, -r}, {r, v[1], r}}, evenInX | evenInZ};
         }});
    kinds.push_back({.name = "ellipsoid",
                     .help = "An ellipsoid around the origin.",
                     .fields = {sizes("radii", {0.6, 0.4, 0.3}, "Radii along x, y and z.")},
                     .distance = SCENE_DISTANCE(sceneEllipsoid(p, V3(0))),
                     .extent = [](const double* v) { return evenExtent(vec3At(v, 0)); },
                     .fault =
                         [](const double* v) {
                             const auto [least, most] = std::minmax({v[0], v[1], v[2]});
                             return most <= 1000 * least
                                        ? std::string()
                                        : "the largest radius is more than 1000 times the smallest; bring them nearer";
                         }});
}

void addBallParts(std::vector<NodeKind>& kinds)
{
    const auto round = [](const double* v) { return Bounds{boxAround(glm::dvec3(v[0])), evenInX | evenInZ}; };
    kinds.push_back({.name = "solidAngle",
                     .help = "A sphere sector: the part of a sphere within a cone around +y.",
                     .fields = {size("radius", 0.6, "Radius of the sphere."),
                                angle("halfAngle", 40, 0.1, 180, "Angle between the axis and the side of the cone.")},
                     .distance = SCENE_DISTANCE(sdfSolidAngle(p, V(1), V(0))),
                     .extent = round});
    kinds.push_back(
        {.name = "cutSphere",
         .help = "A sphere cut off above a plane.",
         .fields = {size("radius", 0.5, "Radius of the sphere."), height("cut", 0.2, "Height of the cutting plane.")},
         .distance = SCENE_DISTANCE(sdfCutSphere(p, V(0), V(1))),
         .extent = round,
         .fault = [](const double* v) {
             return v[1] > -v[0] ? std::string() : "the cut leaves nothing; raise it above -radius";
         }});
    kinds.push_back(
        {.name = "cutHollowSphere",
         .help = "A bowl: the wall of a hollow sphere, open above a plane.",
         .fields = {size("radius", 0.5, "Radius to the middle of the wall."), height("cut", 0.1, "Height of the rim."),
                    size("thickness", 0.05, "Thickness of the wall.")},
         .distance = SCENE_DISTANCE(sceneCutHollowSphere(p, V(0), V(1), V(2))),
         .extent = [](const double* v) {
             return Bounds{boxAround(glm::dvec3(v[0] + 0.5 * v[2])), evenInX | evenInZ};
         }});
    kinds.push_back({.name = "deathStar",
                     .help = "A sphere with a spherical dent, cut by another sphere above it.",
                     .fields = {size("radius", 0.5, "Radius of the sphere."),
                                size("holeRadius", 0.35, "Radius of the cutting sphere."),
                                size("offset", 0.55, "Distance between the two centers.")},
                     .exactness = Exactness::exactOutside,
                     .distance = SCENE_DISTANCE(sceneDeathStar(p, V(0), V(1), V(2))),
                     .extent = round,
                     .fault = [](const double* v) {
                         return v[1] < v[0] + v[2] ? std::string() : "the hole takes all of it; make it smaller";
                     }});
}

void addBetweenPoints(std::vector<NodeKind>& kinds)
{
    kinds.push_back(
        {.name = "cappedConeBetween",
         .help = "A truncated cone from start to end.",
         .fields =
             endsOf({width("startRadius", 0.4, "Radius at the start."), width("endRadius", 0.2, "Radius at the end.")}),
         .distance = SCENE_DISTANCE(sceneCappedCone(p, V3(0), V3(3), V(6), V(7))),
         .extent = [](const double* v) { return segmentExtent(vec3At(v, 0), vec3At(v, 3), std::max(v[6], v[7])); },
         .fault =
             [](const double* v) {
                 return v[6] + v[7] > 0 ? faultOfSegment(v) : "both radii are 0; give one that is not";
             }});
    kinds.push_back(
        {.name = "roundConeBetween",
         .help = "The convex hull of two spheres, at start and end.",
         .fields =
             endsOf({size("startRadius", 0.4, "Radius at the start."), size("endRadius", 0.2, "Radius at the end.")}),
         .distance = SCENE_DISTANCE(sceneRoundCone(p, V3(0), V3(3), V(6), V(7))),
         .extent = [](const double* v) { return ballsExtent(vec3At(v, 0), vec3At(v, 3), std::max(v[6], v[7])); }});
    kinds.push_back({.name = "vesica",
                     .help = "A spindle with sharp tips at start and end.",
                     .fields = endsOf({size("radius", 0.25, "Radius in the middle; at most half the length.")}),
                     .distance = SCENE_DISTANCE(sceneVesica(p, V3(0), V3(3), V(6))),
                     .extent =
                         [](const double* v) {
                             const double most = 0.5 * glm::length(vec3At(v, 3) - vec3At(v, 0));
                             return ballsExtent(vec3At(v, 0), vec3At(v, 3), std::min(v[6], most));
                         },
                     .fault = faultOfSegment});
}

void addSheets(std::vector<NodeKind>& kinds)
{
    kinds.push_back(
        {.name = "triangle",
         .help = "A thin sheet with three corners.",
         .fields = {point("a", {-0.5, 0, 0}, "Position of the first corner."),
                    point("b", {0.5, 0, 0}, "Position of the second corner."),
                    point("c", {0, 0.8, 0}, "Position of the third corner."),
                    width("thickness", 0, "Thickness of the sheet, with round edges.")},
         .distance = SCENE_DISTANCE(sdfTriangle(p, V3(0), V3(3), V3(6)) - 0.5 * V(9)),
         .extent =
             [](const double* v) {
                 Bounds all = segmentExtent(vec3At(v, 0), vec3At(v, 3), 0);
                 all.box.include(vec3At(v, 6));
                 return Bounds{grown(all.box, 0.5 * v[9]), 0};
             },
         .fault = [](const double* v) { return faultOfTriangle(vec3At(v, 0), vec3At(v, 3), vec3At(v, 6)); }});
    kinds.push_back({.name = "quad",
                     .help = "A thin sheet with four corners, in order around it.",
                     .fields = {point("a", {-0.5, 0, 0}, "Position of the first corner."),
                                point("b", {0.5, 0, 0}, "Position of the second corner."),
                                point("c", {0.5, 0.8, 0}, "Position of the third corner."),
                                point("d", {-0.5, 0.8, 0}, "Position of the fourth corner."),
                                width("thickness", 0, "Thickness of the sheet, with round edges.")},
                     .distance = SCENE_DISTANCE(sceneQuad(p, V3(0), V3(3), V3(6), V3(9)) - 0.5 * V(12)),
                     .extent =
                         [](const double* v) {
                             Bounds all = segmentExtent(vec3At(v, 0), vec3At(v, 3), 0);
                             all.box.include(vec3At(v, 6));
                             all.box.include(vec3At(v, 9));
                             return Bounds{grown(all.box, 0.5 * v[12]), 0};
                         },
                     .fault =
                         [](const double* v) {
                             const std::string first = faultOfTriangle(vec3At(v, 0), vec3At(v, 3), vec3At(v, 6));
                             return first.empty() ? faultOfTriangle(vec3At(v, 0), vec3At(v, 6), vec3At(v, 9)) : first;
                         }});
}

}  // namespace

std::vector<NodeKind> furtherSolidKinds()
{
    std::vector<NodeKind> kinds;
    addPrisms(kinds);
    addBallParts(kinds);
    addBetweenPoints(kinds);
    addSheets(kinds);
    kinds.push_back(
        {.name = "noise",
         .help = "Everything where smooth noise is below a level; infinite.",
         .fields = {plain("frequency", 1, 0.01, 100, "Frequency of the noise, in cells per meter."),
                    plain("level", 0, -1, 1,
                          "Noise value below which space is solid: -1 leaves nothing, 1 fills everything."),
                    count("octaves", 1, 1, 8, "Number of octaves that are summed: each adds finer detail."),
                    plain("gain", 0.5, 0, 1,
                          "Strength of an octave relative to the one before: low is smooth, high is rough."),
                    point("shift", {0, 0, 0}, "Shift of the noise through space.")},
         .exactness = Exactness::bound,
         .distance = SCENE_DISTANCE(sceneNoiseSolid(p, V(0), V(1), V(2), V(3), V3(4))),
         .extent = [](const double*) {
             return Bounds{endlessBox(), 0};
         }});
    return kinds;
}

std::vector<NodeKind> profileKinds()
{
    std::vector<NodeKind> kinds;
    kinds.push_back({.name = "circle",
                     .help = "A disk in the xy plane, infinite along z; use it in extrude or revolve.",
                     .fields = {size("radius", 0.4, "Radius of the disk.")},
                     .distance = SCENE_DISTANCE(length(vec2(p.x, p.y)) - V(0)),
                     .extent = [](const double* v) { return profileExtent(v[0], v[0]); }});
    kinds.push_back({.name = "rectangle",
                     .help = "A rectangle in the xy plane, infinite along z; use it in extrude or revolve.",
                     .fields = {size("width", 0.8, "Length along x."), size("height", 0.5, "Length along y.")},
                     .distance = SCENE_DISTANCE(sdfRectangle(vec2(p.x, p.y), 0.5 * vec2(V(0), V(1)))),
                     .extent = [](const double* v) { return profileExtent(0.5 * v[0], 0.5 * v[1]); }});
    kinds.push_back(
        {.name = "equilateralTriangle",
         .help = "A triangle in the xy plane with a corner up, infinite along z; use it in extrude or revolve.",
         .fields = {size("inradius", 0.25, "Distance from the center to a side.")},
         .distance = SCENE_DISTANCE(sdfTriangleProfile(vec2(p.x, p.y), V(0))),
         .extent = [](const double* v) {
             const double x = v[0] * std::sqrt(3.0);
             return Bounds{{{-x, -v[0], -noEnd}, {x, 2 * v[0], noEnd}}, evenInX | evenInZ, true};
         }});
    kinds.push_back(
        {.name = "hexagon",
         .help = "A hexagon in the xy plane, flat sides up and down, infinite along z; use it in extrude or revolve.",
         .fields = {size("inradius", 0.4, "Distance from the center to a side.")},
         .distance = SCENE_DISTANCE(sdfHexPrism(vec3(p.x, p.y, 0.0), V(0), 1.0e9)),
         .extent = [](const double* v) { return profileExtent(v[0] * 2 / std::sqrt(3.0), v[0]); }});
    return kinds;
}

}  // namespace vitrine::scenes
