#pragma once

#include "render/files/file_ops.h"
#include "render/image/image.h"
#include "render/video/video_codec.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render {

/// By the name's ending: .mp4, .webm, .gif, .webp, .apng; nothing otherwise.
[[nodiscard]] std::optional<VideoFormat> videoFormatOf(const std::filesystem::path&);

/// Why there is no such video, as a full sentence that says what to ask for instead; empty: there is. Videos of 4:2:0
/// (.mp4, .webm) need even sizes, .gif at most 50 frames a second, and only .webp and .apng can be transparent.
[[nodiscard]] std::string whyNoVideo(const VideoSpec&);

/// A video that is written beside its target and takes its place when it is finished: whatever fails, or when it is
/// destroyed before, the old file stands and nothing is left behind.
///
/// Colors are tagged as sRGB with Rec. 709 primaries, and the matrix of Rec. 709 in video range where they are stored
/// as luma and chroma. The comment is the container's comment; in .apng the text "vitrine:preset" that pictures have,
/// in .gif a comment extension, in .webp a chunk "VTRN" at its end.
class VideoFile {
public:
    /// Throws Failure: Blame::usage for what `whyNoVideo` refuses, Blame::file when nothing can be written there.
    VideoFile(const std::filesystem::path&, const VideoSpec&, FileOps& = systemFileOps());
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    /// The next frame: linear light, of the size and with at least the channels that were announced. Throws Failure
    /// naming file and cause.
    void add(const Image&);
    /// Puts the finished video in the target's place. Throws Failure as `add`.
    void finish();

private:
    class Output;
    struct State;
    void require(const std::string& problem);

    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
