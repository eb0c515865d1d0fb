#include "render/image/video_codec.h"
#include "render/video/ffmpeg/frames.h"
#include "render/video/ffmpeg/guarded.h"
#include "render/video/ffmpeg/output.h"
#include "render/video/ffmpeg/owned.h"
#include "render/video/ffmpeg/sound.h"
#include "render/video/ffmpeg/still.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
}

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::render::ffmpeg {
namespace {

using Options = std::vector<std::pair<const char*, const char*>>;

/// Encoder settings of a video format. The filter converts RGB to the encoder's input format.
struct Recipe {
    const char* muxer;
    std::vector<const char*> encoders;  ///< In order of preference; the first available one is used.
    const char* filter;
    Options encoding, muxing;
};

constexpr const char* toHalfChroma =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int,format=yuv420p";
/// The same with opacity, which VP9 keeps as a second picture.
constexpr const char* toHalfChromaAndAlpha =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int,format=yuva420p";

/// Smallest side in pixels of a frame that is encoded with x264's macroblock tree. With it, the x264 of Debian 13
/// (0.164.3108) is not deterministic for frames of two by two macroblocks.
constexpr int leastForMacroblockTree = 64;

/// Qualities without visible flicker and ringing: for documentation, not for an archive.
Recipe recipeOf(const VideoSpec& spec)
{
    switch (spec.format) {
    case VideoFormat::mp4:
        return {"mp4",
                {"libx264", "libopenh264", "mpeg4"},
                toHalfChroma,
                {{"crf", "18"},
                 {"preset", "medium"},
                 {"mbtree", std::min(spec.width, spec.height) < leastForMacroblockTree ? "0" : "1"},
                 {"global_quality", "354"}},
                {{"movflags", "+faststart+use_metadata_tags"}}};
    case VideoFormat::webm:
        return {"webm",
                {"libvpx-vp9", "libvpx"},
                spec.transparent ? toHalfChromaAndAlpha : toHalfChroma,
                {{"crf", "24"}, {"b", "0"}, {"deadline", "good"}, {"cpu-used", "3"}, {"row-mt", "1"}},
                {}};
    case VideoFormat::gif:
        // A palette for every frame needs no memory for all frames; ordered dither does not flicker.
        return {"gif",
                {"gif"},
                "split[a][b];[a]palettegen=stats_mode=single:reserve_transparent=0[p];"
                "[b][p]paletteuse=new=1:dither=bayer:bayer_scale=4",
                {},
                {{"loop", "0"}}};
    case VideoFormat::webp: return {"webp", {"libwebp_anim"}, "format=bgra", {{"lossless", "1"}}, {{"loop", "0"}}};
    case VideoFormat::apng:
        return {
            "apng", {"apng"}, spec.transparent ? "format=rgba" : "format=rgb24", {{"pred", "mixed"}}, {{"plays", "0"}}};
    }
    return {};
}

const AVCodec* encoderOf(const Recipe& recipe)
{
    for (const char* name : recipe.encoders)
        if (const AVCodec* codec = avcodec_find_encoder_by_name(name)) return codec;
    throw Problem{"this machine's FFmpeg has no encoder " + std::string(recipe.encoders.front())};
}

/// An FFmpeg dictionary with options. Options that an encoder does not use stay in it and are no error.
class Dictionary {
public:
    explicit Dictionary(const Options& options)
    {
        for (const auto& [key, value] : options) av_dict_set(&entries_, key, value, 0);
    }
    ~Dictionary() { av_dict_free(&entries_); }
    Dictionary(const Dictionary&) = delete;
    Dictionary& operator=(const Dictionary&) = delete;
    AVDictionary** get() { return &entries_; }

private:
    AVDictionary* entries_ = nullptr;
};

class Writer final : public VideoFrames {
public:
    Writer(const VideoSpec& spec, const std::string& path, VideoOutput& output) : spec_(spec), output_(output)
    {
        const Recipe recipe = recipeOf(spec);
        const AVCodec* codec = encoderOf(recipe);
        rate_ = av_d2q(spec.framesPerSecond, 1'000'000);
        AVFormatContext* format = nullptr;
        checked("starting the file", avformat_alloc_output_context2(&format, nullptr, recipe.muxer, path.c_str()));
        format_.reset(format);
        format_->pb = checked("starting the file", output_.context());
        format_->flags |= AVFMT_FLAG_CUSTOM_IO | AVFMT_FLAG_BITEXACT;
        openFilter(recipe);
        openEncoder(recipe, codec);
        openMuxer(recipe);
        packet_.reset(checked("starting the file", av_packet_alloc()));
        filtered_.reset(checked("starting the file", av_frame_alloc()));
    }

    std::string add(const std::uint8_t* pixels) noexcept override
    {
        return guarded([&] {
            const Owned<AVFrame> frame(checked("adding a frame", av_frame_alloc()));
            frame->format = spec_.transparent ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24;
            frame->width = spec_.width;
            frame->height = spec_.height;
            frame->pts = count_++;
            frame->color_range = AVCOL_RANGE_JPEG;
            frame->color_primaries = AVCOL_PRI_BT709;
            frame->color_trc = AVCOL_TRC_IEC61966_2_1;
            frame->colorspace = AVCOL_SPC_RGB;
            checked("adding a frame", av_frame_get_buffer(frame.get(), 0));
            const auto row = static_cast<std::size_t>(spec_.width) * (spec_.transparent ? 4 : 3);
            for (int y = 0; y < spec_.height; ++y)
                std::memcpy(frame->data[0] + static_cast<std::ptrdiff_t>(y) * frame->linesize[0],
                            pixels + static_cast<std::size_t>(y) * row, row);
            checked("adding a frame", av_buffersrc_add_frame(source_, frame.get()));
            encodeFiltered();
        });
    }

    std::string close() noexcept override
    {
        return guarded([&] {
            checked("ending the video", av_buffersrc_add_frame(source_, nullptr));
            encodeFiltered();
            encode(nullptr);
            checked("ending the video", av_write_trailer(format_.get()));
            avio_flush(format_->pb);
            checked("ending the video", format_->pb->error);
            bool good = true;
            if (!spec_.comment.empty() && spec_.format == VideoFormat::gif) good = output_.appendToGif(spec_.comment);
            if (!spec_.comment.empty() && spec_.format == VideoFormat::webp) good = output_.appendToWebp(spec_.comment);
            if (!good) throw Problem{"writing the comment failed"};
        });
    }

private:
    AVFilterContext* filterNode(const char* name, const char* instance, const std::string& arguments)
    {
        AVFilterContext* node = nullptr;
        checked("starting the filters",
                avfilter_graph_create_filter(&node, checked("finding a filter", avfilter_get_by_name(name)), instance,
                                             arguments.empty() ? nullptr : arguments.c_str(), nullptr, graph_.get()));
        return node;
    }

    void openFilter(const Recipe& recipe)
    {
        graph_.reset(checked("starting the filters", avfilter_graph_alloc()));
        const std::string size = std::to_string(spec_.width) + 'x' + std::to_string(spec_.height);
        source_ = filterNode("buffer", "in",
                             "video_size=" + size + ":pix_fmt=" + (spec_.transparent ? "rgba" : "rgb24") +
                                 ":time_base=" + std::to_string(rate_.den) + '/' + std::to_string(rate_.num) +
                                 ":frame_rate=" + std::to_string(rate_.num) + '/' + std::to_string(rate_.den) +
                                 ":pixel_aspect=1/1");
        sink_ = filterNode("buffersink", "out", {});
        AVFilterInOut* from = checked("starting the filters", avfilter_inout_alloc());
        AVFilterInOut* to = avfilter_inout_alloc();
        if (to) {
            *from = {av_strdup("in"), source_, 0, nullptr};
            *to = {av_strdup("out"), sink_, 0, nullptr};
        }
        const int parsed =
            to ? avfilter_graph_parse_ptr(graph_.get(), recipe.filter, &to, &from, nullptr) : AVERROR(ENOMEM);
        avfilter_inout_free(&from);
        avfilter_inout_free(&to);
        checked("starting the filters", parsed);
        checked("starting the filters", avfilter_graph_config(graph_.get(), nullptr));
    }

    void openEncoder(const Recipe& recipe, const AVCodec* codec)
    {
        encoder_.reset(checked("starting the encoder", avcodec_alloc_context3(codec)));
        AVCodecContext& e = *encoder_;
        const auto pixels = static_cast<AVPixelFormat>(av_buffersink_get_format(sink_));
        const bool isYuv = (av_pix_fmt_desc_get(pixels)->flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL)) == 0;
        e.width = spec_.width;
        e.height = spec_.height;
        e.pix_fmt = pixels;
        e.time_base = av_inv_q(rate_);
        e.framerate = rate_;
        e.sample_aspect_ratio = {1, 1};
        e.color_primaries = AVCOL_PRI_BT709;
        e.color_trc = AVCOL_TRC_IEC61966_2_1;
        e.colorspace = isYuv ? AVCOL_SPC_BT709 : AVCOL_SPC_RGB;
        e.color_range = isYuv ? AVCOL_RANGE_MPEG : AVCOL_RANGE_JPEG;
        e.flags |= AV_CODEC_FLAG_BITEXACT;
        if (std::strcmp(codec->name, "mpeg4") == 0) e.flags |= AV_CODEC_FLAG_QSCALE;
        if ((format_->oformat->flags & AVFMT_GLOBALHEADER) != 0) e.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
        Dictionary options(recipe.encoding);
        // Lossless formats would take the global quality as effort, and H.264 as quantizer.
        if (std::strcmp(codec->name, "mpeg4") != 0) av_dict_set(options.get(), "global_quality", nullptr, 0);
        checked("starting the encoder", avcodec_open2(&e, codec, options.get()));
    }

    void openMuxer(const Recipe& recipe)
    {
        stream_ = checked("starting the file", avformat_new_stream(format_.get(), nullptr));
        stream_->time_base = encoder_->time_base;
        stream_->avg_frame_rate = rate_;
        checked("starting the file", avcodec_parameters_from_context(stream_->codecpar, encoder_.get()));
        if (!spec_.comment.empty()) {
            av_dict_set(&format_->metadata, "comment", spec_.comment.c_str(), 0);
            if (spec_.format == VideoFormat::apng) output_.insertAfterHeader(pngText("vitrine:preset", spec_.comment));
        }
        Dictionary options(recipe.muxing);
        checked("starting the file", avformat_write_header(format_.get(), options.get()));
    }

    void encodeFiltered()
    {
        for (;;) {
            const int got = av_buffersink_get_frame(sink_, filtered_.get());
            if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return;
            checked("converting a frame", got);
            filtered_->pts = av_rescale_q(filtered_->pts, av_buffersink_get_time_base(sink_), encoder_->time_base);
            filtered_->pict_type = AV_PICTURE_TYPE_NONE;
            encode(filtered_.get());
            av_frame_unref(filtered_.get());
        }
    }

    /// Encodes a frame. Null: flushes the frames that the encoder still holds.
    void encode(const AVFrame* frame)
    {
        checked("encoding a frame", avcodec_send_frame(encoder_.get(), frame));
        for (;;) {
            const int got = avcodec_receive_packet(encoder_.get(), packet_.get());
            if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return;
            checked("encoding a frame", got);
            if (packet_->duration == 0) packet_->duration = 1;
            packet_->stream_index = 0;
            av_packet_rescale_ts(packet_.get(), encoder_->time_base, stream_->time_base);
            checked("writing a frame", av_interleaved_write_frame(format_.get(), packet_.get()));
        }
    }

    VideoSpec spec_;
    AVRational rate_{30, 1};
    MuxedOutput output_;
    Owned<AVFormatContext> format_;
    Owned<AVFilterGraph> graph_;
    Owned<AVCodecContext> encoder_;
    Owned<AVPacket> packet_;
    Owned<AVFrame> filtered_;
    AVFilterContext* source_ = nullptr;
    AVFilterContext* sink_ = nullptr;
    AVStream* stream_ = nullptr;
    std::int64_t count_ = 0;
};

class Codec final : public VideoCodec {
public:
    Codec()
    {
        av_log_set_level(AV_LOG_QUIET);  // The caller reports errors.
        const unsigned version = avcodec_version();
        version_ = std::to_string(AV_VERSION_MAJOR(version)) + '.' + std::to_string(AV_VERSION_MINOR(version)) + '.' +
                   std::to_string(AV_VERSION_MICRO(version));
    }
    std::string open(const VideoSpec& spec, const std::string& path, VideoOutput& output,
                     std::unique_ptr<VideoFrames>& out) noexcept override
    {
        return guarded([&] { out = std::make_unique<Writer>(spec, path, output); });
    }
    std::string readComment(const std::string& path, VideoFormat format, std::string& out) noexcept override
    {
        return guarded([&] {
            const char* name = format == VideoFormat::webm ? "matroska" : "mov";
            const AVInputFormat* demuxer = av_find_input_format(name);
            if (!demuxer) throw Problem{"this machine's FFmpeg cannot read the format"};
            // Opens only this file, whatever other files it refers to.
            Dictionary options(Options{{"protocol_whitelist", "file"}});
            AVFormatContext* opened = nullptr;
            checked("opening it", avformat_open_input(&opened, ("file:" + path).c_str(), demuxer, options.get()));
            const AVDictionaryEntry* comment = av_dict_get(opened->metadata, "comment", nullptr, 0);
            if (comment) out = comment->value;
            avformat_close_input(&opened);
        });
    }
    std::string readStill(std::string_view bytes, bool isGif, StoredPicture& out) noexcept override
    {
        return guarded([&] { out = stillPicture(bytes, isGif); });
    }
    std::string readSound(const std::string& path, Sound& out) noexcept override
    {
        return guarded([&] { out = soundOf(path); });
    }
    std::string countFrames(const std::string& path, std::size_t& out) noexcept override
    {
        return guarded([&] { out = framesOf(path); });
    }
    std::string openReader(const std::string& path, std::unique_ptr<VideoReader>& out) noexcept override
    {
        return guarded([&] { out = readerOf(path); });
    }
    [[nodiscard]] const char* libraryVersion() const noexcept override { return version_.c_str(); }

private:
    std::string version_;
};

}  // namespace
}  // namespace vitrine::render::ffmpeg

extern "C" __attribute__((visibility("default"))) vitrine::render::VideoCodec* vitrineVideo(int version)
{
    static vitrine::render::ffmpeg::Codec codec;
    return version == vitrineVideoVersion ? &codec : nullptr;
}
