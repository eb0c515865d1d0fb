#pragma once

#include "render/files/file_ops.h"
#include "render/image/image.h"
#include "render/image/video_codec.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render {

/// Returns the format of the name's extension: .mp4, .webm, .gif, .webp, .apng; nothing for others.
[[nodiscard]] std::optional<VideoFormat> videoFormatOf(const std::filesystem::path&);
/// All extensions of videos, as `ParameterInfo::extensions` has them: "mp4 webm".
[[nodiscard]] std::string videoEndings();

/// Returns why such a video cannot be made, as a full sentence with an alternative; empty if it can. Videos in 4:2:0
/// (.mp4, .webm) need even sizes, .gif allows at most 50 frames a second, and only .webm, .webp and .apng can be
/// transparent.
[[nodiscard]] std::string whyNoVideo(const VideoSpec&);

class PartFile;

/// A video that is written beside its target and replaces it when it is finished. If anything fails, or if it is
/// destroyed before, the old file is unchanged and no temporary file remains.
///
/// Colors are tagged as sRGB with Rec. 709 primaries. If they are stored as luma and chroma, the matrix is that of Rec.
/// 709, in video range. The comment is the container's comment; in .apng the text "vitrine:preset" that pictures have,
/// in .gif a comment extension, in .webp a chunk "VTRN" at its end.
class VideoFile {
public:
    /// Throws Failure: ErrorKind::usage if `whyNoVideo` refuses it, ErrorKind::file if nothing can be written there.
    VideoFile(const std::filesystem::path&, const VideoSpec&, FileOps& = systemFileOps());
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    /// Adds the next frame: linear light, of the given size, with at least the required channels. Throws Failure naming
    /// file and cause.
    void add(const Image&);
    /// Replaces the target by the finished video. Throws Failure as `add`.
    void finish();
    /// Returns the finished video beside its target, to be published later together with other files. The last call.
    [[nodiscard]] std::unique_ptr<PartFile> staged();

private:
    class Output;
    struct State;
    void require(const std::string& problem);

    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
