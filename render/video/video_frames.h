#pragma once

#include "render/image/image.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>

namespace vitrine::render {

/// Extensions of the videos whose frames are read, in the form of `ParameterInfo::extensions`: "mp4 webm mov".
inline constexpr const char* readVideoEndings = "mp4 webm mov mkv avi apng";

/// Returns whether a file of this name is a video whose frames are read.
[[nodiscard]] bool isReadVideo(const std::filesystem::path&);

/// Returns the number of frames of a video, which are not decoded for it. Throws Failure naming the file.
[[nodiscard]] std::size_t countFrames(const std::filesystem::path&);

class VideoReader;

/// Frames of a video, read in any order; in rising order each is decoded once.
class VideoFrameReader {
public:
    /// Opens nothing yet.
    explicit VideoFrameReader(std::filesystem::path);
    ~VideoFrameReader();
    VideoFrameReader(const VideoFrameReader&) = delete;
    VideoFrameReader& operator=(const VideoFrameReader&) = delete;

    /// Returns a frame, counted from 0, in linear light. Nothing if the video ends before. Throws Failure naming the
    /// file.
    [[nodiscard]] std::optional<Image> frame(std::size_t number);

private:
    std::filesystem::path path_;
    std::unique_ptr<VideoReader> reader_;
    std::size_t next_ = 0;
};

}  // namespace vitrine::render
