#pragma once

#include "render/video/video_codec.h"

#include <string>

extern "C" {
#include <libavformat/avio.h>
}

namespace vitrine::render::ffmpeg {

/// What a muxer writes to: passes everything on, and puts the file's comment where muxers have none for it.
class MuxedOutput {
public:
    explicit MuxedOutput(VideoOutput& output);
    ~MuxedOutput();
    MuxedOutput(const MuxedOutput&) = delete;
    MuxedOutput& operator=(const MuxedOutput&) = delete;

    /// Null when there was no memory.
    [[nodiscard]] AVIOContext* context() { return context_; }
    /// Bytes to stand at offset 33, behind the first chunk of a PNG; for the muxer they are not there.
    void insertAfterHeader(std::string bytes) { inserted_ = std::move(bytes); }
    /// After the muxer's end: the comment of a GIF, or of a WebP. False when that could not be written.
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
    std::int64_t at_ = 0, size_ = 0;  ///< As the muxer counts.
};

/// The chunk iTXt of a PNG: uncompressed UTF-8.
[[nodiscard]] std::string pngText(const std::string& key, const std::string& text);

}  // namespace vitrine::render::ffmpeg
