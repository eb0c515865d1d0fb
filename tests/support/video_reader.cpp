#include "tests/support/video_reader.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavformat/avformat.h>
#include <libavutil/log.h>
#include <libavutil/pixdesc.h>
}

#include <stdexcept>

namespace vitrine::test {
namespace {

void must(int result, const char* doing)
{
    if (result < 0) throw std::runtime_error(std::string(doing) + ": " + std::to_string(result));
}

std::string known(const char* name)
{
    return name ? name : "";
}

/// Converts a frame to RGBA with FFmpeg's filter.
std::vector<std::uint8_t> rgba(const AVFrame* frame)
{
    AVFilterGraph* graph = avfilter_graph_alloc();
    AVFilterContext *source = nullptr, *scale = nullptr, *format = nullptr, *sink = nullptr;
    const std::string arguments = "video_size=" + std::to_string(frame->width) + 'x' + std::to_string(frame->height) +
                                  ":pix_fmt=" + std::to_string(frame->format) + ":time_base=1/1000:pixel_aspect=1/1";
    must(avfilter_graph_create_filter(&source, avfilter_get_by_name("buffer"), "in", arguments.c_str(), nullptr, graph),
         "buffer");
    must(avfilter_graph_create_filter(&scale, avfilter_get_by_name("scale"), "scale",
                                      "in_color_matrix=bt709:flags=bicubic+accurate_rnd+full_chroma_int", nullptr,
                                      graph),
         "scale");
    must(avfilter_graph_create_filter(&format, avfilter_get_by_name("format"), "format", "pix_fmts=rgba", nullptr,
                                      graph),
         "format");
    must(avfilter_graph_create_filter(&sink, avfilter_get_by_name("buffersink"), "out", nullptr, nullptr, graph),
         "sink");
    must(avfilter_link(source, 0, scale, 0), "link");
    must(avfilter_link(scale, 0, format, 0), "link");
    must(avfilter_link(format, 0, sink, 0), "link");
    must(avfilter_graph_config(graph, nullptr), "config");
    AVFrame* in = av_frame_clone(frame);
    must(av_buffersrc_add_frame(source, in), "in");
    av_frame_free(&in);
    AVFrame* out = av_frame_alloc();
    must(av_buffersink_get_frame(sink, out), "out");
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < out->height; ++y) {
        const std::uint8_t* row = out->data[0] + static_cast<std::ptrdiff_t>(y) * out->linesize[0];
        pixels.insert(pixels.end(), row, row + static_cast<std::ptrdiff_t>(out->width) * 4);
    }
    av_frame_free(&out);
    avfilter_graph_free(&graph);
    return pixels;
}

void take(AVCodecContext* decoder, AVFrame* frame, AVRational timeBase, ReadVideo& video)
{
    while (avcodec_receive_frame(decoder, frame) == 0) {
        video.width = frame->width;
        video.height = frame->height;
        video.primaries = known(av_color_primaries_name(frame->color_primaries));
        video.transfer = known(av_color_transfer_name(frame->color_trc));
        video.matrix = known(av_color_space_name(frame->colorspace));
        video.times.push_back(static_cast<double>(frame->best_effort_timestamp) * av_q2d(timeBase));
        video.frames.push_back(rgba(frame));
    }
}

}  // namespace

ReadVideo readVideo(const std::filesystem::path& path)
{
    av_log_set_level(AV_LOG_QUIET);
    ReadVideo video;
    AVFormatContext* file = nullptr;
    must(avformat_open_input(&file, path.c_str(), nullptr, nullptr), "open");
    must(avformat_find_stream_info(file, nullptr), "streams");
    const AVDictionaryEntry* comment = av_dict_get(file->metadata, "comment", nullptr, 0);
    if (comment) video.comment = comment->value;
    const AVStream* stream = file->streams[0];
    // FFmpeg's own decoder of VP9 leaves the opacity out.
    const bool hasOpacity = av_dict_get(stream->metadata, "alpha_mode", nullptr, 0) != nullptr;
    const AVCodec* codec =
        hasOpacity ? avcodec_find_decoder_by_name("libvpx-vp9") : avcodec_find_decoder(stream->codecpar->codec_id);
    if (!codec) throw std::runtime_error("no decoder");
    video.codec = codec->name;
    AVCodecContext* decoder = avcodec_alloc_context3(codec);
    must(avcodec_parameters_to_context(decoder, stream->codecpar), "parameters");
    must(avcodec_open2(decoder, codec, nullptr), "decoder");
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    while (av_read_frame(file, packet) == 0) {
        must(avcodec_send_packet(decoder, packet), "decode");
        av_packet_unref(packet);
        take(decoder, frame, stream->time_base, video);
    }
    must(avcodec_send_packet(decoder, nullptr), "end");
    take(decoder, frame, stream->time_base, video);
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&decoder);
    avformat_close_input(&file);
    return video;
}

}  // namespace vitrine::test
