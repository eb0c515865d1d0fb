#pragma once

#include "render/image/video_codec.h"

#include <string>

extern "C" {
#include <libavformat/avio.h>
}

namespace vitrine::render::ffmpeg {

/// Output of a muxer: passes its bytes on, and inserts the file's comment for formats whose muxer cannot write one.
class MuxedOutput {
public:
    explicit MuxedOutput(VideoOutput& output);
    ~MuxedOutput();
    MuxedOutput(const MuxedOutput&) = delete;
    MuxedOutput& operator=(const MuxedOutput&) = delete;

    /// Null if memory ran out.
    [[nodiscard]] AVIOContext* context() { return context_; }
    /// Inserts bytes at offset 33, after the first chunk of a PNG; the muxer does not see them in its offsets.
    void insertAfterHeader(std::string bytes) { inserted_ = std::move(bytes); }
    /// Writes the comment of a GIF, or of a WebP, after the muxer has ended. Returns false if that failed.
    [[nodiscard]] bool appendToGif(const std::string& comment);
    [[nodiscard]] bool appendToWebp(const std::string& comment);

private:
    int write(const std::uint8_t* bytes, int count);
    std::int64_t seek(std::int64_t offset, int whence);
    [[nodiscard]] bool put(const std::uint8_t* bytes, std::int64_t count);

    VideoOutput& output_;
    AVIOContext* context_ = nullptr;
    std::string inserted_;
    bool insertedDone_ = false;
    std::int64_t at_ = 0, size_ = 0;  ///< Offsets as the muxer counts them.
};

/// Returns the chunk iTXt of a PNG: uncompressed UTF-8.
[[nodiscard]] std::string pngText(const std::string& key, const std::string& text);

}  // namespace vitrine::render::ffmpeg
