#pragma once

#include <cstddef>
#include <vector>

namespace vitrine::render {

/// Sound in memory: samples from -1 to 1, all channels of a moment behind each other.
struct Sound {
    int rate = 44100;  ///< Samples per second of each channel.
    int channels = 1;
    std::vector<float> samples;

    /// Number of samples of each channel.
    [[nodiscard]] std::size_t length() const { return samples.size() / static_cast<std::size_t>(channels); }
};

/// Longest sound that is read, in seconds.
inline constexpr int longestSound = 600;
/// Largest number of channels that are read.
inline constexpr int mostSoundChannels = 2;

}  // namespace vitrine::render
