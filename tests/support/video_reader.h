#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::test {

/// What another reader, FFmpeg's, finds in a video.
struct ReadVideo {
    std::string codec;  ///< "h264".
    std::string comment;
    std::string primaries, transfer, matrix;  ///< "bt709"; of the decoded frames.
    int width = 0, height = 0;
    std::vector<double> times;                      ///< Of the frames, seconds.
    std::vector<std::vector<std::uint8_t>> frames;  ///< RGBA, sRGB-encoded, row 0 at the top.
};

/// Throws std::runtime_error for what it cannot read.
[[nodiscard]] ReadVideo readVideo(const std::filesystem::path&);

}  // namespace vitrine::test
