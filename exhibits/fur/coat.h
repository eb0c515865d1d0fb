#pragma once

#include "exhibits/fur/fur_table.h"
#include "render/glsl/std140.h"
#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <vector>

namespace vitrine::fur {

// Sizes of the skins and of the pit, meters. A test compares the pit's to the hall's node "pit_3". Its leather padding
// is modeled in assets/models/hall_props.py.
inline constexpr double ballRadius = 0.33;
inline constexpr double rollRadius = 0.22, rollHalfLength = 0.26;
inline constexpr double ringRadius = 0.35, ringTube = 0.15;
inline constexpr double pitRadius = 1.6, pitRim = 0.35;
inline constexpr double pitPadRadius = 0.145, pitPadLift = 0.04;  ///< Leather tube around the rim.

/// Pose of a body and lag of its fur at one time. Pit space: origin at the center of the pit's floor, y up.
struct FurState {
    glm::dvec3 position{0};
    glm::dquat rotation{1, 0, 0, 0};     ///< Pit from body.
    double skinScale = 1;                ///< Radius of the skin relative to rest.
    glm::dvec3 tipOffset{0};             ///< Displacement of the tips, strand lengths.
    glm::dquat tipRotation{1, 0, 0, 0};  ///< Rotation by which the tips lag behind the body.
};
using FurStates = std::array<FurState, furBodyCount>;

#include "shaders/fur/body_block.glsl"
static_assert(FUR_BODIES == furBodyCount);

/// Coats of the three bodies at one time, ready to be drawn.
struct Coats {
    const FurTable& table;
    const ParameterValues& values;
    FurStates states;
    glm::dmat4 worldFromPit{1};
    double time = 0;
    std::uint32_t seed = 1;
    /// Radius in meters of the ball that approximates the user's model in place of the ring; 0: no model.
    double modelRadius = 0;

    [[nodiscard]] FurBody body(int index) const;
    /// Half space dot(normal, p) > distance in pit space, in which fur is free. Beyond it, fur is pressed flat.
    struct FreeSide {
        glm::dvec3 normal{0, 1, 0};
        double distance = 0;
    };
    /// Returns the half spaces that the surroundings leave free for a body; the one above the ground comes first.
    [[nodiscard]] std::vector<FreeSide> freeSides(int index) const;
    /// Returns the thickness of a body around its spine, meters.
    [[nodiscard]] double radius(int index) const;
    /// Returns the point of the body's spine nearest to `p`, pit space.
    [[nodiscard]] glm::dvec3 spinePoint(int index, const glm::dvec3& p) const;
    [[nodiscard]] glm::dmat4 worldFromBody(int index) const;
    /// Returns the space that a body with its fur may fill, in body space. `skin` is the bounds of its skin at rest.
    [[nodiscard]] render::Box space(int index, const render::Box& skin) const;
    /// Returns the bounds of `space` in world space.
    [[nodiscard]] render::Box bounds(int index, const render::Box& skin) const;
};

/// Returns the number of shells for a coat of `length` meters at `distance` meters: one for each 4.5 pixels of its
/// length, each of `pixelAngle` radians. The number decreases continuously from `wanted`, but not below 5.
[[nodiscard]] double shellsAtDistance(int wanted, double length, double distance, double pixelAngle);

/// Returns the radius in meters of the sphere, roll or tube that collides: the current skin, and the part of the fur
/// that contact does not flatten.
[[nodiscard]] double colliderRadius(const FurTable&, const ParameterValues&, int body, double skinScale);

}  // namespace vitrine::fur
