#include "render/video/ffmpeg/sound.h"

#include "render/video/ffmpeg/owned.h"

extern "C" {
#include <libavutil/dict.h>
#include <libavutil/samplefmt.h>
}

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace vitrine::render::ffmpeg {
namespace {

void readable(int result)
{
    if (result >= 0) return;
    std::array<char, AV_ERROR_MAX_STRING_SIZE> why{};
    av_strerror(result, why.data(), why.size());
    throw Problem{std::string("it is broken (") + why.data() + ")"};
}

struct Close {
    void operator()(AVFormatContext* opened) const { avformat_close_input(&opened); }
};

using Opened = std::unique_ptr<AVFormatContext, Close>;

Opened opened(const std::string& path)
{
    AVDictionary* options = nullptr;
    av_dict_set(&options, "protocol_whitelist", "file", 0);
    av_dict_set(&options, "format_whitelist", "wav,flac", 0);
    AVFormatContext* file = nullptr;
    const int result = avformat_open_input(&file, ("file:" + path).c_str(), nullptr, &options);
    av_dict_free(&options);
    if (result < 0) throw Problem{"its format is not supported"};
    return Opened(file);
}

template <typename T> double valueAt(const std::uint8_t* data, int index)
{
    T value{};
    std::memcpy(&value, data + static_cast<std::size_t>(index) * sizeof value, sizeof value);
    return static_cast<double>(value);
}

/// Returns a sample from -1 to 1.
float sampleAt(const AVFrame& frame, int channel, int channels, int index)
{
    const auto format = static_cast<AVSampleFormat>(frame.format);
    const bool planar = av_sample_fmt_is_planar(format) != 0;
    const std::uint8_t* data = frame.extended_data[planar ? channel : 0];
    const int at = planar ? index : index * channels + channel;
    switch (av_get_packed_sample_fmt(format)) {
    case AV_SAMPLE_FMT_U8: return static_cast<float>((valueAt<std::uint8_t>(data, at) - 128) / 128);
    case AV_SAMPLE_FMT_S16: return static_cast<float>(valueAt<std::int16_t>(data, at) / 32768);
    case AV_SAMPLE_FMT_S32: return static_cast<float>(valueAt<std::int32_t>(data, at) / 2147483648.0);
    case AV_SAMPLE_FMT_FLT: return static_cast<float>(valueAt<float>(data, at));
    case AV_SAMPLE_FMT_DBL: return static_cast<float>(valueAt<double>(data, at));
    default: throw Problem{"its sample format is not supported"};
    }
}

/// Decoder of the first sound of a file.
class Decoder {
public:
    explicit Decoder(AVFormatContext& file) : file_(file)
    {
        readable(avformat_find_stream_info(&file_, nullptr));
        const AVCodec* codec = nullptr;
        stream_ = av_find_best_stream(&file_, AVMEDIA_TYPE_AUDIO, -1, -1, &codec, 0);
        if (stream_ < 0 || !codec) throw Problem{"it has no sound that this machine's FFmpeg can decode"};
        codec_.reset(checked("making the decoder", avcodec_alloc_context3(codec)));
        readable(avcodec_parameters_to_context(codec_.get(), file_.streams[stream_]->codecpar));
        readable(avcodec_open2(codec_.get(), codec, nullptr));
    }

    Sound run()
    {
        const Owned<AVPacket> packet(checked("making a packet", av_packet_alloc()));
        while (av_read_frame(&file_, packet.get()) >= 0) {
            if (packet->stream_index == stream_) decode(packet.get());
            av_packet_unref(packet.get());
        }
        decode(nullptr);
        if (sound_.samples.empty()) throw Problem{"it has no samples"};
        return std::move(sound_);
    }

private:
    void decode(const AVPacket* packet)
    {
        readable(avcodec_send_packet(codec_.get(), packet));
        for (;;) {
            const int result = avcodec_receive_frame(codec_.get(), frame_.get());
            if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
            readable(result);
            take(*frame_);
        }
    }
    void take(const AVFrame& frame)
    {
        const int channels = frame.ch_layout.nb_channels;
        if (channels < 1 || frame.sample_rate < 1) throw Problem{"it has no channel"};
        const int kept = std::min(channels, mostSoundChannels);
        if (sound_.samples.empty()) {
            sound_.rate = frame.sample_rate;
            sound_.channels = kept;
        }
        if (kept != sound_.channels || frame.sample_rate != sound_.rate) throw Problem{"its rate or channels change"};
        if (sound_.length() + static_cast<std::size_t>(frame.nb_samples) >
            static_cast<std::size_t>(longestSound) * static_cast<std::size_t>(sound_.rate))
            throw Problem{"it is longer than " + std::to_string(longestSound) + " s"};
        for (int i = 0; i < frame.nb_samples; ++i)
            for (int c = 0; c < kept; ++c) sound_.samples.push_back(sampleAt(frame, c, channels, i));
    }

    AVFormatContext& file_;
    int stream_ = -1;
    Owned<AVCodecContext> codec_;
    Owned<AVFrame> frame_{checked("making a frame", av_frame_alloc())};
    Sound sound_;
};

}  // namespace

Sound soundOf(const std::string& path)
{
    const Opened file = opened(path);
    return Decoder(*file).run();
}

}  // namespace vitrine::render::ffmpeg
