#include "exhibits/sdf_scenes/node_rows.h"

#include <algorithm>
#include <cmath>

// Shapes around the origin, and shapes between points.

namespace vitrine::scenes {

namespace {

void addBoxes(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "box",
         .help = "A box.",
         .fields = {sizes("size", {1, 1, 1}, "Of the edges along x, y and z.")},
         .distance = SCENE_DISTANCE(sdfBox(p, 0.5 * V3(0))),
         .extent = [](const double* v) { return evenExtent(0.5 * vec3At(v, 0)); }});
    add({.name = "roundBox",
         .help = "A box with round edges and corners.",
         .fields = {sizes("size", {1, 1, 1}, "Of the outside."),
                    width("rounding", 0.1, "Radius of the edges; cut to half the smallest size.")},
         .distance = SCENE_DISTANCE(sdfRoundBox(p, 0.5 * V3(0), V(3))),
         .extent = [](const double* v) { return evenExtent(0.5 * vec3At(v, 0)); }});
    add({.name = "boxFrame",
         .help = "The twelve edges of a box.",
         .fields = {sizes("size", {1, 1, 1}, "Of the outside."), size("thickness", 0.1, "Of the edges.")},
         .exactness = Exactness::exactOutside,
         .distance = SCENE_DISTANCE(sdfBoxFrame(p, 0.5 * V3(0), V(3))),
         .extent = [](const double* v) { return evenExtent(glm::max(0.5 * vec3At(v, 0), glm::dvec3(v[3]))); }});
}

void addBalls(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "sphere",
         .help = "A ball.",
         .fields = {size("radius", 0.5, "From the center.")},
         .distance = SCENE_DISTANCE(sdfSphere(p, V(0))),
         .extent = [](const double* v) { return evenExtent(glm::dvec3(v[0])); }});
    add({.name = "plane",
         .help = "Everything below a plane.",
         .fields = {{"normal", FieldType::direction, Unit::none, -1e6, 1e6, -1, 1, {0, 1, 0}, "Out of the solid."},
                    height("height", 0, "Of the plane along the normal.")},
         .distance = SCENE_DISTANCE(sdfPlane(p, V3(0), V(3))),
         .extent = [](const double* v) {
             Extent all{endlessBox(), 0, v[2] == 0};
             for (int i = 0; i < 3; ++i) {
                 if (v[i] == 0) all.even |= 1U << i;
                 if (v[i] == 1) all.box.high[i] = v[3];
                 if (v[i] == -1) all.box.low[i] = -v[3];
             }
             return all;
         }});
    add({.name = "torus",
         .help = "A ring around the y axis.",
         .fields = {size("majorRadius", 0.5, "To the middle of the tube."), size("minorRadius", 0.2, "Of the tube.")},
         .distance = SCENE_DISTANCE(sdfTorus(p, V(0), V(1))),
         .extent = [](const double* v) {
             return evenExtent({v[0] + v[1], v[1], v[0] + v[1]});
         }});
    add({.name = "cappedTorus",
         .help = "An arc of a ring in the xy plane, around +y, with round ends.",
         .fields = {angle("halfAngle", 60, 0, 180, "From +y to each end."),
                    size("majorRadius", 0.5, "To the middle of the tube."), size("minorRadius", 0.1, "Of the tube.")},
         .distance = SCENE_DISTANCE(sdfCappedTorus(p, V(0), V(1), V(2))),
         .extent = [](const double* v) {
             return Extent{boxAround({v[1] + v[2], v[1] + v[2], v[2]}), evenInX | evenInZ};
         }});
    add({.name = "link",
         .help = "A link of a chain in the xy plane, drawn out along y.",
         .fields = {width("length", 0.6, "Of the straight parts."),
                    size("majorRadius", 0.3, "Of the bends, to the middle of the tube."),
                    size("minorRadius", 0.1, "Of the tube.")},
         .distance = SCENE_DISTANCE(sdfLink(p, 0.5 * V(0), V(1), V(2))),
         .extent = [](const double* v) {
             return evenExtent({v[1] + v[2], 0.5 * v[0] + v[1] + v[2], v[2]});
         }});
    add({.name = "capsule",
         .help = "All within a radius of a line from start to end.",
         .fields = {point("start", {0, -0.4, 0}, "One end of the line."), point("end", {0, 0.4, 0}, "The other end."),
                    size("radius", 0.2, "Around the line.")},
         .distance = SCENE_DISTANCE(sdfCapsule(p, V3(0), V3(3), V(6))),
         .extent = [](const double* v) { return segmentExtent(vec3At(v, 0), vec3At(v, 3), v[6]); }});
}

void addCylinders(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "infiniteCylinder",
         .help = "An endless cylinder around the y axis.",
         .fields = {size("radius", 0.3, "From the axis.")},
         .distance = SCENE_DISTANCE(sdfInfiniteCylinder(p, V(0))),
         .extent = [](const double* v) {
             return evenExtent({v[0], noEnd, v[0]});
         }});
    add({.name = "cylinder",
         .help = "A cylinder around the y axis.",
         .fields = {size("radius", 0.4, "From the axis."), size("height", 1, "From end to end.")},
         .distance = SCENE_DISTANCE(sdfCylinder(p, V(0), 0.5 * V(1))),
         .extent = [](const double* v) {
             return evenExtent({v[0], 0.5 * v[1], v[0]});
         }});
    add({.name = "roundCylinder",
         .help = "A cylinder around the y axis with round edges.",
         .fields = {size("radius", 0.4, "Of the outside."), size("height", 1, "From end to end."),
                    width("rounding", 0.1, "Radius of the edges; cut to the radius and half the height.")},
         .distance = SCENE_DISTANCE(sdfRoundCylinder(p, V(0), 0.5 * V(1), V(2))),
         .extent = [](const double* v) {
             return evenExtent({v[0], 0.5 * v[1], v[0]});
         }});
}

void addCones(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) { kinds.push_back(std::move(kind)); };
    add({.name = "cone",
         .help = "A cone on y = 0, its tip up.",
         .fields = {size("radius", 0.5, "Of the base."), size("height", 1, "Of the tip.")},
         .distance = SCENE_DISTANCE(sdfCone(p, V(0), V(1))),
         .extent = [](const double* v) {
             return Extent{{{-v[0], 0, -v[0]}, {v[0], v[1], v[0]}}, evenInX | evenInZ};
         }});
    add({.name = "infiniteCone",
         .help = "An endless cone, its tip at the origin, opening downward.",
         .fields = {angle("halfAngle", 30, 0.1, 89.9, "Between the axis and the side.")},
         .distance = SCENE_DISTANCE(sceneInfiniteCone(p, V(0))),
         .extent = [](const double*) {
             return Extent{{glm::dvec3(-noEnd), {noEnd, 0, noEnd}}, evenInX | evenInZ};
         }});
    add({.name = "cappedCone",
         .help = "A cone around the y axis without its tip.",
         .fields = {size("height", 1, "From end to end."), width("bottomRadius", 0.5, "At the lower end."),
                    width("topRadius", 0.2, "At the upper end.")},
         .distance = SCENE_DISTANCE(sdfCappedCone(p, 0.5 * V(0), V(1), V(2))),
         .extent =
             [](const double* v) {
                 const double r = std::max(v[1], v[2]);
                 return Extent{boxAround({r, 0.5 * v[0], r}), evenInX | evenInZ};
             },
         .fault =
             [](const double* v) {
                 return v[1] + v[2] > 0 ? std::string() : "both radii are 0; give one that is not";
             }});
    add({.name = "roundCone",
         .help = "The hull of two balls on the y axis, the lower one at the origin.",
         .fields = {size("bottomRadius", 0.4, "Of the lower ball."), size("topRadius", 0.15, "Of the upper ball."),
                    width("height", 0.8, "Of the upper ball's center.")},
         .distance = SCENE_DISTANCE(sdfRoundCone(p, V(0), V(1), V(2))),
         .extent = [](const double* v) {
             const double r = std::max(v[0], v[1]);
             return Extent{{{-r, std::min(-v[0], v[2] - v[1]), -r}, {r, std::max(v[0], v[2] + v[1]), r}},
                           evenInX | evenInZ};
         }});
}

}  // namespace

std::vector<NodeKind> solidKinds()
{
    std::vector<NodeKind> kinds;
    addBoxes(kinds);
    addBalls(kinds);
    addCylinders(kinds);
    addCones(kinds);
    return kinds;
}

}  // namespace vitrine::scenes
