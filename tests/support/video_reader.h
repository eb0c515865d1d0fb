#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::test {

/// Content of a video as FFmpeg reads it.
struct ReadVideo {
    std::string codec;  ///< Name of the codec, such as "h264".
    std::string comment;
    std::string primaries, transfer, matrix;  ///< Color properties of the decoded frames, such as "bt709".
    int width = 0, height = 0;
    std::vector<double> times;                      ///< Times of the frames in seconds.
    std::vector<std::vector<std::uint8_t>> frames;  ///< RGBA, sRGB-encoded, row 0 at the top.
};

/// Reads a video. Throws std::runtime_error if that is impossible.
[[nodiscard]] ReadVideo readVideo(const std::filesystem::path&);

}  // namespace vitrine::test
