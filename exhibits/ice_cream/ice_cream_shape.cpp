#include "exhibits/ice_cream/ice_cream_shape.h"

#include "exhibits/ice_cream/ice_cream_cpu.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::ice_cream {
namespace {

using glm::dvec3;
using glm::dvec4;

constexpr double pi = std::numbers::pi;
constexpr double plinthRadius = iceCreamPlinthRadius, plinthHeight = iceCreamPlinthHeight, plinthRounding = 0.012;
constexpr int waferParts = 1 << PART_FOOT | 1 << PART_COLLAR | 1 << PART_BOWL | 1 << PART_RINGS | 1 << PART_BARS;
constexpr int allCandies = ((1 << candyCount) - 1) << PART_CANDY;

/// Returns a vector rotated about the y axis, with the sign of the reference's matrix.
dvec3 turned(const dvec3& v, double yaw)
{
    return {std::cos(yaw) * v.x + std::sin(yaw) * v.z, v.y, std::cos(yaw) * v.z - std::sin(yaw) * v.x};
}

/// Returns radius, center height and half height of a cylinder around the y axis. It is the smallest that contains a
/// rounded cone at any rotation about that axis, grown by `slack`.
dvec4 hullOf(const dvec3& foot, const dvec3& tip, double radius, double corner, double slack)
{
    // The base is a disk perpendicular to the cone's axis; its slant determines its height.
    const dvec3 axis = glm::normalize(tip - foot);
    const double rise = radius * std::sqrt(std::max(1 - axis.y * axis.y, 0.0));
    const double low = std::min(foot.y - rise, tip.y) - corner - slack;
    const double high = std::max(foot.y + rise, tip.y) + corner + slack;
    const double outer = std::max(std::hypot(foot.x, foot.z) + radius, std::hypot(tip.x, tip.z)) + corner + slack;
    return {outer, 0.5 * (low + high), 0.5 * (high - low), 0};
}

/// Returns a layer of cream. Features of stages after `stage` are left out.
glsl::CreamLayer layerOf(const CreamParameters& rows, const ParameterValues& values, double rim, int stage,
                         double slack)
{
    glsl::CreamLayer layer{};
    const double height = values[rows.height], radius = values[rows.radius];
    // Corners are limited, so something of the cone is left.
    const double corner = stage < STAGE_ROUND ? 0 : std::min({values[rows.corner], 0.45 * height, 0.95 * radius});
    const double length = height - 2 * corner;
    layer.corner = corner;
    layer.radius = radius - corner;
    layer.halfHeight = 0.5 * length;
    layer.lobes = stage < STAGE_REPEATED ? 1 : values[rows.lobes];
    layer.twist = stage < STAGE_TWIST ? 0 : values[rows.twist];
    layer.blend = stage < STAGE_JOINED ? 0 : values[rows.blend];
    layer.color = values[rows.color].value;
    layer.foot = {values[rows.offsetX], rim + values[rows.raise], values[rows.offsetZ]};
    const double tilt = values[rows.tilt];
    layer.axis = turned({0, std::cos(tilt), std::sin(tilt)}, values[rows.yaw]);
    const dvec3 tip = layer.foot + layer.axis * length;
    // The smallest ball around base and tip has its center at equal distance from both, but not below the base.
    const double along = std::max(0.5 * (length * length - layer.radius * layer.radius) / length, 0.0);
    const double reach = std::max(length - along, std::hypot(along, layer.radius)) + corner;
    layer.ball = layer.foot + layer.axis * along;
    layer.ballRadius = reach + 1e-6;  // Rounding.
    layer.ballAngle = std::atan2(layer.ball.z, layer.ball.x);
    layer.hull = hullOf(layer.foot, tip, layer.radius, corner, slack + 0.25 * layer.blend);
    return layer;
}

/// Returns random orientation `number`, uniform over all: Shoemake 1992, "Uniform Random Rotations"; 0 is upright.
glm::dquat tumbled(int number)
{
    if (number == 0) return {1, 0, 0, 0};
    const glm::uvec3 bits = glsl::pcg3d(glm::uvec3(static_cast<std::uint32_t>(number), 17U, 99U));
    const double u = glsl::unitFromBits(bits.x);
    const double a = 2 * pi * glsl::unitFromBits(bits.y), b = 2 * pi * glsl::unitFromBits(bits.z);
    return {std::sqrt(u) * std::cos(b), std::sqrt(1 - u) * std::sin(a), std::sqrt(1 - u) * std::cos(a),
            std::sqrt(u) * std::sin(b)};
}

/// Returns candy number `index` at `time` seconds. The index determines the axis of its spin, and the pace and phase of
/// its bobbing.
glsl::Candy candyOf(const CandyParameters& rows, const ParameterValues& values, std::size_t index, double time)
{
    constexpr double pace[3]{0.15, 0.13, 0.17};  // Radians per second, from the reference.
    glsl::Candy candy{};
    const std::size_t axis = (index + 2) % 3;
    candy.center = {values[rows.x], values[rows.y], values[rows.z]};
    const double phase = std::fmod(pace[axis] * time, 2 * pi);
    candy.center.y += values[rows.bob] * (time == 0 ? 0 : axis == 1 ? std::cos(phase) : std::sin(phase));
    dvec3 about(0);
    about[static_cast<int>(axis)] = 1;
    const glm::dquat turn =
        tumbled(values[rows.tumble]) * glm::angleAxis(std::fmod(values[rows.spin] * candySpin(time), 2 * pi), about);
    candy.axisX = turn * dvec3(1, 0, 0);
    candy.axisY = turn * dvec3(0, 1, 0);
    candy.halfSize = {values[rows.halfX], values[rows.halfY], values[rows.halfZ]};
    candy.corner = values[rows.corner];
    candy.reach = glm::length(candy.halfSize);
    candy.color = values[rows.color].value;
    return candy;
}

int partsShown(IceCreamParts show)
{
    switch (show) {
    case IceCreamParts::all: return ~0;
    case IceCreamParts::foot: return 1 << PART_FOOT;
    case IceCreamParts::collar: return 1 << PART_COLLAR;
    case IceCreamParts::bowl: return 1 << PART_BOWL;
    case IceCreamParts::rings: return 1 << PART_RINGS;
    case IceCreamParts::bars: return 1 << PART_BARS;
    case IceCreamParts::lower: return 1 << PART_CREAM;
    case IceCreamParts::upper: return 2 << PART_CREAM;
    case IceCreamParts::candies: return allCandies;
    case IceCreamParts::sprinkles: return 1 << PART_SPRINKLES;
    }
    return ~0;
}

/// Returns the parts that exist at a stage.
int partsOfStage(int stage)
{
    int parts = 1 << PART_PLINTH;
    for (int part = PART_FOOT; part <= PART_BARS; ++part)
        if (stage >= STAGE_FOOT + part) parts |= 1 << part;
    if (stage >= STAGE_CONE) parts |= 1 << PART_CREAM;
    if (stage >= STAGE_UPPER) parts |= 2 << PART_CREAM;
    if (stage >= STAGE_CANDIES) parts |= allCandies | 1 << PART_SPRINKLES;
    return parts;
}

void addWafer(const IceCreamParameters& t, const ParameterValues& values, int stage, glsl::IceCreamShape& s)
{
    const double foot = values[t.footHeight];
    s.foot = {values[t.footRadius], values[t.footTop], foot, 0};
    const double top = foot + values[t.collarHeight];
    s.collar = {values[t.collarRadius], values[t.collarTop], foot, top};
    const double ball = values[t.bowlRadius];
    const double bottom = std::min(values[t.bowlBottom], ball);
    const double rim = std::clamp(values[t.bowlTop], bottom, ball);
    const double center = top + std::sqrt(ball * ball - bottom * bottom);
    s.bowl = {ball, center, top, center - std::sqrt(ball * ball - rim * rim)};
    s.rings = values[t.rings];
    s.ringTube = values[t.ringTube];
    s.bars = values[t.bars];
    s.barRadius = values[t.barRadius];
    s.reliefBlend = stage < STAGE_WAFER ? 0 : values[t.reliefBlend];
    s.footBlend = stage < STAGE_WAFER ? 0 : values[t.footBlend];
    const double relief = std::max(s.ringTube, s.barRadius) + 0.25 * (s.reliefBlend + s.footBlend);
    const double outer = std::max({std::max(s.foot.x, s.foot.y) + relief, s.collar.x, s.collar.y, rim});
    const double low = -relief, high = std::max(s.bowl.w, foot + relief);
    s.waferHull = {outer, 0.5 * (low + high), 0.5 * (high - low), 0};
}

}  // namespace

double candySpin(double time)
{
    return 0.07 * time + 0.05 * std::sin(std::fmod(time, 2 * pi));
}

IceCreamStage stageAt(const IceCreamParameters& t, const ParameterValues& values, double time)
{
    if (!values[t.buildUp] || !std::isfinite(time)) return values[t.stage];
    constexpr double stages = static_cast<double>(IceCreamStage::finished) + 1;
    // The last stage, the finished ice cream, is shown twice as long as the others.
    const double count = std::fmod(std::max(time, 0.0) / values[t.stageTime], stages + 1);
    return static_cast<IceCreamStage>(static_cast<int>(std::min(count, stages - 1)));
}

IceCreamShape iceCreamShape(const IceCreamParameters& t, const ParameterValues& values, double time)
{
    const double now = values[t.animate] && std::isfinite(time) ? time : 0;
    glsl::IceCreamShape s{};
    s.stage = static_cast<int>(stageAt(t, values, time));
    addWafer(t, values, s.stage, s);
    s.layerBlend = s.stage < STAGE_LAYERS ? 0 : values[t.layerBlend];
    s.waferBlend = s.stage < STAGE_LAYERS ? 0 : values[t.waferBlend];
    const double rim = s.bowl.w;
    for (std::size_t i = 0; i < creamLayerCount; ++i) {
        s.layers[i] = layerOf(t.layers[i], values, rim, s.stage, 0.25 * s.layerBlend);
        s.steepest = std::max(s.steepest, std::abs(s.layers[i].twist));
        s.outermost = std::max(s.outermost, s.layers[i].hull.x + s.waferBlend);
    }
    for (std::size_t i = 0; i < candyCount; ++i) s.candies[i] = candyOf(t.candies[i], values, i, now);
    s.plinth = {plinthRadius, plinthHeight, plinthRounding, 0};
    s.parts = partsShown(values[t.show]) & partsOfStage(s.stage);
    if (values[t.show] != IceCreamParts::all) s.parts &= ~(1 << PART_PLINTH);
    if (!values[t.plinth]) s.parts &= ~(1 << PART_PLINTH);
    if (values[t.lighting] == IceCreamLighting::reference) s.parts &= ~(1 << PART_PLINTH);
    if (values[t.sprinkles] == 0) s.parts &= ~(1 << PART_SPRINKLES);
    s.sprinkleRadius = 0.5 * values[t.sprinkleThickness];
    s.sprinkleReach = 0.5 * values[t.sprinkleLength] + 2 * s.sprinkleRadius;
    IceCreamShape rounded;
    copyShape(rounded, s);
    return rounded;
}

render::Box boxOf(const IceCreamShape& s)
{
    render::Box box;
    const auto include = [&box](const dvec4& hull, double slack) {
        const double r = hull.x + slack;
        box.include({-r, hull.y - hull.z - slack, -r});
        box.include({r, hull.y + hull.z + slack, r});
    };
    const double bulge = 0.25 * double{s.waferBlend} + 1e-4;
    const bool sprinkled = (s.parts >> PART_SPRINKLES & 1) != 0;
    if ((s.parts & waferParts) != 0) include(dvec4(s.waferHull), bulge);
    for (std::size_t i = 0; i < creamLayerCount; ++i)
        if (sprinkled || (s.parts >> (PART_CREAM + static_cast<int>(i)) & 1) != 0)
            include(dvec4(s.layers[i].hull), bulge + (sprinkled ? double{s.sprinkleReach} : 0));
    for (std::size_t i = 0; i < candyCount; ++i) {
        if ((s.parts >> (PART_CANDY + static_cast<int>(i)) & 1) == 0) continue;
        box.include(dvec3(s.candies[i].center) - double{s.candies[i].reach});
        box.include(dvec3(s.candies[i].center) + double{s.candies[i].reach});
    }
    if ((s.parts >> PART_PLINTH & 1) != 0) include({plinthRadius, -0.5 * plinthHeight, 0.5 * plinthHeight, 0}, 1e-4);
    if (!(box.low.x <= box.high.x)) include({0.01, 0, 0.01, 0}, 0);
    return box;
}

render::Box boxOverTime(const IceCreamParameters& t, const ParameterValues& values)
{
    if (!values[t.animate] && !values[t.buildUp]) return boxOf(iceCreamShape(t, values, 0));
    ParameterValues finished = values;
    render::Box box;
    const auto include = [&box](const render::Box& other) {
        if (!(other.low.x <= other.high.x)) return;
        box.include(other.low);
        box.include(other.high);
    };
    finished.set(t.buildUp, false);
    for (const IceCreamStage stage : {IceCreamStage::cone, IceCreamStage::repeated, IceCreamStage::finished}) {
        if (!values[t.buildUp] && stage != IceCreamStage::finished) continue;
        finished.set(t.stage, values[t.buildUp] ? stage : values[t.stage]);
        include(boxOf(iceCreamShape(t, finished, 0)));
    }
    if (!values[t.animate]) return box;
    double bob = 0;
    for (const CandyParameters& candy : t.candies) bob = std::max(bob, values[candy.bob]);
    box.low.y -= bob;
    box.high.y += bob;
    return box;
}

}  // namespace vitrine::ice_cream
