#include "render/video/ffmpeg/decoder.h"

#include "render/image/image_limits.h"

extern "C" {
#include <libavutil/dict.h>
}

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace vitrine::render::ffmpeg {
namespace {

using DisplayMatrix = std::array<std::int32_t, 9>;

/// Returns the display matrix of a stream (ISO/IEC 14496-12, 6.2.2): a pixel (x, y) is shown at (ax + cy, bx + dy),
/// where a, b, c, d are its numbers 0, 1, 3, 4. The identity if there is none.
DisplayMatrix displayMatrix(const AVStream& stream)
{
    DisplayMatrix matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
#if LIBAVCODEC_VERSION_INT >= AV_VERSION_INT(60, 31, 100)  // FFmpeg 6.1 moved it.
    const AVCodecParameters& parameters = *stream.codecpar;
    if (const AVPacketSideData* side = av_packet_side_data_get(
            parameters.coded_side_data, parameters.nb_coded_side_data, AV_PKT_DATA_DISPLAYMATRIX)) {
        data = side->data;
        size = side->size;
    }
#else
    data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &size);
#endif
    if (data && size >= sizeof matrix) std::memcpy(matrix.data(), data, sizeof matrix);
    return matrix;
}

}  // namespace

void readable(int result)
{
    if (result >= 0) return;
    std::array<char, AV_ERROR_MAX_STRING_SIZE> why{};
    av_strerror(result, why.data(), why.size());
    throw Problem{std::string("it is broken (") + why.data() + ")"};
}

Decoder::Decoder(const std::string& path, const char* formats, AVMediaType kind, const char* lacks)
{
    AVDictionary* options = nullptr;
    av_dict_set(&options, "protocol_whitelist", "file", 0);
    av_dict_set(&options, "format_whitelist", formats, 0);
    AVFormatContext* file = nullptr;
    const int result = avformat_open_input(&file, ("file:" + path).c_str(), nullptr, &options);
    av_dict_free(&options);
    if (result < 0) throw Problem{"its format is not supported"};
    file_.reset(file);
    readable(avformat_find_stream_info(file_.get(), nullptr));
    const AVCodec* codec = nullptr;
    stream_ = av_find_best_stream(file_.get(), kind, -1, -1, &codec, 0);
    if (stream_ < 0 || !codec) throw Problem{lacks};
    codec_.reset(checked("making the decoder", avcodec_alloc_context3(codec)));
    readable(avcodec_parameters_to_context(codec_.get(), file_->streams[stream_]->codecpar));
    codec_->max_pixels = static_cast<std::int64_t>(ImageLimits{}.pixels);
    readable(avcodec_open2(codec_.get(), codec, nullptr));
}

const AVFrame* Decoder::next()
{
    for (;;) {
        const int result = avcodec_receive_frame(codec_.get(), frame_.get());
        if (result == AVERROR_EOF || (result == AVERROR(EAGAIN) && isDrained_)) return nullptr;
        if (result != AVERROR(EAGAIN)) {
            readable(result);
            return frame_.get();
        }
        av_packet_unref(packet_.get());
        isDrained_ = av_read_frame(file_.get(), packet_.get()) < 0;
        if (isDrained_ || packet_->stream_index == stream_)
            readable(avcodec_send_packet(codec_.get(), isDrained_ ? nullptr : packet_.get()));
    }
}

int Decoder::orientation() const
{
    const DisplayMatrix matrix = displayMatrix(*file_->streams[stream_]);
    const std::int64_t a = matrix[0], b = matrix[1], c = matrix[3], d = matrix[4];
    if (std::abs(b) + std::abs(c) <= std::abs(a) + std::abs(d)) return a >= 0 ? (d >= 0 ? 1 : 4) : (d >= 0 ? 2 : 3);
    return b >= 0 ? (c >= 0 ? 5 : 6) : (c >= 0 ? 8 : 7);
}

std::size_t Decoder::countPackets()
{
    std::size_t count = 0;
    for (; av_read_frame(file_.get(), packet_.get()) >= 0; av_packet_unref(packet_.get()))
        count += packet_->stream_index == stream_ ? 1 : 0;
    return count;
}

}  // namespace vitrine::render::ffmpeg
