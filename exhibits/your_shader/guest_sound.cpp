#include "exhibits/your_shader/guest_sound.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace vitrine::guest {
namespace {

using Complex = std::complex<double>;

/// Returns the last `count` samples of a channel before a time, the oldest first. Before time 0 there is silence.
std::vector<double> samplesBefore(const render::Sound& sound, int channel, std::size_t count, double seconds)
{
    std::vector<double> samples(count, 0);
    const auto end = static_cast<std::int64_t>(std::floor(seconds * sound.rate + 1e-6));
    const auto channels = static_cast<std::size_t>(sound.channels);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t at = end - static_cast<std::int64_t>(count - i);
        if (at < 0) continue;
        const std::size_t index = static_cast<std::size_t>(at) % sound.length();
        samples[i] = sound.samples[index * channels + static_cast<std::size_t>(channel)];
    }
    return samples;
}

/// Transforms in place. The size is a power of two. Source: Cooley and Tukey 1965.
void fourier(std::vector<Complex>& values)
{
    const std::size_t size = values.size();
    for (std::size_t i = 1, j = 0; i < size; ++i) {
        std::size_t bit = size >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t length = 2; length <= size; length *= 2)
        for (std::size_t begin = 0; begin < size; begin += length)
            for (std::size_t k = 0; k < length / 2; ++k) {
                const double angle = -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length);
                const Complex odd = values[begin + k + length / 2] * std::polar(1.0, angle);
                const Complex even = values[begin + k];
                values[begin + k] = even + odd;
                values[begin + k + length / 2] = even - odd;
            }
}

/// Returns the largest amplitude in each of `columns` bands.
std::vector<double> amplitudes(const std::vector<double>& samples, std::size_t columns)
{
    const std::size_t size = samples.size();
    std::vector<Complex> values(size);
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const double hann =
            0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size));
        values[i] = samples[i] * hann;
        sum += hann;
    }
    fourier(values);
    std::vector<double> bands(columns, 0);
    for (std::size_t i = 0; i < size / 2; ++i) {
        double& band = bands[i * columns / (size / 2)];
        band = std::max(band, std::min(2 * std::abs(values[i]) / sum, 1.0));
    }
    return bands;
}

std::shared_ptr<render::Texture> emptyPicture(const render::Sound* sound, int columns)
{
    auto picture = std::make_shared<render::Texture>();
    picture->name = "sound";
    picture->width = std::clamp(columns, 1, mostSoundColumns);
    picture->height = sound ? sound->channels : 1;
    picture->channels = 1;
    picture->repeat = picture->mipmaps = false;
    return picture;
}

}  // namespace

std::shared_ptr<const render::Texture> waveformPicture(const render::Sound* sound, int columns, double seconds)
{
    const auto picture = emptyPicture(sound, columns);
    const auto width = static_cast<std::size_t>(picture->width);
    if (!sound) picture->floats.assign(width, 0.5F);
    for (int channel = 0; sound && channel < sound->channels; ++channel)
        for (const double sample : samplesBefore(*sound, channel, width, seconds))
            picture->floats.push_back(static_cast<float>(0.5 + 0.5 * sample));
    return picture;
}

std::shared_ptr<const render::Texture> spectrumPicture(const render::Sound* sound, int columns, double seconds)
{
    const auto picture = emptyPicture(sound, columns);
    const auto width = static_cast<std::size_t>(picture->width);
    if (!sound) picture->floats.assign(width, 0.0F);
    constexpr std::size_t leastSize = 1024;
    const std::size_t size = std::max(std::bit_ceil(2 * width), leastSize);
    for (int channel = 0; sound && channel < sound->channels; ++channel)
        for (const double amplitude : amplitudes(samplesBefore(*sound, channel, size, seconds), width))
            picture->floats.push_back(static_cast<float>(amplitude));
    return picture;
}

}  // namespace vitrine::guest
