#pragma once

#include "render/image/sound.h"
#include "render/image/stored_picture.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace vitrine::render {

/// `mp4`: H.264 if FFmpeg has an encoder for it, else MPEG-4. `webm`: VP9. `gif`: a palette for every frame. `webp` and
/// `apng`: animated and lossless.
enum class VideoFormat : std::uint8_t { mp4, webm, gif, webp, apng };

/// Options of a video: frames of one size at a constant rate.
struct VideoSpec {
    VideoFormat format = VideoFormat::mp4;
    int width = 0, height = 0;
    double framesPerSecond = 30;
    bool transparent = false;  ///< RGBA; only `webm`, `webp` and `apng`. Otherwise RGB.
    std::string comment{};     ///< Text stored in the file, UTF-8; empty: none.
};

/// Destination of the bytes of a video. The functions are called on the thread that calls VideoFrames.
class VideoOutput {
public:
    virtual ~VideoOutput() = default;
    /// Writes all bytes at the current position; returns false on failure.
    [[nodiscard]] virtual bool write(const void* bytes, std::size_t count) noexcept = 0;
    /// Moves to `offset` from the file's beginning; returns false on failure.
    [[nodiscard]] virtual bool seek(std::int64_t offset) noexcept = 0;
};

/// Writer of a video. Each function returns a half sentence that says what went wrong; empty: success.
class VideoFrames {
public:
    virtual ~VideoFrames() = default;
    /// Adds the next frame: 8 bits per channel, sRGB-encoded, row 0 at the top, alpha not premultiplied, no padding.
    [[nodiscard]] virtual std::string add(const std::uint8_t* pixels) noexcept = 0;
    /// Finishes the video; call it after the last frame.
    [[nodiscard]] virtual std::string close() noexcept = 0;
};

/// Reader of the frames of a video, in order. Each function returns a half sentence that says what went wrong; empty:
/// success.
class VideoReader {
public:
    virtual ~VideoReader() = default;
    /// Passes over the next frame.
    [[nodiscard]] virtual std::string skip() noexcept = 0;
    /// Reads the next frame as 8-bit codes of red, green and blue, row 0 at the top. `isEnd`: there is none.
    [[nodiscard]] virtual std::string next(StoredPicture& out, bool& isEnd) noexcept = 0;
};

/// Interface of the FFmpeg module. Like OiioCodec, it is in a library of its own, which is opened on first use.
class VideoCodec {
public:
    virtual ~VideoCodec() = default;
    /// Starts a video. `path` is the file that `output` writes, so that it can be read again; `output` must outlive the
    /// result.
    [[nodiscard]] virtual std::string open(const VideoSpec&, const std::string& path, VideoOutput& output,
                                           std::unique_ptr<VideoFrames>& out) noexcept = 0;
    /// Reads the comment of an .mp4 or .webm; empty if there is none. Reads no frames. Returns a half sentence that
    /// says what went wrong; empty: success.
    [[nodiscard]] virtual std::string readComment(const std::string& path, VideoFormat, std::string& out) noexcept = 0;
    /// Decodes the bytes of a BMP, or of a GIF with one picture, to 8-bit codes: gray, RGB or RGBA, row 0 at the top.
    /// The caller must have checked the size in the header. Returns the problem like `readComment`.
    [[nodiscard]] virtual std::string readStill(std::string_view bytes, bool isGif, StoredPicture& out) noexcept = 0;
    /// Decodes a WAV or FLAC file. Returns the problem like `readComment`.
    [[nodiscard]] virtual std::string readSound(const std::string& path, Sound& out) noexcept = 0;
    /// Counts the frames of a video without decoding them. Returns the problem like `readComment`.
    [[nodiscard]] virtual std::string countFrames(const std::string& path, std::size_t& out) noexcept = 0;
    /// Opens a video to read its frames. Returns the problem like `readComment`.
    [[nodiscard]] virtual std::string openReader(const std::string& path,
                                                 std::unique_ptr<VideoReader>& out) noexcept = 0;
    /// Version of the loaded libavcodec: "59.37.100".
    [[nodiscard]] virtual const char* libraryVersion() const noexcept = 0;
};

/// Opens the module `vitrine_video` on the first call. Thread-safe. Throws Failure if it cannot be opened.
[[nodiscard]] VideoCodec& videoCodec();

}  // namespace vitrine::render

/// The module's only exported symbol. Returns null unless `version` is `vitrineVideoVersion`.
inline constexpr int vitrineVideoVersion = 5;
extern "C" vitrine::render::VideoCodec* vitrineVideo(int version);
