#include "render/video/ffmpeg/still.h"

#include "render/video/ffmpeg/owned.h"

extern "C" {
#include <libavutil/pixdesc.h>
}

#include <algorithm>
#include <climits>
#include <cstring>
#include <vector>

namespace vitrine::render::ffmpeg {
namespace {

void unpacked(int result)
{
    if (result >= 0) return;
    std::array<char, AV_ERROR_MAX_STRING_SIZE> why{};
    av_strerror(result, why.data(), why.size());
    throw Problem{std::string("it is broken (") + why.data() + ")"};
}

/// Location of a color component in a frame: FFmpeg's index of the component, and the largest code.
struct Component {
    int number = 0;
    int largest = 255;
};

/// Returns gray, or red, green, blue, and alpha if there is any.
std::vector<Component> componentsOf(const AVPixFmtDescriptor& format)
{
    if ((format.flags & AV_PIX_FMT_FLAG_PAL) != 0)
        return {{2}, {1}, {0}, {3}};  // Bytes of 0xAARRGGBB from the low end.
    const bool known = (format.flags & AV_PIX_FMT_FLAG_RGB) != 0 || format.nb_components == 1;
    if (!known) throw Problem{"its pixel format is not supported (" + std::string(format.name) + ")"};
    std::vector<Component> components;
    for (int c = 0; c < format.nb_components; ++c) components.push_back({c, (1 << format.comp[c].depth) - 1});
    return components;
}

/// Removes the alpha channel if it is 255 everywhere.
void dropOpaque(StoredPicture& picture, std::vector<std::uint8_t>& codes)
{
    if (picture.channels != 4) return;
    for (std::size_t at = 3; at < codes.size(); at += 4)
        if (codes[at] != 255) return;
    for (std::size_t pixel = 1; pixel < codes.size() / 4; ++pixel)
        std::memmove(&codes[pixel * 3], &codes[pixel * 4], 3);
    codes.resize(codes.size() / 4 * 3);
    picture.channels = 3;
}

/// Replaces palette indices by a byte of their colors. FFmpeg itself reads only the lowest byte.
void takeFromPalette(const std::uint8_t* colors, int byte, std::vector<std::uint16_t>& line)
{
    for (std::uint16_t& code : line) {
        std::uint32_t color = 0;
        std::memcpy(&color, colors + 4 * std::size_t{code}, sizeof color);
        code = static_cast<std::uint16_t>(color >> (8 * byte) & 0xFFU);
    }
}

StoredPicture copyOf(const AVFrame& frame)
{
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
    if (!format || frame.width < 1 || frame.height < 1) throw Problem{"it has no pixels"};
    const std::vector<Component> components = componentsOf(*format);
    const bool palette = (format->flags & AV_PIX_FMT_FLAG_PAL) != 0;
    StoredPicture picture;
    picture.width = frame.width;
    picture.height = frame.height;
    picture.channels = static_cast<int>(components.size());
    std::vector<std::uint8_t> codes(picture.sampleCount());
    std::vector<std::uint16_t> line(static_cast<std::size_t>(frame.width));
    std::array<const std::uint8_t*, 4> data{};
    std::copy_n(frame.data, data.size(), data.begin());
    for (int y = 0; y < frame.height; ++y) {
        for (std::size_t c = 0; c < components.size(); ++c) {
            const auto [number, largest] = components[c];
            av_read_image_line2(line.data(), data.data(), frame.linesize, format, 0, y, palette ? 0 : number,
                                frame.width, 0, sizeof(std::uint16_t));
            if (palette) takeFromPalette(frame.data[1], number, line);
            std::uint8_t* out = codes.data() + static_cast<std::size_t>(y) * picture.rowSamples() + c;
            for (const std::uint16_t code : line) {
                *out = static_cast<std::uint8_t>((code * 255 + largest / 2) / largest);
                out += components.size();
            }
        }
    }
    dropOpaque(picture, codes);
    picture.samples = std::move(codes);
    return picture;
}

}  // namespace

StoredPicture stillPicture(std::string_view bytes, bool isGif)
{
    const AVCodec* codec = avcodec_find_decoder(isGif ? AV_CODEC_ID_GIF : AV_CODEC_ID_BMP);
    if (!codec) throw Problem{"this machine's FFmpeg cannot read the format"};
    const Owned<AVCodecContext> decoder(checked("reading it", avcodec_alloc_context3(codec)));
    decoder->thread_count = 1;
    decoder->err_recognition = AV_EF_EXPLODE;
    checked("reading it", avcodec_open2(decoder.get(), codec, nullptr));
    const Owned<AVPacket> packet(checked("reading it", av_packet_alloc()));
    if (bytes.size() > INT_MAX / 2) throw Problem{"it is larger than FFmpeg reads"};
    checked("reading it", av_new_packet(packet.get(), static_cast<int>(bytes.size())));
    std::memcpy(packet->data, bytes.data(), bytes.size());
    const Owned<AVFrame> frame(checked("reading it", av_frame_alloc()));
    unpacked(avcodec_send_packet(decoder.get(), packet.get()));
    unpacked(avcodec_receive_frame(decoder.get(), frame.get()));
    return copyOf(*frame);
}

}  // namespace vitrine::render::ffmpeg
