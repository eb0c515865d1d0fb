#include "render/image/png_rows.h"

#include "render/image/png_pieces.h"

#include <fcntl.h>
#include <png.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>

// libpng writes the chunks before the pixels, PngPieces the pixels. libpng reports errors by longjmp. Only trivially
// destructible locals may live between setjmp and the calls into libpng.

namespace vitrine::render {

struct PngRows::State {
    PngRowTarget target;
    FileOps& ops;
    int fd = -1;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::array<char, 200> problem{};
    std::unique_ptr<PngPieces> pieces{};

    void startPixels();
};

namespace {

constexpr std::array<std::uint8_t, 12> endChunk = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};

std::string said(const char* problem)
{
    return std::string("writing failed (") + problem + ")";
}

/// Writes all bytes; returns 0 or the errno of the failure.
int writeAll(FileOps& ops, int fd, const std::uint8_t* bytes, std::size_t size)
{
    while (size > 0) {
        const ssize_t wrote = ops.write(fd, bytes, size);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) return wrote < 0 ? errno : ENOSPC;
        bytes += wrote;
        size -= static_cast<std::size_t>(wrote);
    }
    return 0;
}

}  // namespace

void PngRows::State::startPixels()
{
    const auto pixelBytes = static_cast<std::size_t>(3 * target.bits / 8);
    const PngPieces::Shape shape{static_cast<std::size_t>(target.width) * pixelBytes, pixelBytes,
                                 target.bits == 16 && std::endian::native == std::endian::little,
                                 target.likeRowAbove ? PngFilter::above : PngFilter::left};
    pieces = std::make_unique<PngPieces>(shape, target.threads, [this](const std::uint8_t* bytes, std::size_t size) {
        const int error = writeAll(ops, fd, bytes, size);
        return error == 0 ? std::string() : said(std::strerror(error));
    });
}

PngRows::PngRows(const PngRowTarget& target, FileOps& ops) : state_(new State{target, ops}) {}

PngRows::~PngRows()
{
    if (state_->png) png_destroy_write_struct(&state_->png, &state_->info);
    if (state_->fd >= 0) state_->ops.close(state_->fd);
}

std::string PngRows::begin()
{
    State& s = *state_;
    s.fd = s.ops.open(s.target.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (s.fd < 0) return std::string("creating it failed (") + std::strerror(errno) + ")";
    const auto onError = [](png_structp png, png_const_charp text) {
        auto* state = static_cast<State*>(png_get_error_ptr(png));
        std::strncpy(state->problem.data(), text, state->problem.size() - 1);
        png_longjmp(png, 1);
    };
    const auto onWrite = [](png_structp png, png_bytep bytes, std::size_t size) {
        auto* state = static_cast<State*>(png_get_io_ptr(png));
        if (const int error = writeAll(state->ops, state->fd, bytes, size); error != 0)
            png_error(png, std::strerror(error));
    };
    s.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &s, onError, [](png_structp, png_const_charp) {});
    if (s.png) s.info = png_create_info_struct(s.png);
    if (!s.info) return "memory is full";
    const auto perMeter = [](double dpi) { return static_cast<png_uint_32>(std::lround(dpi / 0.0254)); };
    const png_uint_32 meterX = perMeter(s.target.dpiX);
    const png_uint_32 meterY = perMeter(s.target.dpiY);
    png_text text{};
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<png_charp>(s.target.textKey.c_str());
    text.text = const_cast<png_charp>(s.target.text.c_str());
    text.itxt_length = s.target.text.size();
    if (setjmp(png_jmpbuf(s.png))) return said(s.problem.data());  // NOLINT(cert-err52-cpp): libpng's own protocol.
    png_set_write_fn(s.png, &s, onWrite, [](png_structp) {});
    png_set_user_limits(s.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(s.png, s.info, static_cast<png_uint_32>(s.target.width), static_cast<png_uint_32>(s.target.height),
                 s.target.bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (s.target.profile.empty()) {
        png_set_sRGB_gAMA_and_cHRM(s.png, s.info, PNG_sRGB_INTENT_PERCEPTUAL);
    } else {
        png_set_iCCP(s.png, s.info, "ICC profile", PNG_COMPRESSION_TYPE_BASE,
                     reinterpret_cast<png_const_bytep>(s.target.profile.data()),
                     static_cast<png_uint_32>(s.target.profile.size()));
    }
    png_set_pHYs(s.png, s.info, meterX, meterY, PNG_RESOLUTION_METER);
    if (!s.target.text.empty()) png_set_text(s.png, s.info, &text, 1);
    png_write_info(s.png, s.info);
    return {};
}

std::string PngRows::write(const void* rows, std::int64_t count)
{
    if (!state_->pieces) state_->startPixels();
    return state_->pieces->write(static_cast<const std::uint8_t*>(rows), count);
}

std::string PngRows::close()
{
    State& s = *state_;
    if (!s.pieces) return "there are no rows";
    if (std::string why = s.pieces->finish(); !why.empty()) return why;
    s.pieces.reset();
    if (const int error = writeAll(s.ops, s.fd, endChunk.data(), endChunk.size()); error != 0)
        return said(std::strerror(error));
    const int fd = s.fd;
    s.fd = -1;
    if (s.ops.close(fd) != 0) return std::string("closing it failed (") + std::strerror(errno) + ")";
    return {};
}

}  // namespace vitrine::render
