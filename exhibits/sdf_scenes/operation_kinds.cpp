#include "exhibits/sdf_scenes/node_parameters.h"

#include <algorithm>
#include <cmath>

// Operations: with several children, with one, and repetitions of one.

namespace vitrine::scenes {
namespace {

constexpr unsigned evenInXz = evenInX | evenInZ;

std::vector<Field> blendFields()
{
    return {{"blend",
             FieldType::choice,
             Unit::none,
             0,
             3,
             0,
             3,
             {0, 0, 0},
             "Profile of the blend between the surfaces.",
             {"quadratic", "cubic", "circular", "exponential"}},
            width("blendWidth", 0, "Width of the blend; 0 leaves a sharp edge.")};
}

render::Box joined(const render::Box& a, const render::Box& b)
{
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Bounds joinedExtent(const Bounds& a, const Bounds& b)
{
    return {joined(a.box, b.box), a.even & b.even, a.flat && b.flat};
}

/// Returns the level of an operand. A blend reduces the distance by at most this share of its width, for each further
/// child (the exponential one, by its limit for two).
double levelOfOperand(const double* v, double level, double siblings)
{
    constexpr double shares[] = {0.25, 1.0 / 6, 0.3, 1};
    return level + shares[static_cast<int>(v[0])] * std::min(v[1], 1000.0) * siblings;
}

/// Returns half the width of a box around the y axis.
double radiusAround(const render::Box& box)
{
    const glm::dvec3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
    return std::hypot(far.x, far.z);
}

Bounds extruded(const Bounds& child, const double* v, double level)
{
    Bounds all{child.box, (child.even & (evenInX | evenInY)) | evenInZ};
    all.box.low.z = -0.5 * v[0] - level;
    all.box.high.z = 0.5 * v[0] + level;
    return all;
}

Bounds revolved(const Bounds& child, const double* v, double)
{
    const double reach = std::max({child.box.high.x + v[0], 0.0});
    return {{{-reach, child.box.low.y, -reach}, {reach, child.box.high.y, reach}}, evenInXz | (child.even & evenInY)};
}

Bounds mirrored(const Bounds& child, const double* v, double)
{
    Bounds all = child;
    for (int i = 0; i < 3; ++i) {
        if (v[i] < 0.5) continue;
        const double reach = std::max(child.box.high[i], 0.0);
        all.box.low[i] = -reach;
        all.box.high[i] = reach;
        all.even |= 1U << i;
    }
    return all;
}

Bounds sameExtent(const Bounds& child, const double*, double)
{
    return child;
}

/// Inverse of `sceneSheared`: the child's distance where the sheared distance is `level`, at this distance from the
/// axis.
double levelOfSheared(const double* v, double level, double reach)
{
    return level * (1 + std::abs(v[0]) * (reach + level));
}

/// Returns how many copies of a child from `low` to `high` may be nearest along an axis.
double copiesAsked(double low, double high, bool even, double spacing, double copies)
{
    if (even && high <= 0.5 * spacing) return 1;
    const double most = std::max(std::ceil((high - low) / spacing), 0.0) + 1;
    return copies > 0.5 ? std::min(most, copies) : most;
}

RepeatRange askedCells(const Bounds& child, bool exactChild, const double* v)
{
    RepeatRange asked;
    double copies = 1;
    bool allEven = true;
    double nearest = noEnd;
    for (int i = 0; i < 3; ++i) {
        if (!(v[i] > 0)) continue;
        nearest = std::min(nearest, v[i]);
        const bool even = (child.even & (1U << i)) != 0;
        asked.times[i] = copiesAsked(child.box.low[i], child.box.high[i], even, v[i], v[i + 3]);
        asked.high[i] = asked.times[i] > 1 ? child.box.high[i] : 0;
        const bool own = (even && child.box.high[i] <= 0.5 * v[i]) || v[i + 3] == 1;
        allEven = allEven && own;
        copies *= v[i + 3] > 0.5 ? v[i + 3] : noEnd;
    }
    if (exactChild || allEven) return asked;
    constexpr double fewCopies = 27;
    asked.cap = copies <= fewCopies ? 0 : 0.5 * nearest;
    for (int i = 0; i < 3; ++i) {
        if (!(v[i] > 0)) continue;
        // All copies, or those whose boxes are within the cap.
        const double within = std::floor((child.box.high[i] - child.box.low[i] + 2 * asked.cap) / v[i]) + 1;
        asked.times[i] = asked.cap == 0 ? v[i + 3] : v[i + 3] > 0.5 ? std::min(within, v[i + 3]) : within;
        asked.high[i] = child.box.high[i] + asked.cap - 0.5 * v[i];
    }
    asked.box = child.box;
    return asked;
}

Bounds repeatedExtent(const Bounds& child, const double* v, double)
{
    Bounds all{child.box, 0};
    for (int i = 0; i < 3; ++i) {
        if (!(v[i] > 0)) continue;
        const double reach = v[i + 3] > 0.5 ? 0.5 * (v[i + 3] - 1) * v[i] : noEnd;
        all.box.low[i] -= reach;
        all.box.high[i] += reach;
    }
    return all;
}

RepeatRange askedAround(const Bounds& child, bool exactChild, const double* v)
{
    const double sector = 2 * std::numbers::pi / v[0];
    const render::Box& box = child.box;
    RepeatRange all;
    // The nearest copy of a ball is the one with the nearest center, which is that in the sector of the point.
    if (child.ballsFrom >= 0) return all;
    all.times.x = v[0];
    const bool aroundAxis = !(box.low.x > 0 || box.high.x < 0 || box.low.z > 0 || box.high.z < 0);
    if (aroundAxis || box.empty()) return all;
    // The box does not contain the axis, so its corners span less than half a turn around its center.
    const glm::dvec3 far(1e9);  // An infinite box would have no center.
    const glm::dvec3 center = 0.5 * (glm::clamp(box.low, -far, far) + glm::clamp(box.high, -far, far));
    const double middle = std::atan2(center.z, center.x);
    double low = 0;
    double high = 0;
    for (const double x : {box.low.x, box.high.x})
        for (const double z : {box.low.z, box.high.z}) {
            const double away = std::remainder(std::atan2(z, x) - middle, 2 * std::numbers::pi);
            low = std::min(low, away);
            high = std::max(high, away);
        }
    if (!(std::isfinite(low) && std::isfinite(high))) return all;
    const bool own = (child.even & evenInZ) != 0 && box.low.x > 0 && high - low <= sector;
    if (!own && !exactChild) return all;
    all.times.x = own ? 1 : std::min(std::ceil((high - low) / sector) + 1, v[0]);
    all.high.x = own ? 0 : middle + high;
    return all;
}

/// Returns half the width of a box around the z axis.
double radiusAroundZ(const render::Box& box)
{
    const glm::dvec3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
    return std::hypot(far.x, far.y);
}

/// Returns the bounds after a rotation around the y axis.
Bounds turnedExtent(const Bounds& child, const double*, double)
{
    const double reach = radiusAround(child.box);
    return {{{-reach, child.box.low.y, -reach}, {reach, child.box.high.y, reach}}, 0};
}

Bounds bentExtent(const Bounds& child, const double*, double)
{
    const double reach = radiusAroundZ(child.box);
    return {{{-reach, -reach, child.box.low.z}, {reach, reach, child.box.high.z}}, 0};
}

/// Adds the modifiers that change the distance, or the point, uniformly everywhere.
void addReshaping(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) {
        kind.form = Form::modifier;
        kinds.push_back(std::move(kind));
    };
    add({.name = "round",
         .help = "The child grown by a radius, with round edges.",
         .fields = {width("radius", 0.05, "Radius by which the child grows.")},
         .exactness = Exactness::exactOutside,
         .after = SCENE_AFTER(sdfRound(d, V(0))),
         .childLevel = [](const double* v, double level, double) { return level + v[0]; },
         .extentOf = sameExtent});
    add({.name = "onion",
         .help = "A shell around the child's surface, hollow inside.",
         .fields = {size("thickness", 0.05, "Thickness of the wall.")},
         .exactness = Exactness::bound,
         .after = SCENE_AFTER(sdfOnion(d, V(0))),
         .childLevel = [](const double* v, double level, double) { return level + 0.5 * v[0]; },
         .extentOf = sameExtent});
    add({.name = "elongate",
         .help = "The child cut at the origin and pulled apart along the axes.",
         .fields = {{"size",
                     FieldType::vector,
                     Unit::meter,
                     0,
                     largestSize,
                     0,
                     2,
                     {0.5, 0, 0},
                     "Lengths inserted along x, y and z."}},
         .exactness = Exactness::bound,
         .place = SCENE_PLACE(sdfElongate(p, 0.5 * V3(0))),
         .extentOf = [](const Bounds& child, const double* v, double) {
             return Bounds{{child.box.low - 0.5 * vec3At(v, 0), child.box.high + 0.5 * vec3At(v, 0)}, child.even};
         }});
    add({.name = "extrude",
         .help = "The child's cross-section at z = 0, extruded along z.",
         .fields = {size("height", 0.4, "Length along z.")},
         .ofFlatChild = true,
         .place = SCENE_PLACE(sceneFlat(p)),
         .after = SCENE_AFTER(sdfExtrude(d, p.z, 0.5 * V(0))),
         .extentOf = extruded});
    add({.name = "revolve",
         .help = "The child's cross-section at z = 0, revolved around the y axis.",
         .fields = {width("offset", 0.5, "Distance by which the cross-section is first moved away from the axis.")},
         .exactness = Exactness::exactOutside,
         .ofFlatChild = true,
         .place = SCENE_PLACE(sceneRevolve(p, V(0))),
         .extentOf = revolved});
    add({.name = "mirror",
         .help = "The half of the child at positive coordinates, and its mirror image.",
         .fields = {toggle("x", true, "Whether to mirror at the plane x = 0."),
                    toggle("y", false, "Whether to mirror at the plane y = 0."),
                    toggle("z", false, "Whether to mirror at the plane z = 0.")},
         .exactness = Exactness::bound,
         .place = SCENE_PLACE(sceneMirror(p, V3(0))),
         .extentOf = mirrored});
}

/// Adds the modifiers that stretch space, or the distance, differently at different places.
void addDistorting(std::vector<NodeKind>& kinds)
{
    const auto add = [&](NodeKind kind) {
        kind.form = Form::modifier;
        kinds.push_back(std::move(kind));
    };
    add({.name = "twist",
         .help = "The child twisted about the y axis.",
         .fields = {angle("rate", 90, -3600, 3600, "Angle of the twist per meter of height: 0 is straight.")},
         .exactness = Exactness::bound,
         .place = SCENE_PLACE(sceneTwist(p, V(0))),
         .after = SCENE_AFTER(sceneTwisted(d, p, V(0))),
         .lipschitz = [](const glm::dvec3& p, const double* v) { return 1 + std::abs(v[0]) * std::hypot(p.x, p.z); },
         .childLevelWithin = levelOfSheared,
         .reachOf = radiusAround,
         .extentOf = turnedExtent});
    add({.name = "bend",
         .help = "The child bent about the z axis, along x.",
         .fields = {angle("rate", 30, -3600, 3600, "Angle of the bend per meter along x: 0 is straight.")},
         .exactness = Exactness::bound,
         .place = SCENE_PLACE(sceneBend(p, V(0))),
         .after = SCENE_AFTER(sceneBent(d, p, V(0))),
         .lipschitz = [](const glm::dvec3& p, const double* v) { return 1 + std::abs(v[0]) * std::hypot(p.x, p.y); },
         .childLevelWithin = levelOfSheared,
         .reachOf = radiusAroundZ,
         .extentOf = bentExtent});
    add({.name = "displace",
         .help = "The child with its surface displaced by smooth noise.",
         .fields = {width("amplitude", 0.05, "Amplitude of the first octave: 0 displaces nothing."),
                    plain("frequency", 4, 0.01, 100, "Frequency of the noise, in cells per meter."),
                    count("octaves", 1, 1, 8, "Number of octaves that are summed: each adds finer detail."),
                    plain("gain", 0.5, 0, 1,
                          "Strength of an octave relative to the one before: low is smooth, high is rough."),
                    point("shift", {0, 0, 0}, "Shift of the noise through space.")},
         .exactness = Exactness::bound,
         .after = SCENE_AFTER(sceneDisplaced(d, p, V(0), V(1), V(2), V(3), V3(4))),
         .lipschitz = [](const glm::dvec3&,
                         const double* v) { return glsl::sceneDisplacementSlope(v[0], v[1], v[2], v[3]); },
         .childLevel =
             [](const double* v, double level, double) {
                 const double octaves = v[3] < 1 ? (1 - std::pow(v[3], v[2])) / (1 - v[3]) : v[2];
                 return level * glsl::sceneDisplacementSlope(v[0], v[1], v[2], v[3]) + v[0] * octaves;
             },
         .extentOf =
             [](const Bounds& child, const double*, double) {
                 return Bounds{child.box, 0};
             }});
}

}  // namespace

std::vector<NodeKind> operandKinds()
{
    std::vector<NodeKind> kinds;
    const auto fields = blendFields();
    kinds.push_back({.name = "union",
                     .form = Form::operands,
                     .help = "Union: everything that is in any child.",
                     .fields = fields,
                     .exactness = Exactness::exactOutside,
                     .combine = SCENE_COMBINE(sceneUnion(a, b, V(1), int(V(0)))),
                     .share = SCENE_COMBINE(sceneUnionShare(a, b, V(1), int(V(0)))),
                     .lesserFrom =
                         [](const double* v) {
                             const bool fades = static_cast<int>(v[0]) == 3 && v[1] > 0;  // The exponential profile.
                             return fades ? std::numeric_limits<double>::infinity() : v[1];
                         },
                     .childLevel = levelOfOperand,
                     .extentOfTwo = joinedExtent});
    kinds.push_back({.name = "subtraction",
                     .form = Form::operands,
                     .help = "Difference: the first child without the others.",
                     .fields = fields,
                     .exactness = Exactness::bound,
                     .combine = SCENE_COMBINE(sceneSubtraction(a, b, V(1), int(V(0)))),
                     .share = SCENE_COMBINE(sceneSubtractionShare(a, b, V(1), int(V(0)))),
                     .extentOfTwo = [](const Bounds& a, const Bounds& b) {
                         return Bounds{a.box, a.even & b.even, a.flat && b.flat};
                     }});
    kinds.push_back({.name = "intersection",
                     .form = Form::operands,
                     .help = "Intersection: everything that all children share.",
                     .fields = fields,
                     .exactness = Exactness::bound,
                     .combine = SCENE_COMBINE(sceneIntersection(a, b, V(1), int(V(0)))),
                     .share = SCENE_COMBINE(sceneIntersectionShare(a, b, V(1), int(V(0)))),
                     .extentOfTwo = [](const Bounds& a, const Bounds& b) {
                         return Bounds{a.box.intersection(b.box), a.even & b.even, a.flat && b.flat};
                     }});
    kinds.push_back({.name = "xor",
                     .form = Form::operands,
                     .help = "Exclusive or: everything that is in an odd number of children.",
                     .fields = fields,
                     .exactness = Exactness::bound,
                     .combine = SCENE_COMBINE(sceneXor(a, b, V(1), int(V(0)))),
                     .share = SCENE_COMBINE(sceneXorShare(a, b, V(1), int(V(0)))),
                     .childLevel = levelOfOperand,
                     .extentOfTwo = joinedExtent});
    kinds.push_back(
        {.name = "morph",
         .form = Form::pair,
         .help = "A shape between the first child and the second.",
         .fields = {plain("share", 0.5, 0, 1, "Position between the children: 0 is the first, 1 is the second.")},
         .exactness = Exactness::bound,
         .combine = SCENE_COMBINE(sdfMix(a, b, V(0))),
         .share = SCENE_COMBINE(sceneMixShare(V(0))),
         .extentOfTwo = joinedExtent});
    return kinds;
}

std::vector<NodeKind> modifierKinds()
{
    std::vector<NodeKind> kinds;
    addReshaping(kinds);
    addDistorting(kinds);
    return kinds;
}

std::vector<NodeKind> repeaterKinds()
{
    std::vector<NodeKind> kinds;
    const Field spacing{
        "spacing", FieldType::vector, Unit::meter,
        0,         largestSize,       0,
        4,         {1, 0, 0},         "Distance between copies along x, y and z; 0 does not repeat along that axis."};
    const Field copies{"count",
                       FieldType::counts,
                       Unit::none,
                       0,
                       1e6,
                       0,
                       32,
                       {3, 1, 1},
                       "Number of copies along x, y and z; 0 is infinitely many."};
    kinds.push_back({.name = "repeat",
                     .form = Form::repeater,
                     .help = "Copies of the child on a grid around the origin.",
                     .fields = {spacing, copies},
                     .exactness = Exactness::exactOutside,
                     .copy = SCENE_COPY(sceneRepeated(p, i, V3(0), V3(3), V3(6), V3(9))),
                     .extentOf = repeatedExtent,
                     .asked = askedCells,
                     .fault = [](const double* v) {
                         for (int i = 0; i < 3; ++i)
                             if (v[i] > 0 && v[i] < smallestSize)
                                 return std::string("the copies are nearer than 0.1 mm; give a larger spacing, or 0");
                         return std::string();
                     }});
    kinds.push_back({.name = "repeatAround",
                     .form = Form::repeater,
                     .help = "Copies of the child around the y axis; the first is the child itself.",
                     .fields = {count("count", 6, 1, 1e4, "Number of copies.")},
                     .exactness = Exactness::exactOutside,
                     .copy = SCENE_COPY(sceneRepeatedAround(p, i, V(0), V(1))),
                     .extentOf = turnedExtent,
                     .asked = askedAround});
    return kinds;
}

}  // namespace vitrine::scenes
