#include "render/video/ffmpeg/sound.h"

#include "render/video/ffmpeg/decoder.h"

extern "C" {
#include <libavutil/samplefmt.h>
}

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace vitrine::render::ffmpeg {
namespace {

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

/// Collects the samples of a sound.
class Samples {
public:
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

    Sound taken()
    {
        if (sound_.samples.empty()) throw Problem{"it has no samples"};
        return std::move(sound_);
    }

private:
    Sound sound_;
};

}  // namespace

Sound soundOf(const std::string& path)
{
    Decoder decoder(path, "wav,flac", AVMEDIA_TYPE_AUDIO, "it has no sound that this machine's FFmpeg can decode");
    Samples samples;
    while (const AVFrame* frame = decoder.next()) samples.take(*frame);
    return samples.taken();
}

}  // namespace vitrine::render::ffmpeg
