#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavformat/avformat.h>
}

#include <array>
#include <memory>
#include <string>

namespace vitrine::render::ffmpeg {

/// Exception used inside this module only; it never leaves the module.
struct Problem {
    std::string text;
};

[[noreturn]] inline void fail(const std::string& doing, int error)
{
    std::array<char, AV_ERROR_MAX_STRING_SIZE> why{};
    av_strerror(error, why.data(), why.size());
    throw Problem{doing + " failed (" + why.data() + ")"};
}

inline int checked(const char* doing, int result)
{
    if (result < 0) fail(doing, result);
    return result;
}

template <typename T> T* checked(const char* doing, T* made)
{
    if (!made) fail(doing, AVERROR(ENOMEM));
    return made;
}

struct Deleter {
    void operator()(AVFilterGraph* p) const { avfilter_graph_free(&p); }
    void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
    void operator()(AVFormatContext* p) const { avformat_free_context(p); }
    void operator()(AVFrame* p) const { av_frame_free(&p); }
    void operator()(AVPacket* p) const { av_packet_free(&p); }
};
template <typename T> using Owned = std::unique_ptr<T, Deleter>;

}  // namespace vitrine::render::ffmpeg
