#pragma once

#include "render/video/ffmpeg/owned.h"

#include <memory>
#include <string>

namespace vitrine::render::ffmpeg {

/// Throws Problem with FFmpeg's reason if `result` says that a file is broken.
void readable(int result);

/// Decoder of the best stream of a kind in a file.
class Decoder {
public:
    /// Opens only this file, whatever other files it refers to. `formats`: names of FFmpeg's demuxers that may read it.
    /// `lacks`: problem if there is no such stream, as a half sentence. Throws Problem.
    Decoder(const std::string& path, const char* formats, AVMediaType kind, const char* lacks);

    /// Returns the next frame, valid until the next call; null at the end. Throws Problem.
    [[nodiscard]] const AVFrame* next();
    /// Returns the orientation of the stream's pictures, 1 to 8 as in `orient`: the nearest to its display matrix.
    [[nodiscard]] int orientation() const;
    /// Counts the packets of the stream, which are its frames in videos. Afterwards `next` returns nothing.
    [[nodiscard]] std::size_t countPackets();

private:
    struct Close {
        void operator()(AVFormatContext* opened) const { avformat_close_input(&opened); }
    };

    std::unique_ptr<AVFormatContext, Close> file_;
    int stream_ = -1;
    bool isDrained_ = false;
    Owned<AVCodecContext> codec_;
    Owned<AVFrame> frame_{checked("making a frame", av_frame_alloc())};
    Owned<AVPacket> packet_{checked("making a packet", av_packet_alloc())};
};

}  // namespace vitrine::render::ffmpeg
