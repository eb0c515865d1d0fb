#include "exhibits/noise/noise_charts.h"

#include "exhibits/noise/noise_cpu.h"
#include "exhibits/noise/sea_waves.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <utility>

namespace vitrine::noise {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double extent = 64;  ///< Cells; samples are within a cube of this size.

/// Returns a sample point, always the same for the same index and set.
glm::dvec3 samplePoint(int i, std::uint32_t set)
{
    const glm::uvec3 bits = glsl::pcg3d({static_cast<std::uint32_t>(i), set, 5U});
    return extent * glm::dvec3(glsl::unitFromBits(bits.x), glsl::unitFromBits(bits.y), glsl::unitFromBits(bits.z));
}

glm::dvec3 sampleDirection(int i)
{
    const glm::dvec3 p = samplePoint(i, 11) / extent;
    const double up = 2 * p.x - 1;
    const double side = std::sqrt(1 - up * up);
    return {side * std::cos(2 * pi * p.y), up, side * std::sin(2 * pi * p.y)};
}

/// Fourier transform: Cooley and Tukey 1965. The length is a power of 2.
void transform(std::vector<std::complex<double>>& values)
{
    const std::size_t count = values.size();
    for (std::size_t i = 1, j = 0; i < count; ++i) {
        std::size_t bit = count >> 1;
        for (; (j & bit) != 0; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t length = 2; length <= count; length *= 2) {
        const std::complex<double> turn = std::polar(1.0, -2 * pi / static_cast<double>(length));
        for (std::size_t i = 0; i < count; i += length) {
            std::complex<double> w = 1;
            for (std::size_t j = i; j < i + length / 2; ++j, w *= turn) {
                const std::complex<double> a = values[j], b = values[j + length / 2] * w;
                values[j] = a + b;
                values[j + length / 2] = a - b;
            }
        }
    }
}

glsl::NoiseSum sumOnShow(const NoiseTable& t, const ParameterValues& values)
{
    const bool one = values[t.work] == NoiseWork::field;
    return {static_cast<int>(values[t.kind]),
            one ? glsl::NOISE_FBM : static_cast<int>(values[t.sum]),
            one ? 1 : values[t.octaves],
            values[t.gain],
            values[t.lacunarity],
            values[t.octaveRotation],
            0,
            static_cast<glm::uint>(values[t.seed])};
}

/// Returns heights of the waves over four standard deviations; a cell is the length of the highest wave.
NoiseSample seaSample(const NoiseTable& t, const ParameterValues& values)
{
    std::vector<SeaWave> waves =
        seaWaves(values[t.windSpeed], values[t.windDirection], 64, static_cast<std::uint32_t>(values[t.seed]));
    waves.resize(std::min(waves.size(), static_cast<std::size_t>(values[t.waves])));
    double variance = 0;
    SeaWave highest = waves.front();
    for (const SeaWave& w : waves) {
        variance += 0.5 * w.amplitude * w.amplitude;
        if (w.amplitude > highest.amplitude) highest = w;
    }
    const double cell = 2 * pi / glm::length(highest.vector);
    const double unit = 4 * std::sqrt(variance);
    return [waves = std::move(waves), cell, unit](const glm::dvec3& p) {
        double height = 0;
        for (const SeaWave& w : waves)
            height += w.amplitude * std::cos(cell * glm::dot(w.vector, {p.x, p.z}) + w.phase);
        return height / unit;
    };
}

/// Returns the reference's value noise, from which all its works are made.
NoiseSample sourceSample(NoiseWork work)
{
    const bool octaves = work != NoiseWork::field;
    const glsl::NoiseSum sum{glsl::NOISE_VALUE, glsl::NOISE_FBM, octaves ? 5 : 1, 0.5, 2, 0, 0, 1};
    return [sum](const glm::dvec3& p) { return glsl::noiseSum(sum, p, 0).value; };
}

NoiseSample sampleOnShow(const NoiseTable& t, const ParameterValues& values)
{
    const NoiseWork work = values[t.work];
    if (values[t.look] == NoiseLook::reference) return sourceSample(work);
    const auto seed = static_cast<glm::uint>(values[t.seed]);
    if (work == NoiseWork::sea) return seaSample(t, values);
    if (work == NoiseWork::clouds)
        return [seed, octaves = values[t.cloudOctaves]](const glm::dvec3& p) {
            return 2 * glsl::cloudNoiseAt(glm::fract(p / 4.0), seed, octaves).x - 1;
        };
    const glsl::NoiseSum sum = sumOnShow(t, values);
    const double warp = work == NoiseWork::fractal ? values[t.warp] : 0;
    return [sum, warp](const glm::dvec3& p) {
        return (warp > 0 ? glsl::noiseWarpedSum(sum, p, warp, 0) : glsl::noiseSum(sum, p, 0)).value;
    };
}

}  // namespace

ChartCurve noiseHistogram(const std::string& name, const NoiseSample& noise)
{
    constexpr int bins = 40, points = 20000;
    ChartCurve curve{name, {}, std::vector<double>(bins, 0)};
    for (int i = 0; i < bins; ++i) curve.x.push_back(-1 + (i + 0.5) * 2 / bins);
    for (int i = 0; i < points; ++i) {
        const double at = (noise(samplePoint(i, 1)) + 1) / 2 * bins;
        curve.y[static_cast<std::size_t>(std::clamp(at, 0.0, bins - 1.0))] += bins / 2.0 / points;
    }
    return curve;
}

ChartCurve noiseSpectrum(const std::string& name, const NoiseSample& noise)
{
    constexpr int count = 256, perCell = 8, lines = 48;
    std::vector<double> power(count / 2, 0);
    double sum = 0;
    for (int line = 0; line < lines; ++line) {
        const glm::dvec3 from = samplePoint(line, 2);
        const glm::dvec3 step = sampleDirection(line) / static_cast<double>(perCell);
        std::vector<std::complex<double>> values;
        std::complex<double> mean = 0;
        for (int i = 0; i < count; ++i) {
            values.emplace_back(noise(from + static_cast<double>(i) * step));
            mean += values.back() / static_cast<double>(count);
        }
        for (int i = 0; i < count; ++i) {
            std::complex<double>& value = values[static_cast<std::size_t>(i)];
            value = (value - mean) * (0.5 - 0.5 * std::cos(2 * pi * i / count));
        }
        transform(values);
        for (std::size_t i = 1; i < power.size(); ++i) {
            power[i] += std::norm(values[i]);
            sum += std::norm(values[i]);
        }
    }
    ChartCurve curve{name, {}, {}};
    constexpr double width = static_cast<double>(perCell) / count;  // Waves per cell between two frequencies.
    for (std::size_t i = 2; i < power.size(); ++i) {
        curve.x.push_back(width * static_cast<double>(i));
        curve.y.push_back(sum > 1e-12 ? power[i] / sum / width : 0);
    }
    return curve;
}

ChartCurve noiseIsotropy(const std::string& name, const NoiseSample& noise)
{
    constexpr int directions = 36, points = 1200;
    constexpr double step = 0.25;
    ChartCurve curve{name, {}, {}};
    double sum = 0;
    std::vector<double> here;
    for (int i = 0; i < points; ++i) here.push_back(noise(samplePoint(i, 3)));
    for (int k = 0; k <= directions; ++k) {
        const double angle = pi * k / directions;
        const glm::dvec3 way(step * std::cos(angle), 0, step * std::sin(angle));
        double squares = 0;
        for (int i = 0; i < points; ++i) {
            const double change = noise(samplePoint(i, 3) + way) - here[static_cast<std::size_t>(i)];
            squares += change * change / points;
        }
        curve.x.push_back(180.0 * k / directions);
        curve.y.push_back(squares);
        if (k < directions) sum += squares / directions;  // 180 degrees is the same direction as 0.
    }
    for (double& y : curve.y) y = sum > 0 ? y / sum : 1;
    return curve;
}

std::vector<Chart> noiseCharts(const NoiseTable& t, const ParameterValues& values)
{
    const NoiseSample now = sampleOnShow(t, values);
    const NoiseSample then = sourceSample(values[t.work]);
    const std::string shown = "on show", reference = "reference";
    return {{"Histogram", "value", "density", false, {noiseHistogram(shown, now), noiseHistogram(reference, then)}},
            {"Spectrum",
             "waves per cell",
             "share of the variance, cells",
             true,
             {noiseSpectrum(shown, now), noiseSpectrum(reference, then)}},
            {"Isotropy",
             "direction, °",
             "change squared over its mean",
             false,
             {noiseIsotropy(shown, now), noiseIsotropy(reference, then)}}};
}

}  // namespace vitrine::noise
