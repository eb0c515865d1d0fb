#include "render/video/ffmpeg/output.h"

extern "C" {
#include <libavformat/avformat.h>
#include <libavutil/crc.h>
#include <libavutil/mem.h>
}

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace vitrine::render::ffmpeg {
namespace {

constexpr std::int64_t pngHeader = 33;  // Signature and IHDR.

// FFmpeg 7 made the bytes const.
#if LIBAVFORMAT_VERSION_MAJOR >= 61
using WrittenBytes = const std::uint8_t*;
#else
using WrittenBytes = std::uint8_t*;
#endif

std::string bigEndian(std::uint32_t x)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(x >> static_cast<unsigned>(shift) & 0xFFU);
    return bytes;
}

std::string littleEndian(std::uint32_t x)
{
    std::string bytes = bigEndian(x);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

}  // namespace

MuxedOutput::MuxedOutput(VideoOutput& output) : output_(output)
{
    constexpr int bufferSize = 1 << 16;
    auto* buffer = static_cast<unsigned char*>(av_malloc(bufferSize));
    if (!buffer) return;
    context_ = avio_alloc_context(
        buffer, bufferSize, 1, this, nullptr,
        [](void* self, WrittenBytes bytes, int count) { return static_cast<MuxedOutput*>(self)->write(bytes, count); },
        [](void* self, std::int64_t offset, int whence) {
            return static_cast<MuxedOutput*>(self)->seek(offset, whence);
        });
    if (!context_) av_free(buffer);
}

MuxedOutput::~MuxedOutput()
{
    if (context_) av_freep(&context_->buffer);
    avio_context_free(&context_);
}

bool MuxedOutput::put(const std::uint8_t* bytes, std::int64_t count)
{
    if (!output_.write(bytes, static_cast<std::size_t>(count))) return false;
    at_ += count;
    size_ = std::max(size_, at_);
    return true;
}

int MuxedOutput::write(const std::uint8_t* bytes, int count)
{
    std::int64_t first = 0;
    if (!inserted_.empty() && !insertedDone_ && at_ + count >= pngHeader) {
        first = pngHeader - at_;
        if (!put(bytes, first) || !output_.write(inserted_.data(), inserted_.size())) return AVERROR(EIO);
        insertedDone_ = true;
    }
    return put(bytes + first, count - first) ? count : AVERROR(EIO);
}

std::int64_t MuxedOutput::seek(std::int64_t offset, int whence)
{
    if ((whence & AVSEEK_SIZE) != 0) return size_;
    const std::int64_t from = whence == SEEK_CUR ? at_ : whence == SEEK_END ? size_ : 0;
    const std::int64_t to = from + offset;
    const bool behind = insertedDone_ && to >= pngHeader;
    if (to < 0 || !output_.seek(to + (behind ? static_cast<std::int64_t>(inserted_.size()) : 0))) return AVERROR(EIO);
    at_ = to;
    return to;
}

bool MuxedOutput::appendToGif(const std::string& comment)
{
    // A comment extension before the trailer, which has one byte: blocks of at most 255 bytes (GIF89a specification,
    // 24).
    std::string bytes = "\x21\xFE";
    for (std::size_t i = 0; i < comment.size(); i += 255) {
        const std::string block = comment.substr(i, 255);
        bytes += static_cast<char>(block.size()) + block;
    }
    bytes += '\0';
    bytes += '\x3B';
    return output_.seek(size_ - 1) && output_.write(bytes.data(), bytes.size());
}

bool MuxedOutput::appendToWebp(const std::string& comment)
{
    // A chunk of a private type at the end, where the container allows it (RFC 9649, 2.7.1.6).
    std::string chunk = "VTRN" + littleEndian(static_cast<std::uint32_t>(comment.size())) + comment;
    if (chunk.size() % 2 != 0) chunk += '\0';
    const std::string riffSize =
        littleEndian(static_cast<std::uint32_t>(size_ + static_cast<std::int64_t>(chunk.size()) - 8));
    return output_.seek(size_) && output_.write(chunk.data(), chunk.size()) && output_.seek(4) &&
           output_.write(riffSize.data(), riffSize.size());
}

std::string pngText(const std::string& key, const std::string& text)
{
    // Key, 0, not compressed, method 0, no language, no translated key (PNG specification, 11.3.3.4).
    const std::string body = "iTXt" + key + std::string(5, '\0') + text;
    const std::uint32_t crc = av_crc(av_crc_get_table(AV_CRC_32_IEEE_LE), 0xFFFFFFFFU,
                                     reinterpret_cast<const std::uint8_t*>(body.data()), body.size()) ^
                              0xFFFFFFFFU;
    return bigEndian(static_cast<std::uint32_t>(body.size() - 4)) + body + bigEndian(crc);
}

}  // namespace vitrine::render::ffmpeg
