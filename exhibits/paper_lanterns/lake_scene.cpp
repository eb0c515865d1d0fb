#include "exhibits/paper_lanterns/lake_scene.h"

#include "exhibits/paper_lanterns/lake_release.h"
#include "exhibits/paper_lanterns/lake_waves.h"
#include "exhibits/paper_lanterns/paper_lanterns_cpu.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace vitrine::paper_lanterns {
namespace {

/// Paper is then as bright as white in display light at its upper edge, and ten times as bright in front of the flame.
constexpr double candleIntensity = 30;
constexpr double candleOfReference = 5.5;  ///< Paper around it is as bright as white in display light.
constexpr int mostRipplesOfLake = LAKE_WAVES - LAKE_TALL_WAVES;

/// Angle of straight ahead from -z towards +x.
constexpr double latticeTurn = std::numbers::pi / 4;

/// Returns x modulo the period, in [0, period), also for negative x.
double inPeriod(double x, double period)
{
    const double rest = std::fmod(x, period);
    return rest < 0 ? std::min(rest + period, std::nextafter(period, 0.0)) : rest;
}

double phaseAt(const LakeWave& wave, double seconds)
{
    return inPeriod(wave.frequency * seconds + wave.phase, 2 * std::numbers::pi);
}

glm::vec4 packed(const LakeWave& wave, double seconds)
{
    return glm::vec4(glm::dvec4(wave.vector, wave.amplitude, phaseAt(wave, seconds)));
}

void setShape(const PaperLanternsTable& t, const ParameterValues& values, LakeBlock& block)
{
    const auto f = [&](Real row) { return static_cast<float>(values[row]); };
    block.paperRadius = f(t.paperRadius);
    block.paperHeight = f(t.paperHeight);
    block.paperHalf = 0.5F * f(t.paperWall);
    block.baseHalfWidth = 0.5F * f(t.baseWidth);
    block.baseHalfHeight = 0.5F * f(t.baseThickness);
    block.ringRadius = f(t.ringWire);
    block.lowRing = f(t.lowRing);
    block.postRadius = f(t.postWire);
    block.blend = f(t.frameBlend);
    block.flameHeight = std::min(f(t.flameHeight), block.paperHeight);
}

void setWaves(const PaperLanternsTable& t, const ParameterValues& values, double seconds, LakeBlock& block)
{
    const double height = values[t.waveHeight];
    std::vector<LakeWave> tall = sourceWaves(values[t.waveSpeed] == LakeSpeed::dispersion);
    const bool onWater = values[t.ride] == LakeRide::water;
    // Radius of the disk with the same area as the base.
    const double radius = 2 * static_cast<double>(block.baseHalfWidth) / std::sqrt(std::numbers::pi);
    for (std::size_t i = 0; i < tall.size(); ++i) {
        LakeWave wave = tall[i];
        wave.amplitude *= height;
        const double k = glm::length(wave.vector);
        block.wave[i] = packed(wave, seconds);
        block.waveTop += static_cast<float>(wave.amplitude);
        block.waveSlope += static_cast<float>(wave.amplitude * k);
        const RideShare share = rideShare(k, radius);
        block.rideTilt[i].x = static_cast<float>(wave.amplitude * share.slope);
        wave.amplitude *= share.height;
        block.ride[i] = packed(wave, seconds);
    }
    block.tallWaves = height > 0 ? static_cast<int>(tall.size()) : 0;
    block.rideWaves = block.tallWaves;
    if (!onWater && height > 0) {
        LakeWave rough = sourceRideWave();
        rough.amplitude *= height;
        block.ride[0] = packed(rough, seconds);
        block.rideTilt[0].x = block.ride[0].z;
        block.rideWaves = 1;
    }
    const bool physical = values[t.look] == LakeLook::physical;
    const int ripples = physical && values[t.ripples] > 0 ? std::min(values[t.rippleCount], mostRipplesOfLake) : 0;
    const std::vector<LakeWave> fine = windRipples(values[t.ripples], values[t.windDirection] + latticeTurn,
                                                   mostRipplesOfLake, static_cast<std::uint32_t>(values[t.seed]));
    for (int i = 0; i < ripples; ++i)
        block.wave[static_cast<std::size_t>(block.tallWaves + i)] = packed(fine[static_cast<std::size_t>(i)], seconds);
    block.waves = block.tallWaves + ripples;
    const double slopes = physical ? values[t.ripples] * values[t.ripples] : 0;
    block.hiddenSlopes = static_cast<float>(0.5 * slopes * (mostRipplesOfLake - ripples) / mostRipplesOfLake + 2e-5);
}

/// Sets the bounds of a lantern, and the width of a cell that it needs.
void setBounds(const PaperLanternsTable& t, const ParameterValues& values, LakeBlock& block)
{
    float height = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.rideWaves); ++i) height += std::abs(block.ride[i].z);
    const float wires = std::max({block.ringRadius, block.postRadius, block.paperHalf}) + 0.25F * block.blend;
    const float tall = block.paperHeight + wires + 0.03F;
    const float base = std::sqrt(2.0F) * block.baseHalfWidth;
    const float lean = mostLean(block);
    block.reach = std::max(base + block.baseHalfHeight * lean + 0.02F, tubeReach(block));
    block.low = -height - base * lean - block.baseHalfHeight - 0.02F;
    block.high = height + tall + (block.paperRadius + wires) * lean + 0.02F;
    // Around a lantern released on an empty lake, cells have their initial width, since `spacing` has no effect there.
    const double spacing = anyAfloat(t, values) ? values[t.spacing] : t.initial()[t.spacing];
    block.cell = std::max(static_cast<float>(spacing), 2 * block.reach + 0.1F);
    block.jitter = static_cast<float>(values[t.irregularity]) * (0.5F * block.cell - block.reach - 0.04F);
}

void setLattice(const PaperLanternsTable& t, const ParameterValues& values, double seconds, LakeBlock& block)
{
    const double g = static_cast<double>(block.cell);
    const double side = std::ceil(std::sqrt(static_cast<double>(values[t.lanterns])) - 1e-9);
    const auto cells = static_cast<int>(std::min<double>(side, LAKE_LATTICE));
    block.cells = glm::ivec2(cells);
    block.fill = static_cast<float>(values[t.crowding]);
    block.farRow = side > cells ? static_cast<float>(side * g) : 0;
    const glm::dvec2 wind = windOf(t, values);
    const glm::dvec2 drifted = values[t.drift] * seconds * wind;
    const glm::dvec2 shift(inPeriod(drifted.x, g), inPeriod(-drifted.y, g));
    block.corner = glm::vec2(latticeCorner(t, values, g) + glm::dvec2(shift.x, -shift.y));
    block.firstCell = firstCellAt(drifted, g);
}

void setLight(const PaperLanternsTable& t, const ParameterValues& values, const ParameterValues& fixed, double seconds,
              LakeBlock& block)
{
    block.flickerTime = static_cast<float>(inPeriod(seconds, 4));
    block.flickerDepth = static_cast<float>(values[t.flicker]);
    const bool own = values[t.flickerPhase] == LakeFlicker::own;
    block.flickerApart = own ? 1 : 0;
    const bool physical = values[t.look] == LakeLook::physical;
    const double intensity = physical ? candleIntensity : candleOfReference;
    const double strength = values[t.candles] ? intensity * values[t.candleStrength] : 0;
    block.candle = glm::vec3(strength * values[t.candleColor].value);
    const ParameterValues& paper = physical ? values : fixed;
    const double scatter = paper[t.paperThickness];
    block.paperScatter = static_cast<float>(scatter);
    // Light that meets few fibers keeps much of its direction.
    block.paperForward = static_cast<float>(std::exp(-0.3 * scatter));
    for (int i = 0; i < 3; ++i) {
        // Absorption that makes thick paper reflect this color (Kubelka and Munk).
        const double thick = std::clamp(paper[t.paperColor].value[i], 0.01, 0.999);
        block.paperAbsorb[i] = static_cast<float>(scatter * (1 - thick) * (1 - thick) / (2 * thick));
    }
    const double up = values[t.moonElevation], right = values[t.moonAzimuth] + latticeTurn;
    block.towardsMoon = glm::vec3(std::sin(right) * std::cos(up), std::sin(up), -std::cos(right) * std::cos(up));
    block.moonTanRadius = static_cast<float>(std::tan(0.5 * values[t.moonSize]));
    // The moon sends no light from below the horizon, and less and warmer light near it.
    const double risen = std::clamp((up + 0.03) / 0.06, 0.0, 1.0);
    const glm::dvec3 through = glm::exp(-glm::dvec3(0.05, 0.11, 0.2) / (std::max(std::sin(up), 0.0) + 0.12));
    block.moonLight = glm::vec3(0.25 * values[t.moon] * risen * glm::dvec3(0.86, 0.93, 1.0) * through);
}

/// Sets what is the same for all pixels. Drivers without branches would compute it at each step of a ray.
void setGlow(LakeBlock& block)
{
    glsl::Lake lake;
    copyLake(lake.lake, block);
    block.releasedGlow = glm::vec3(lake.paperGlow(block.released.w, block.releasedPose.w));
    // Apart, the flames' flicker averages out.
    block.farGlow = glm::vec3(lake.paperGlow(glm::mix(lake.flickerOf(0), 0.55, double{block.flickerApart}), 0));
}

}  // namespace

float mostLean(const LakeBlock& block)
{
    float slope = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.rideWaves); ++i)
        slope += std::abs(block.rideTilt[i].x) * glm::length(glm::vec2(block.ride[i]));
    return slope / std::sqrt(1 + slope * slope);
}

float tubeReach(const LakeBlock& block)
{
    const float wires = std::max({block.ringRadius, block.postRadius, block.paperHalf}) + 0.25F * block.blend;
    return block.paperRadius + wires + (block.paperHeight + wires + 0.03F) * mostLean(block) + 0.02F;
}

bool anyAfloat(const PaperLanternsTable& t, const ParameterValues& values)
{
    return values[t.crowding] > 0;
}

bool lightsTheAir(const PaperLanternsTable& t, const ParameterValues& values)
{
    // Thinner mist sends less than a hundredth of a lantern's light.
    return values[t.fog] > 0.0015 && values[t.candles] && values[t.show] == LakeShow::picture &&
           values[t.look] == LakeLook::physical;
}

glm::dvec2 straightAhead()
{
    return {std::sin(latticeTurn), -std::cos(latticeTurn)};
}

glm::dvec2 windOf(const PaperLanternsTable& t, const ParameterValues& values)
{
    const double angle = values[t.windDirection] + latticeTurn;
    return {std::sin(angle), -std::cos(angle)};
}

glm::dvec2 latticeCorner(const PaperLanternsTable& t, const ParameterValues& values, double cell)
{
    const double side = std::ceil(std::sqrt(static_cast<double>(values[t.lanterns])) - 1e-9);
    // A small lattice begins in the middle of the view. A large one begins behind the eye, so its edge is invisible.
    return -std::min(24.0, side * cell / std::sqrt(2.0) - 9.5) * straightAhead();
}

glm::ivec2 firstCellAt(const glm::dvec2& drifted, double cell)
{
    const glm::dvec2 gone = glm::floor(glm::dvec2(drifted.x, -drifted.y) / cell);
    // Cell numbers only seed random numbers, so they may be taken modulo 2^24.
    return -glm::ivec2(static_cast<int>(std::fmod(gone.x, 16777216.0)),
                       static_cast<int>(std::fmod(gone.y, 16777216.0)));
}

double lakeTime(const PaperLanternsTable& t, const ParameterValues& values, double time)
{
    return values[t.moment] + (values[t.animate] && std::isfinite(time) ? time : 0);
}

LakePress lakePress(const PaperLanternsTable& t, const ParameterValues& values, double time, double since)
{
    return {since, values[t.moment] + (std::isfinite(time - since) ? time - since : 0)};
}

Portal lakePortal(const PaperLanternsTable& t, const ParameterValues& values)
{
    Portal portal;
    const glm::dmat4 turned =
        glm::rotate(glm::translate(glm::dmat4(1), {0, values[t.eyeHeight], 0}), -latticeTurn, glm::dvec3(0, 1, 0));
    portal.workFromExhibit = glm::scale(turned, glm::dvec3(values[t.scale]));
    return portal;
}

std::shared_ptr<const SkyView> lakeDusk(const PaperLanternsTable& t, const ParameterValues& values)
{
    constexpr double lowest = -0.12, highest = -0.03;  // Radians: end of the blue hour, and just after sunset.
    constexpr double nearHorizon = 0.17;               // Mean luminance.
    SkySource source{.sunElevation = glm::mix(lowest, highest, values[t.afterglow]), .haze = 2};
    const double luminance = glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), skyView(source)->around);
    // Without afterglow the horizon is cool, too, as under thin clouds.
    source.sun = glm::mix(glm::dvec3(0.6, 0.95, 1.3), glm::dvec3(1), values[t.afterglow]) * (nearHorizon / luminance);
    return skyView(source);
}

LakeBlock lakeBlock(const PaperLanternsTable& t, const ParameterValues& values, double seconds, const LakePress& press)
{
    LakeBlock block;
    // In the reference's light and in views of parts, some parameters have no effect: they keep these initial values.
    const ParameterValues fixed = t.initial();
    block.seed = static_cast<std::uint32_t>(values[t.seed]);
    block.turn = static_cast<float>(values[t.turned]);
    block.variety = values[t.look] == LakeLook::physical ? static_cast<float>(values[t.colors]) : 0;
    block.waterTime = static_cast<float>(inPeriod(seconds, 3600));
    setShape(t, values, block);
    setWaves(t, values, seconds, block);
    setBounds(t, values, block);
    setLattice(t, values, seconds, block);
    setLight(t, values, fixed, seconds, block);
    block.rowLimit = values[t.rows];
    block.looks = lightsTheAir(t, values) ? 3 : 2;
    block.stepLimit = values[t.stepLimit];
    block.tolerance = static_cast<float>(values[t.hitTolerance]);
    const ParameterValues& sizes =
        values[t.look] == LakeLook::physical && values[t.show] == LakeShow::picture ? values : fixed;
    block.pointWidth = 2 * block.paperRadius / static_cast<float>(sizes[t.pointSize]);
    block.meanWidth = 2 * block.paperRadius / static_cast<float>(sizes[t.meanSize]);
    setReleased(t, values, seconds, press, block);
    setGlow(block);
    return block;
}

}  // namespace vitrine::paper_lanterns
