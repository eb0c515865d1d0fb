#include "exhibits/hall/hall_scene.h"

#include "exhibits/framework/table/derive.h"
#include "exhibits/hall/sun.h"
#include "exhibits/hall/walk.h"
#include "exhibits/kit/clear_sky.h"
#include "exhibits/kit/sky_view.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace vitrine::hall {
namespace {

/// Exposures: in the hall, at which plaster in the shade of the initial light is a little below middle gray, as one
/// exposes for a room with a patch of sunlight, and in the studio.
constexpr double hallExposure = 7.5;
constexpr double studioExposure = 1.04;
/// Stops by which the exposure of the hall rises at dusk, together with its lamps.
constexpr double nightStops = 0.4;

/// Conservative test of whether the box, swept towards the light, overlaps the opening. Light enters from outside: from
/// above, or through a wall from its outer side.
bool passesThrough(const render::Box& box, const glm::dvec3& towardsLight, const render::Box& opening,
                   const render::Box& room)
{
    const int axis = flatAxis(opening);
    const double along = towardsLight[axis];
    if (!(along * (opening.center()[axis] - room.center()[axis]) > 0 && std::abs(along) > 1e-4)) return false;
    const double plane = opening.center()[axis];
    double low[2] = {1e30, 1e30};
    double high[2] = {-1e30, -1e30};
    const int axes[2] = {(axis + 1) % 3, (axis + 2) % 3};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                           (corner & 4) != 0 ? box.high.z : box.low.z);
        const double t = (plane - p[axis]) / along;
        if (!(t > 0)) return true;  // The corner is beside or beyond the opening, so the test stays conservative.
        for (int i = 0; i < 2; ++i) {
            const double x = p[axes[i]] + t * towardsLight[axes[i]];
            low[i] = std::min(low[i], x);
            high[i] = std::max(high[i], x);
        }
    }
    return high[0] >= opening.low[axes[0]] && low[0] <= opening.high[axes[0]] && high[1] >= opening.low[axes[1]] &&
           low[1] <= opening.high[axes[1]];
}

/// Upper bound of ambient light from nine coefficients of light up to 1: the integral of the absolute value of their
/// kernel is 1.07.
constexpr double mostAmbient = 1.1;
/// Radiance of the studio in lib/sky.glsl if its room and all its lamps overlapped.
constexpr double brightestOfStudio = 14;

render::ContributionBound shadowBound(const Sun& sun)
{
    return render::boundOf(0, mostReflected,
                           {{sun.strength, sun.elevation > 0 ? "the sun's strength is 0" : "the sun has set"}});
}

render::ContributionBound lampBound(const HallScene& scene, const VaultLamps& lamps)
{
    const double most = std::max({lamps.radiance.x, lamps.radiance.y, lamps.radiance.z});
    return render::boundOf(0, 2 * mostAmbient * most,
                           {{scene.alone ? 0.0 : 1.0, "there is no hall"}, {most, lamps.whyDark}});
}

double largest(const glm::vec3& color)
{
    return std::max({color.x, color.y, color.z});
}

/// Returns an upper bound of the radiance of sky, panorama and studio, and of the walls lit by them and by the sun.
/// `skyBrightest` is the largest radiance of the clear sky, `bounced` the largest bounced light in the air for a sun of
/// irradiance 1.
double brightestAround(const HallScene& scene, const LightBlock& light, double skyBrightest, double bounced)
{
    if (scene.alone) return scene.environment ? scene.environmentBrightest : brightestOfStudio;
    const double sky = std::max({largest(light.skyZenith), largest(light.skyHorizon), skyBrightest}) +
                       0.35 * largest(light.skySunward);
    const double sun = largest(light.sunIrradiance);
    // The sky's lightmap contains 0 to 1 times its scale. Around the sun the sky glows (lib/sky.glsl).
    const double baked = sky * static_cast<double>(light.skyLightmapScale) + sun * bounced;
    return std::max(scene.environment ? scene.environmentBrightest : sky + 0.35 * sun, baked + mostReflected * sun);
}

/// Returns the light of the clear sky outside. Set by angles, a sky is as bright under any sun; by the hour, it dims.
SkySource skySource(const HallScene& scene, const Sun& sun)
{
    /// Scale that makes the sky in the window as bright as the light that falls in from it.
    constexpr double perStrength = 14;
    constexpr double initialTemperature = 9500;
    constexpr double hazeOutside = 5;  // It makes the sky around a low sun glow.
    const glm::dvec3 luminance(0.2126, 0.7152, 0.0722);
    const HallTable& table = scene.table;
    const ParameterValues& values = scene.values;
    SkySource source{.sunElevation = sun.elevation, .haze = hazeOutside};
    source.sun = blackBodyColor(values[table.skyTemperature]) / blackBodyColor(initialTemperature) *
                 (perStrength * values[table.skyStrength]);
    if (values[table.sunBy] == SunBy::hour) {
        // Eyes that have adapted to the lamps see the evening sky darker, and its colors deeper.
        source.sun *= 1 - 0.65 * lampsShareAt(sun.elevation);
        source.night = moonlitSky * source.sun * 0.05;
        return source;
    }
    const auto around = [&](double elevation) {
        const ClearSky sky(elevation, hazeOutside);
        return glm::dot(luminance, sky.radiance(0.2, 0.4) + sky.radiance(0.2, 1.6));
    };
    source.sun *= around(referenceSunElevation) / around(sun.elevation);
    return source;
}

/// Returns the exposure to which the eye is adapted: in the hall, or in the studio.
double adaptationOf(const HallScene& scene, const Sun& sun)
{
    if (scene.alone) return studioExposure;
    return hallExposure * std::exp2(nightStops * lampsShareAt(sun.elevation));
}

/// Returns sun, sky, exposure and filters as shaders read them, without shadow map and probe.
LightBlock lightBlock(const HallScene& scene, const Sun& source)
{
    const HallTable& table = scene.table;
    const ParameterValues& values = scene.values;
    const glm::dvec3 sunColor = source.irradiance();
    const glm::dvec3 skyColor = blackBodyColor(values[table.skyTemperature]) * values[table.skyStrength];
    LightBlock light;
    light.sunDirection = glm::vec3(source.towards());
    light.sunIrradiance = glm::vec3(sunColor);
    const SkyTint sky = skyOf(table, values, source);
    light.skyZenith = glm::vec3(skyColor * sky.zenith * 0.8);
    light.skyLightmapScale = static_cast<float>(scene.model.surfaces().skyScale());
    if (!scene.alone)
        light.lampsOnWalls =
            glm::vec3(vaultLampsOf(table, values).radiance * scene.model.surfaces().lightmaps().lamps.surfaceScale());
    light.skyHorizon = glm::vec3(glm::mix(skyColor * sky.horizon, sunColor / 9.0, 0.25) * 1.25);
    light.skySunward = glm::vec3(skyColor * sky.sunward * 1.25);
    light.environmentRotation = static_cast<float>(values[table.environmentRotation]);
    light.bakedOcclusion = values[table.bakedLight] ? 1.0F : 0.0F;
    light.sunTanHalfWidth = static_cast<float>(std::tan(values[table.sunDisk] / 2));
    light.sunDiskSamples = values[table.diskSamples];
    light.exposure = static_cast<float>(adaptationOf(scene, source) * std::exp2(values[table.exposure]));
    return light;
}

/// Writes the areas of the openings in the hall's shadow map. Everything outside them, seen from the sun, is in shadow
/// and needs no lookup.
void boundSunlight(const HallScene& scene, SceneLighting& lighting)
{
    constexpr double reveal = 0.6;   // Meters; walls are this thick, and light enters obliquely.
    constexpr double farthest = 16;  // Meters to the caster of a penumbra, as in shaders/lib/light.glsl.
    constexpr double texels = 8;     // Wider than every filter.
    LightBlock& light = lighting.light;
    const std::vector<render::Box>& openings = scene.model.openings();
    if (openings.size() > MOST_SUN_PASSAGES) return;
    light.roomLow = glm::vec3(scene.model.room().low);
    light.roomHigh = glm::vec3(scene.model.room().high);
    const glm::dmat4& clipFromView = lighting.hallShadowView.clipFromView;
    const glm::dvec2 perMeter = 0.5 * glm::dvec2(clipFromView[0][0], clipFromView[1][1]);
    const glm::dvec2 margin = perMeter * (reveal + farthest * static_cast<double>(light.sunTanHalfWidth) +
                                          texels * static_cast<double>(light.hallShadowTexel));
    for (std::size_t i = 0; i < openings.size(); ++i) {
        const render::Box seen = openings[i].transformed(glm::dmat4(light.hallShadowFromWorld));
        light.sunPassages[i] = glm::vec4(glm::dvec2(seen.low) - margin, glm::dvec2(seen.high) + margin);
    }
}

void lookUpProbe(const HallScene& scene, LightBlock& light)
{
    light.hasProbe = true;
    light.probePosition = glm::vec3(probePosition(scene));
    light.probeLastLevel = static_cast<float>(probeLevels(scene.values[scene.table.probeSize]) - 1);
    if (scene.alone) return;
    light.probeLow = glm::vec3(scene.model.probeRoom().low);
    light.probeHigh = glm::vec3(scene.model.probeRoom().high);
}

}  // namespace

bool isInWalls(const HallModel& model, const glm::dvec3& eye)
{
    constexpr double farthestNearPlane = 0.5;  // Meters from the eye, in the corners of the widest picture.
    render::Box building = model.bounds();
    building.low -= farthestNearPlane;
    building.high += farthestNearPlane;
    return building.contains(eye) && !model.room().contains(eye);
}

std::string whyHidden(const HallModel& model, const render::Box& worldBox, const render::View& view)
{
    if (!view.mayContain(worldBox)) return "out of view";
    if (isInWalls(model, view.eye)) return {};  // The eye sees through the walls.
    for (const Occluder& occluder : model.occluders())
        if (isBehind(occluder, worldBox, view.eye)) return "behind a wall";
    return {};
}

glm::dvec3 towardsSun(const HallScene& scene)
{
    return sunOf(scene.table, scene.values).towards();
}

SceneLighting sceneLighting(const HallScene& scene, bool runEverything)
{
    const HallTable& table = scene.table;
    const ParameterValues& values = scene.values;
    const Sun source = sunOf(table, values);
    SceneLighting result;
    result.towardsSun = source.towards();
    result.sunIrradiance = source.irradiance();
    LightBlock& light = result.light;
    light = lightBlock(scene, source);
    result.background = scene.environment ? BACKGROUND_PANORAMA : scene.alone ? BACKGROUND_STUDIO : BACKGROUND_SKY;
    result.shadowFilter = static_cast<int>(values[table.shadowFilter]);
    static_assert(static_cast<int>(ShadowFilter::hard) == SHADOW_FILTER_HARD &&
                  static_cast<int>(ShadowFilter::tent3) == SHADOW_FILTER_TENT_3 &&
                  static_cast<int>(ShadowFilter::tent5) == SHADOW_FILTER_TENT_5 &&
                  static_cast<int>(ShadowFilter::disk) == SHADOW_FILTER_SUN_DISK);
    result.exposure = light.exposure;
    result.adaptation = adaptationOf(scene, source);

    result.hallCastsShadow = light.hallCastsShadow = values[table.sunShadows] && !scene.alone;
    if (result.hallCastsShadow) {
        const int mapSize = values[table.shadowMapSize];
        result.hallShadowView = lightView(scene.model.bounds(), result.towardsSun, glm::ivec2(mapSize), 0.5);
        light.hallShadowFromWorld = shadowFromWorld(result.hallShadowView);
        light.hallShadowTexel = static_cast<float>(2 / result.hallShadowView.clipFromView[0][0] / mapSize);
        result.inputs.push_back({UNIT_SHADOW_HALL, std::string("shadow.hall")});
        boundSunlight(scene, result);
    }
    if (!scene.alone) {
        result.openings = scene.model.openings();
        result.room = scene.model.room();
        result.building = scene.model.bounds();
    }
    result.sunShadow = shadowBound(source);
    const double bounced = scene.alone ? 0 : scene.model.surfaces().lightmaps().sun.most(bounceOf(scene));
    result.bouncedLight = boundOfBounce(scene, bounced);
    result.hasBouncedLight = !scene.alone && (runEverything || !result.bouncedLight.isZero());
    result.sunShare = source.strength / std::get<double>(table.rows()[table.sunStrength.row].initial);
    result.lampLight = lampBound(scene, vaultLampsOf(table, values));
    result.hasLampLight = !scene.alone && (runEverything || !result.lampLight.isZero());
    double skyBrightest = 0;
    if (result.background == BACKGROUND_SKY) {
        const std::shared_ptr<const SkyView> sky = skyView(skySource(scene, source));
        result.inputs.push_back({UNIT_ENVIRONMENT, sky->radiance});
        skyBrightest = sky->brightest;
    }
    result.brightest = brightestAround(scene, light, skyBrightest, bounced) + result.lampLight.absolute;
    const std::optional<render::LocalLighting> lamps = probeLamps(scene);
    result.probeLight = render::boundOf(
        0, mostAmbient, {{result.brightest + (lamps ? mostRadianceBy(*lamps) : 0), "there is no light to reflect"}});
    if (values[table.reflectionProbe] && (runEverything || !result.probeLight.isZero())) {
        lookUpProbe(scene, light);
        result.inputs.push_back({UNIT_PROBE, std::string("probe")});
        result.inputs.push_back({UNIT_PROBE_IRRADIANCE, std::string("probe.irradiance")});
    }
    if (values[table.bakedLight]) lookUpAirLight(scene, result);
    if (scene.environment) result.inputs.push_back({UNIT_ENVIRONMENT, scene.environment});
    return result;
}

std::string whyUnlit(const HallScene& scene, const render::Box& worldBox)
{
    if (render::ContributionBound bound = shadowBound(sunOf(scene.table, scene.values)); bound.isZero())
        return std::move(bound.whyNone);
    if (!scene.values[scene.table.sunShadows]) return "sun shadows are switched off";
    if (scene.alone) return {};
    const glm::dvec3 sun = towardsSun(scene);
    const std::vector<render::Box>& openings = scene.model.openings();
    const bool lit = std::any_of(openings.begin(), openings.end(), [&](const render::Box& opening) {
        return passesThrough(worldBox, sun, opening, scene.model.room());
    });
    return lit ? std::string() : "the sun does not reach it through window or oculus";
}

std::uint64_t lightKey(const HallScene& scene)
{
    render::Hash hash;
    // Exposure, tone curve, sampling and effects on the floor alone change no light, so they are not in the key.
    ParameterValues lighting = scene.values;
    for (const std::size_t row :
         {std::size_t{scene.table.exposure.row}, std::size_t{scene.table.toneCurve.row},
          std::size_t{scene.table.glare.row}, std::size_t{scene.table.glareLevels.row},
          std::size_t{scene.table.supersamples.row}, std::size_t{scene.table.resolutionScale.row},
          std::size_t{scene.table.temporalAntialiasing.row}, std::size_t{scene.table.historyFrames.row},
          std::size_t{scene.table.contactShadows.row}, std::size_t{scene.table.floorMirror.row},
          std::size_t{scene.table.heatMap.row}, std::size_t{scene.table.heatScale.row}})
        lighting.resetParameter(row);
    derive::addToKey(hash, lighting);
    hash.addValue(scene.alone).addValue(scene.filesId);
    for (const ExhibitSlot& slot : scene.exhibits) hash.addValue(slot.place);
    return hash.value();
}

}  // namespace vitrine::hall
