#include "exhibits/noise/noise_scene.h"

#include "exhibits/noise/sea_waves.h"
#include "render/files/number_text.h"
#include "render/glsl/cpu.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace vitrine::noise {
namespace {

constexpr double metersOfCloudsPerMeter = 40;  ///< A step aside changes the view of the clouds visibly.
constexpr std::size_t mostTallWaves = 28;

/// Returns x modulo the period, in [0, period), also for negative x.
double wrapped(double x, double period)
{
    const double rest = std::fmod(x, period);
    return std::clamp(rest < 0 ? rest + period : rest, 0.0, period);
}

/// The same rotation as shaders/lib/noise_sums.glsl's.
glm::dmat3 octaveTurn(double angle)
{
    return glm::dmat3(glm::rotate(glm::dmat4(1), angle, glm::dvec3(0.48, 0.6, 0.64)));
}

/// Sets the position of the work's origin in the lattice of an octave.
void setOrigin(NoiseBlock& block, std::size_t octave, const glm::dvec3& point)
{
    const glm::dvec3 base = glm::floor(point);
    glm::ivec3 cell;
    // Modulo 2^32, as shaders count.
    for (int i = 0; i < 3; ++i)
        cell[i] = static_cast<std::int32_t>(
            static_cast<std::uint32_t>(static_cast<std::int64_t>(wrapped(base[i], 4294967296.0))));
    block.cells[octave] = glm::ivec4(cell, 0);
    block.places[octave] = glm::vec4(glm::min(glm::vec3(point - base), glm::vec3(0x1.fffffep-1F)), 0);
}

/// Returns the offset of an octave in the one noise of all octaves. The first has none, as tests expect.
glm::ivec4 octaveShift(int octave)
{
    if (octave == 0) return glm::ivec4(0);
    return glm::ivec4(glm::ivec3(glsl::pcg3d({static_cast<std::uint32_t>(octave), 17U, 3U}) % glm::uvec3(FIELD_REPEAT)),
                      0);
}

void setField(const NoiseTable& t, const ParameterValues& values, double seconds, NoiseBlock& block)
{
    const bool one = values[t.work] == NoiseWork::field;
    block.octaves = one ? 1 : values[t.octaves];
    const glm::dvec3 origin(values[t.distance], 0, -values[t.drift] * seconds);
    glm::dmat3 domain(values[t.frequency]);
    const glm::dmat3 turn = octaveTurn(values[t.octaveRotation]) * values[t.lacunarity];
    double amplitude = 1, sum = 0;
    for (int i = 0; i < block.octaves; ++i) {
        const auto octave = static_cast<std::size_t>(i);
        setOrigin(block, octave, domain * origin);
        block.cells[octave] = (block.cells[octave] + octaveShift(i)) & (FIELD_REPEAT - 1);
        sum += amplitude;
        amplitude *= values[t.gain];
        domain = turn * domain;
    }
    setOrigin(block, NOISE_OCTAVES - 1, 0.5 * values[t.frequency] * origin);
    block.amplitudes = static_cast<float>(sum);
}

void setSea(const NoiseTable& t, const ParameterValues& values, double seconds, NoiseBlock& block)
{
    const double wind = values[t.windSpeed];
    const std::vector<SeaWave> all =
        seaWaves(wind, values[t.windDirection], SEA_WAVES, static_cast<std::uint32_t>(values[t.seed]));
    block.waves = std::min(values[t.waves], SEA_WAVES);
    double variance = 0, shown = 0, tall = 0, slopes = 0, hidden = 0;
    for (const SeaWave& w : all) variance += w.amplitude * w.amplitude;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const SeaWave& w = all[i];
        const double steep = w.amplitude * glm::length(w.vector);
        slopes += 0.5 * steep * steep;
        if (i >= static_cast<std::size_t>(block.waves)) {
            hidden += 0.5 * steep * steep;
            continue;
        }
        const double phase = wrapped(w.frequency * seconds + w.phase, 2 * std::numbers::pi);
        block.wave[i] = glm::vec4(glm::dvec4(w.vector, w.amplitude, phase));
        if (shown < 0.985 * variance && i < mostTallWaves) {
            block.tallWaves = static_cast<int>(i) + 1;
            tall += 0.5 * w.amplitude * w.amplitude;
        }
        shown += w.amplitude * w.amplitude;
    }
    block.seaTop = static_cast<float>(std::max(SEA_HIGHEST * std::sqrt(tall), 1e-3));
    block.hiddenSlopes = static_cast<float>(hidden + std::max(seaSlopes(wind) - slopes, 0.001));
    block.foamTime = static_cast<float>(wrapped(0.25 * seconds, NOISE_PERIOD));
    block.skyTime = static_cast<float>(wrapped(0.004 * seconds, NOISE_PERIOD));
}

/// Returns the number of standard deviations that a normal variable exceeds with this probability, at most one half.
/// Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", 26.2.22; off by at most 0.003.
double exceededWith(double probability)
{
    const double t = std::sqrt(-2 * std::log(std::clamp(probability, 1e-12, 0.5)));
    return t - (2.30753 + 0.27061 * t) / (1 + t * (0.99229 + 0.04481 * t));
}

/// Sets where waves break: where the horizontal displacement draws the water together. The share of whitecaps at the
/// initial chop is that of Monahan and O'Muircheartaigh 1980, "Optimal Power-Law Description of Oceanic Whitecap
/// Coverage", times a factor of the parameter.
void setFoam(const NoiseTable& t, const ParameterValues& values, NoiseBlock& block)
{
    constexpr double shortest = 60;  // Shorter waves than this share of the highest one do not break: wave numbers.
    const double wind = values[t.windSpeed];
    const double peak = std::pow(0.877 * 9.81 / (1.026 * wind), 2) / 9.81;
    const double cut = 1 / std::pow(shortest * peak, 2);
    double variance = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.waves); ++i) {
        const glm::dvec4 w(block.wave[i]);
        const double k = glm::length(glm::dvec2(w));
        const double share = 1 / (1 + k * k * cut);
        // Change of phase within FOAM_AGE, for waves on deep water.
        const double change = FOAM_AGE * std::sqrt(9.81 * k);
        block.breaking[i] = glm::vec4(glm::dvec4(share, share * std::cos(change), share * std::sin(change), 0));
        variance += 0.5 * std::pow(share * w.z * k, 2);
    }
    block.foamDeviation = static_cast<float>(std::sqrt(variance));
    const double foam = values[t.foam];
    const double coverage = 3.84e-6 * std::pow(wind, 3.41) * std::exp2(3 * (foam - 0.5));
    const double initialChop = t.initial()[t.chop];
    block.foamBelow = foam > 0 ? static_cast<float>(1 - initialChop * exceededWith(coverage) * std::sqrt(variance)) : 0;
}

void setClouds(const NoiseTable& t, const ParameterValues& values, double seconds, NoiseBlock& block)
{
    const double angle = values[t.windDirection];
    // A pattern that moves with the wind is looked up at the place up-wind where it began.
    const glm::dvec3 way = -seconds * values[t.windSpeed] * glm::dvec3(std::sin(angle), 0, -std::cos(angle));
    const auto within = [](const glm::dvec3& shift, double repeat) {
        return glm::vec3(wrapped(shift.x, repeat), wrapped(shift.y, repeat), wrapped(shift.z, repeat));
    };
    block.cloudShift = within(way, CLOUD_REPEAT);
    block.fineShift = within(1.2 * way, CLOUD_FINE_REPEAT);
    block.weatherShift = within(WEATHER_SCALE * way, CLOUD_REPEAT);
}

}  // namespace

double noiseTime(const NoiseTable& t, const ParameterValues& values, double time)
{
    return values[t.moment] + (values[t.animate] && std::isfinite(time) ? time : 0);
}

Portal noisePortal(const NoiseTable& t, const ParameterValues& values)
{
    Portal portal;
    const bool physical = values[t.look] == NoiseLook::physical;
    if (values[t.work] == NoiseWork::sea && physical)
        portal.workFromExhibit = glm::translate(glm::dmat4(1), {0, values[t.eyeHeight], 0});
    if (values[t.work] == NoiseWork::clouds && physical) {
        const glm::dmat4 up =
            glm::rotate(glm::translate(glm::dmat4(1), {0, values[t.altitude], 0}), values[t.tilt], glm::dvec3(1, 0, 0));
        portal.workFromExhibit = glm::scale(up, glm::dvec3(metersOfCloudsPerMeter));
    }
    return portal;
}

NoiseBlock noiseBlock(const NoiseTable& t, const ParameterValues& values, double seconds, const glm::dvec3& towardsSun,
                      int sample)
{
    NoiseBlock block;
    block.sunDirection = glm::vec3(towardsSun);
    block.time = static_cast<float>(std::fmod(seconds, 3600.0));
    block.sampleShift = static_cast<float>(std::fmod(0.6180339887498949 * sample, 1.0));
    setField(t, values, seconds, block);
    setSea(t, values, seconds, block);
    setFoam(t, values, block);
    setClouds(t, values, seconds, block);
    return block;
}

std::string noiseMotionGlsl(const NoiseTable& t, const ParameterValues& values)
{
    const auto number = [](double x) {
        const std::string text = render::shortestNumber(static_cast<float>(x));
        return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
    };
    const auto vector = [&](const glm::dvec3& v) {
        return "vec3(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
    };
    const NoiseWork work = values[t.work];
    const bool physical = values[t.look] == NoiseLook::physical;
    if (work == NoiseWork::field || work == NoiseWork::fractal) {
        // As setField does.
        const std::string octaves = std::to_string(work == NoiseWork::field ? 1 : values[t.octaves]);
        const std::string loop = "    for (int i = 0; i < " + octaves + "; ++i) { ";
        std::string text = "    work.amplitudes = 0.0;\n    float amplitude = 1.0;\n" + loop +
                           "work.amplitudes += amplitude; amplitude *= parameters.gain; }\n";
        text += "    mat3 lattice = mat3(parameters.frequency);\n    vec3 drifted = vec3(0.0, 0.0, " +
                number(-values[t.drift]) + " * TIME);\n";
        text += loop +
                "vec3 place = work.places[i].xyz + lattice * drifted; work.places[i].xyz = fract(place); "
                "work.cells[i].xyz = (work.cells[i].xyz + ivec3(floor(place))) & ivec3(" +
                std::to_string(FIELD_REPEAT - 1) +
                "); lattice = noiseRotation(parameters.octaveRotation) * parameters.lacunarity * lattice; }\n";
        const std::string last = std::to_string(NOISE_OCTAVES - 1);
        if (physical && work == NoiseWork::fractal && values[t.warp] > 0)
            text += "    vec3 warped = work.places[" + last +
                    "].xyz + 0.5 * parameters.frequency * drifted;\n    work.places[" + last +
                    "].xyz = fract(warped);\n    work.cells[" + last + "].xyz += ivec3(floor(warped));\n";
        return physical ? text : text + "    work.time = mod(work.time + TIME, 3600.0);\n";
    }
    if (!physical) return "    work.time = mod(work.time + TIME, 3600.0);\n";
    if (work == NoiseWork::sea)
        return "    for (int i = 0; i < work.waves; ++i) work.wave[i].w = mod(work.wave[i].w + sqrt(9.81 * "
               "length(work.wave[i].xy)) * TIME, 6.2831853);\n"
               "    work.foamTime = mod(work.foamTime + 0.25 * TIME, " +
               number(NOISE_PERIOD) + ");\n    work.skyTime = mod(work.skyTime + 0.004 * TIME, " +
               number(NOISE_PERIOD) + ");\n";
    const double angle = values[t.windDirection];
    const glm::dvec3 way = -values[t.windSpeed] * glm::dvec3(std::sin(angle), 0, -std::cos(angle));
    const auto shift = [&](const std::string& name, double factor, double repeat) {
        return "    work." + name + " = mod(work." + name + " + TIME * " + vector(factor * way) + ", " +
               number(repeat) + ");\n";
    };
    return shift("cloudShift", 1, CLOUD_REPEAT) + shift("fineShift", 1.2, CLOUD_FINE_REPEAT) +
           shift("weatherShift", WEATHER_SCALE, CLOUD_REPEAT);
}

NoiseLight noiseLight(const NoiseTable& t, const ParameterValues& values, double hallSunElevation)
{
    constexpr double degree = std::numbers::pi / 180;
    constexpr double sinksFrom = 4 * degree;  // Elevations of the hall's sun.
    constexpr double moonFrom = -4 * degree, moonTo = -10 * degree;
    const glm::dvec3 moonlight = 2e-3 * glm::dvec3(0.8, 0.9, 1);
    const double up = values[t.sunElevation], right = values[t.sunAzimuth];
    const auto at = [right](double elevation) {
        return glm::dvec3(std::sin(right) * std::cos(elevation), std::sin(elevation),
                          -std::cos(right) * std::cos(elevation));
    };
    if (values[t.sunBy] != NoiseSun::ownByDay || hallSunElevation >= sinksFrom) return {at(up), up};
    const double day = glm::smoothstep(moonFrom, sinksFrom, hallSunElevation);
    const double sun = glm::mix(std::min(up, hallSunElevation), up, day);
    const double night = 1 - glm::smoothstep(moonTo, moonFrom, hallSunElevation);
    if (night <= 0) return {at(sun), sun};
    return {at(std::max(up, 0.0)), sun, moonlight * night};
}

std::shared_ptr<const SkyView> noiseSky(const NoiseTable& t, const ParameterValues& values, const NoiseLight& light)
{
    // The parameter is a share of the haze that hides the horizon: 28 times that of clear air.
    const double haze = values[t.haze];
    return skyView({.sunElevation = light.sunElevation,
                    .haze = 1 + 27.7 * haze * haze,
                    .night = glm::dvec3(0.12, 0.2, 0.42) * light.moon});
}

void lightBy(const SkyView& sky, const NoiseLight& light, double brightness, NoiseBlock& block)
{
    constexpr double initial = 5;        // Exposure of a day on which the level ground sends `day`.
    constexpr double day = 0.12;         // Radiance, for sunlight of 1 above the air.
    constexpr double adaptation = 0.55;  // Share of stops by which the exposure follows the light.
    const glm::dvec3 luminance(0.2126, 0.7152, 0.0722);
    const double up = std::max(static_cast<double>(block.sunDirection.y), 0.0);
    const glm::dvec3 sun = sky.sun + light.moon;
    const double level = glm::dot(luminance, sky.above + sun * (up / std::numbers::pi));
    const double exposure = brightness * initial * std::pow(day / std::max(level, 1e-6), adaptation);
    block.skyScale = static_cast<float>(exposure);
    block.sunLight = glm::vec3(sun * exposure);
    block.sunOnClouds = glm::vec3((sky.sunOnClouds + light.moon) * exposure);
    block.skyAbove = glm::vec3(sky.above * exposure);
    block.skyAround = glm::vec3(sky.around * exposure);
}

}  // namespace vitrine::noise
