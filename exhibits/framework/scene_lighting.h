#pragma once

#include "render/glsl/std140.h"
#include "render/plan/frame_plan.h"
#include "render/plan/local_lights.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace vitrine {

/// Shadow maps of the local lights: render::LocalLighting says whose layers are whose.
inline constexpr const char* localShadowImage = "shadow.local";

#include "shaders/lib/light_block.glsl"

/// Radiance that a surface sends at most, for irradiance 1: its diffuse share, and the peak at which lib/surface.glsl
/// stops.
inline constexpr double mostReflected = 1 / std::numbers::pi + 64;

/// No surface sends more radiance of their light, as long as it is no nearer to a lamp than its shadow maps begin.
[[nodiscard]] double mostRadianceBy(const render::LocalLighting&);

/// The light that falls on whatever stands in the hall (or alone in its environment): what an exhibit
/// needs to be lit like everything around it, and to cast its shadow.
struct SceneLighting {
    LightBlock light;                            ///< What shaders read; the numbers below are what plans are made by.
    int background = BACKGROUND_SKY;             ///< BACKGROUND_ of shaders/lib/light_block.glsl.
    int shadowFilter = SHADOW_FILTER_TENT_5;     ///< SHADOW_FILTER_, likewise.
    std::vector<render::SampledTexture> inputs;  ///< Shadow maps, probe, environment picture.

    glm::dvec3 towardsSun{0, 1, 0};  ///< Unit.
    glm::dvec3 sunIrradiance{0};     ///< On a plane that faces the sun; scene-linear.
    double exposure = 1;             ///< Radiance times this is what the film sees.
    double adaptation = 1;           ///< The same before the visitor's own correction of the exposure.

    /// Of the lamps in the frame; none where no lamp shines. Their shadow maps are in the image "shadow.local".
    std::optional<render::LocalLighting> localLights;

    /// Through these the sun shines into the hall and the sky is seen: each flat along one axis. World space;
    /// none when there is no hall.
    std::vector<render::Box> openings;
    render::Box room;  ///< The air between walls, floor and vault; empty when there is no hall.

    /// Of the shadows that the sun throws on a surface, and of what surfaces see in the probe.
    render::ContributionBound sunShadow, probeLight;
    /// Of the sun's light that walls and floor bounce, on what it falls on; and whether its map is drawn.
    render::ContributionBound bouncedLight;
    bool hasBouncedLight = false;
    /// Of the lamps in the hall's vault, and whether anything reads their light.
    render::ContributionBound lampLight;
    bool hasLampLight = false;
    /// No direction but the sun's own sends more radiance than this; scene-linear, before exposure.
    double brightest = 0;

    /// The sun's strength against the one that the hall's table begins with.
    double sunShare = 1;

    /// The sun's view of walls and furniture, for their shadow map "shadow.hall". Meaningful while `hallCastsShadow`.
    render::View hallShadowView;
    bool hallCastsShadow = false;
    /// The sun's view of the exhibits, for their shadow map "shadow.exhibits". Meaningful while
    /// `light.exhibitsCastShadow`.
    render::View exhibitShadowView;
    /// Glass stands in the sun: what it lets through is in the image "shadow.glass", in the same view.
    bool glassCastsShadow = false;
    /// Changes whenever any exhibit's shadow may: the key of every pass that draws into that map, so that all
    /// of them run, or none.
    std::uint64_t exhibitShadowKey = 0;

    /// Gives a pass the light block and everything that shaders/lib/light.glsl samples.
    void bindLighting(render::Pass&) const;
};

/// The axis along which an opening is flat: 0, 1 or 2.
[[nodiscard]] int flatAxis(const render::Box& opening);

/// Texture coordinates and depth in [0, 1] from world space, for a shadow map drawn with `view`.
[[nodiscard]] glm::mat4 shadowFromWorld(const render::View& view);

/// An orthographic view along the light that holds `box`; receivers up to `reach` meters behind the box
/// are still in its depth range. `towardsLight` is unit length; `size` is the map's, in texels.
[[nodiscard]] render::View lightView(const render::Box& box, const glm::dvec3& towardsLight, glm::ivec2 size,
                                     double reach);

/// The same, standing still while the box changes a little: texels are a power of 2^(1/4) millimeters wide and lie on
/// one grid, whatever the box, so that shadows of what did not move do not swim.
[[nodiscard]] render::View steadyLightView(const render::Box& box, const glm::dvec3& towardsLight, glm::ivec2 size,
                                           double reach);

/// Linear Rec. 709 color of a black body, its largest component 1; `kelvin` is clamped to [1000, 25000].
/// Kim et al. 2002 (US patent 7,024,034) for the locus in CIE xy.
[[nodiscard]] glm::dvec3 blackBodyColor(double kelvin);

}  // namespace vitrine
