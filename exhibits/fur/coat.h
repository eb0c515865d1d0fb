#pragma once

#include "exhibits/fur/fur_table.h"
#include "render/glsl/std140.h"
#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <vector>

namespace vitrine {

// Sizes of the bodies' skins and of their pit, meters. A test holds the pit's to the hall's node "pit_3"; its leather
// is that of assets/models/hall_props.py.
inline constexpr double ballRadius = 0.33;
inline constexpr double rollRadius = 0.22, rollHalfLength = 0.26;
inline constexpr double ringRadius = 0.35, ringTube = 0.15;
inline constexpr double pitRadius = 1.6, pitRim = 0.35;
inline constexpr double pitPadRadius = 0.145, pitPadLift = 0.04;  ///< The leather tube around it.

/// Where a body is and how its fur hangs back, at one moment. Pit space: the middle of the pit's floor, y up.
struct FurState {
    glm::dvec3 position{0};
    glm::dquat rotation{1, 0, 0, 0};     ///< Pit from body.
    double skinScale = 1;                ///< Skin over skin at rest.
    glm::dvec3 tipOffset{0};             ///< Where the tips are drawn, strand lengths.
    glm::dquat tipRotation{1, 0, 0, 0};  ///< By how much the tips have turned less than the body.
};
using FurStates = std::array<FurState, furBodyCount>;

#include "shaders/fur/body_block.glsl"
static_assert(FUR_BODIES == furBodyCount);

/// A coat at one moment, ready to be drawn.
struct Coats {
    const FurTable& table;
    const ParameterValues& values;
    FurStates states;
    glm::dmat4 worldFromPit{1};
    double time = 0;
    std::uint32_t seed = 1;
    double modelRadius =
        0;  ///< Meters: of a ball that stands for the visitor's model in place of the ring; 0: there is none.

    [[nodiscard]] FurBody body(int index) const;
    /// Pit space: fur is free to be where dot(normal, p) > distance, and pressed flat beyond.
    struct FreeSide {
        glm::dvec3 normal{0, 1, 0};
        double distance = 0;
    };
    /// Of what lies around a body: the ground first.
    [[nodiscard]] std::vector<FreeSide> freeSides(int index) const;
    /// How thick a body is around its spine, meters.
    [[nodiscard]] double radius(int index) const;
    /// The point of the body's spine nearest to `p`, pit space.
    [[nodiscard]] glm::dvec3 spinePoint(int index, const glm::dvec3& p) const;
    [[nodiscard]] glm::dmat4 worldFromBody(int index) const;
    /// The space that a body with its fur may fill, in its own space; `skin`: bounds of the skin at rest.
    [[nodiscard]] render::Box space(int index, const render::Box& skin) const;
    /// The same in the world.
    [[nodiscard]] render::Box bounds(int index, const render::Box& skin) const;
};

/// How many shells a coat of `length` meters is given, `distance` meters away: all of `wanted` while the coat
/// spans eight pixels for each (of `pixelAngle` radians), continuously fewer after that, never under 5 of them.
[[nodiscard]] double shellsAtDistance(int wanted, double length, double distance, double pixelAngle);

/// Radius of the sphere, roll or tube that collides: the skin at its present size, and what of the fur the
/// contact does not flatten.
[[nodiscard]] double colliderRadius(const FurTable&, const ParameterValues&, int body, double skinScale);

}  // namespace vitrine
