#pragma once

#include "render/image/stored_picture.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace vitrine::render {

/// `mp4`: H.264 where the machine's FFmpeg has it, else MPEG-4; `webm`: VP9; `gif`: a palette for every frame; `webp`
/// and `apng`: animated and lossless.
enum class VideoFormat : std::uint8_t { mp4, webm, gif, webp, apng };

/// Frames of one size, at steady times.
struct VideoSpec {
    VideoFormat format = VideoFormat::mp4;
    int width = 0, height = 0;
    double framesPerSecond = 30;
    bool transparent = false;  ///< RGBA; only `webp` and `apng`. Otherwise RGB.
    std::string comment{};     ///< Text that the file carries, UTF-8; none when empty.
};

/// Where the bytes of a video go. Functions are called from the thread that calls VideoFrames.
class VideoOutput {
public:
    virtual ~VideoOutput() = default;
    /// All of them, at the present place; false when that failed.
    [[nodiscard]] virtual bool write(const void* bytes, std::size_t count) noexcept = 0;
    /// To `offset` from the file's beginning; false when that failed.
    [[nodiscard]] virtual bool seek(std::int64_t offset) noexcept = 0;
};

/// A video that is being written. Each function returns a half sentence on what went wrong, empty when nothing did.
class VideoFrames {
public:
    virtual ~VideoFrames() = default;
    /// The next frame: 8 bits per channel, sRGB-encoded, row 0 at the top, alpha not premultiplied, no padding.
    [[nodiscard]] virtual std::string add(const std::uint8_t* pixels) noexcept = 0;
    /// After the last frame.
    [[nodiscard]] virtual std::string close() noexcept = 0;
};

/// What the FFmpeg module does for the rest; as OiioCodec, it is a library of its own that is opened when the first
/// video asks for it.
class VideoCodec {
public:
    virtual ~VideoCodec() = default;
    /// `path` is where `output` writes, so that it can be read again; `output` must outlive the result.
    [[nodiscard]] virtual std::string open(const VideoSpec&, const std::string& path, VideoOutput& output,
                                           std::unique_ptr<VideoFrames>& out) noexcept = 0;
    /// The comment of an .mp4 or .webm; empty where there is none. Reads no frames. Returns a half sentence on what
    /// went wrong, empty when nothing did.
    [[nodiscard]] virtual std::string readComment(const std::string& path, VideoFormat, std::string& out) noexcept = 0;
    /// Unpacks the bytes of a BMP, or of a GIF with one picture, to codes of 8 bits: gray, RGB or RGBA, row 0 at the
    /// top. The header has been looked at: its size is bearable. Returns as `readComment`.
    [[nodiscard]] virtual std::string readStill(std::string_view bytes, bool isGif, StoredPicture& out) noexcept = 0;
    /// "59.37.100", of the libavcodec that runs.
    [[nodiscard]] virtual const char* libraryVersion() const noexcept = 0;
};

/// Opens the module `vitrine_video` on the first call, from any thread. Throws Failure when it cannot be opened.
[[nodiscard]] VideoCodec& videoCodec();

}  // namespace vitrine::render

/// The one symbol of the module. `version` must be `vitrineVideoVersion`; otherwise the answer is null.
inline constexpr int vitrineVideoVersion = 3;
extern "C" vitrine::render::VideoCodec* vitrineVideo(int version);
