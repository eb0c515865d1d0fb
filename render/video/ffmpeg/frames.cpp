#include "render/video/ffmpeg/frames.h"

#include "render/video/ffmpeg/decoder.h"
#include "render/video/ffmpeg/guarded.h"

extern "C" {
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
}

#include <cstring>
#include <utility>
#include <vector>

namespace vitrine::render::ffmpeg {
namespace {

constexpr const char* formats = "mov,mp4,matroska,webm,avi,apng,mpegts";
constexpr const char* lacks = "it has no video that this machine's FFmpeg can decode";
constexpr int smallestHighDefinition = 720;  // Rows from which a video without a matrix has that of Rec. 709.

/// Converts the frames of a video to codes of red, green and blue.
class ToRgb {
public:
    explicit ToRgb(const AVFrame& first)
    {
        graph_.reset(checked("starting the filters", avfilter_graph_alloc()));
        const std::string size = std::to_string(first.width) + 'x' + std::to_string(first.height);
        source_ =
            node("buffer", "in",
                 "video_size=" + size + ":pix_fmt=" + std::to_string(first.format) + ":time_base=1/1:pixel_aspect=1/1");
        AVFilterContext* scale = node("scale", "scale", "flags=bicubic+accurate_rnd+full_chroma_int");
        AVFilterContext* format = node("format", "format", "pix_fmts=rgb24");
        sink_ = node("buffersink", "out", {});
        readable(avfilter_link(source_, 0, scale, 0));
        readable(avfilter_link(scale, 0, format, 0));
        readable(avfilter_link(format, 0, sink_, 0));
        readable(avfilter_graph_config(graph_.get(), nullptr));
    }

    StoredPicture picture(const AVFrame& frame)
    {
        const Owned<AVFrame> in(checked("reading a frame", av_frame_clone(&frame)));
        if (in->colorspace == AVCOL_SPC_UNSPECIFIED)
            in->colorspace = in->height >= smallestHighDefinition ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
        in->sample_aspect_ratio = {1, 1};
        readable(av_buffersrc_add_frame(source_, in.get()));
        const Owned<AVFrame> out(checked("reading a frame", av_frame_alloc()));
        readable(av_buffersink_get_frame(sink_, out.get()));
        StoredPicture picture;
        picture.width = out->width;
        picture.height = out->height;
        picture.channels = 3;
        std::vector<std::uint8_t> codes(picture.sampleCount());
        for (int y = 0; y < out->height; ++y)
            std::memcpy(codes.data() + static_cast<std::size_t>(y) * picture.rowSamples(),
                        out->data[0] + static_cast<std::ptrdiff_t>(y) * out->linesize[0], picture.rowSamples());
        picture.samples = std::move(codes);
        return picture;
    }

private:
    AVFilterContext* node(const char* name, const char* instance, const std::string& arguments)
    {
        AVFilterContext* made = nullptr;
        readable(avfilter_graph_create_filter(&made, checked("finding a filter", avfilter_get_by_name(name)), instance,
                                              arguments.empty() ? nullptr : arguments.c_str(), nullptr, graph_.get()));
        return made;
    }

    Owned<AVFilterGraph> graph_;
    AVFilterContext* source_ = nullptr;
    AVFilterContext* sink_ = nullptr;
};

class Reader final : public VideoReader {
public:
    explicit Reader(const std::string& path) : decoder_(path, formats, AVMEDIA_TYPE_VIDEO, lacks) {}

    std::string skip() noexcept override
    {
        return guarded([&] { static_cast<void>(decoder_.next()); });
    }
    std::string next(StoredPicture& out, bool& isEnd) noexcept override
    {
        return guarded([&] {
            const AVFrame* frame = decoder_.next();
            isEnd = frame == nullptr;
            if (!frame) return;
            if (!rgb_ || frame->width != width_ || frame->height != height_ || frame->format != format_) {
                rgb_ = std::make_unique<ToRgb>(*frame);
                width_ = frame->width;
                height_ = frame->height;
                format_ = frame->format;
            }
            out = rgb_->picture(*frame);
            out.orientation = decoder_.orientation();
        });
    }

private:
    Decoder decoder_;
    std::unique_ptr<ToRgb> rgb_;
    int width_ = 0, height_ = 0, format_ = -1;
};

}  // namespace

std::unique_ptr<VideoReader> readerOf(const std::string& path)
{
    return std::make_unique<Reader>(path);
}

std::size_t framesOf(const std::string& path)
{
    return Decoder(path, formats, AVMEDIA_TYPE_VIDEO, lacks).countPackets();
}

}  // namespace vitrine::render::ffmpeg
