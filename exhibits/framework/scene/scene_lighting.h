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

/// Shadow maps of the local lights; render::LocalLighting gives the layers of each light.
inline constexpr const char* localShadowImage = "shadow.local";
/// The reflection probe with the works behind openings in the walls, for mirrors.
inline constexpr const char* mirroredWorksImage = "probe.mirrored";

#include "shaders/lib/light_block.glsl"

/// Upper bound on the radiance of a surface, for irradiance 1: its diffuse share, plus the limit of the highlight in
/// lib/surface.glsl.
inline constexpr double mostReflected = 1 / std::numbers::pi + 64;

/// Returns an upper bound on the radiance of surfaces by these lights. Surfaces must not be nearer to a lamp than the
/// near plane of its shadow maps.
[[nodiscard]] double mostRadianceBy(const render::LocalLighting&);

/// Light that falls on objects in the hall (or alone in its environment): everything an exhibit needs to be lit like
/// its surroundings, and to cast its shadow.
struct SceneLighting {
    LightBlock light;                         ///< Uniform block for shaders; the members below are used for planning.
    int background = BACKGROUND_SKY;          ///< BACKGROUND_ of shaders/lib/light_block.glsl.
    int shadowFilter = SHADOW_FILTER_TENT_5;  ///< SHADOW_FILTER_, likewise.
    std::vector<render::SampledTexture> inputs;  ///< Shadow maps, probe, environment picture.

    glm::dvec3 towardsSun{0, 1, 0};  ///< Unit.
    glm::dvec3 sunIrradiance{0};     ///< On a plane that faces the sun; scene-linear.
    double exposure = 1;             ///< Factor from radiance to the tone mapper's input.
    double adaptation = 1;           ///< The same without the user's exposure correction.

    /// Lamps of the frame; unset if no lamp shines. Their shadow maps are in the image "shadow.local".
    std::optional<render::LocalLighting> localLights;

    /// Openings through which the sun shines into the hall and the sky is visible: each flat along one axis. World
    /// space; none without a hall.
    std::vector<render::Box> openings;
    render::Box room;                     ///< Air between walls, floor and vault; empty without a hall.
    std::optional<render::Box> building;  ///< Contains all surfaces of the hall; unset without a hall.

    /// Bounds on the effect of the sun's shadows on a surface, and of the probe's light in reflections.
    render::ContributionBound sunShadow, probeLight;
    /// Bound on the sunlight that walls and floor bounce, where it arrives; and whether its map is drawn.
    render::ContributionBound bouncedLight;
    bool hasBouncedLight = false;
    /// Bound on the light of the lamps in the hall's vault, and whether any pass reads that light.
    render::ContributionBound lampLight;
    bool hasLampLight = false;
    /// Upper bound on the radiance from all directions except the sun's; scene-linear, before exposure.
    double brightest = 0;

    /// Strength of the sun relative to the initial value of the hall's parameter.
    double sunShare = 1;

    /// View of the sun for the shadow map "shadow.hall" of walls and furniture. Valid while `hallCastsShadow`.
    render::View hallShadowView;
    bool hallCastsShadow = false;
    /// View of the sun for the shadow map "shadow.exhibits" of the exhibits. Valid while `light.exhibitsCastShadow`.
    render::View exhibitShadowView;
    /// Glass is in the sunlight: its transmittance is in the image "shadow.glass", in the same view.
    bool glassCastsShadow = false;
    /// Hash of everything that the exhibits' shadows depend on: the key of every pass that draws into that map, so that
    /// either all of them run, or none.
    std::uint64_t exhibitShadowKey = 0;

    /// The works behind openings in the walls are in the image "probe.mirrored", which is otherwise the probe.
    bool hasMirroredWorks = false;

    /// Bound on the sunlight that surfaces in a box (world space) send to the eye: 0 if `mayBeSunlit` of
    /// shaders/lib/light.glsl is false at every place of it.
    [[nodiscard]] render::ContributionBound sunlightIn(const render::Box&) const;
    /// Gives a pass the light block and all textures that shaders/lib/light.glsl samples.
    void bindLight(render::Pass&) const;
    /// The same, and the local lights. The pass shades places within the building; one that shades others, or knows
    /// more closely which, sets `Pass::shaded`.
    void bindLighting(render::Pass&) const;
    /// Makes a pass with `bindLighting`, which draws a mirror, reflect the works behind openings in the walls, if there
    /// are any in this frame.
    void mirrorWorks(render::Pass&) const;
};

/// Returns the axis along which an opening is flat: 0, 1 or 2.
[[nodiscard]] int flatAxis(const render::Box& opening);

/// Returns the transform from world space to texture coordinates and depth in [0, 1] of a shadow map drawn with `view`.
[[nodiscard]] glm::mat4 shadowFromWorld(const render::View& view);

/// Returns an orthographic view along the light that contains `box`; receivers up to `reach` meters behind the box are
/// still in its depth range. `towardsLight` is unit length; `size` is the map's, in texels.
[[nodiscard]] render::View lightView(const render::Box& box, const glm::dvec3& towardsLight, glm::ivec2 size,
                                     double reach);

/// The same, but stable if the box changes a little. Texel widths are powers of 2^(1/4) millimeters on a fixed grid,
/// whatever the box, so that shadows of static objects do not shimmer.
[[nodiscard]] render::View steadyLightView(const render::Box& box, const glm::dvec3& towardsLight, glm::ivec2 size,
                                           double reach);

/// Linear Rec. 709 color of a black body, its largest component 1; `kelvin` is clamped to [1000, 25000].
/// Kim et al. 2002 (US patent 7,024,034) for the locus in CIE xy.
[[nodiscard]] glm::dvec3 blackBodyColor(double kelvin);

}  // namespace vitrine
