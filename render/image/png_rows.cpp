#include "render/image/png_rows.h"

#include <fcntl.h>
#include <png.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>

// libpng reports errors by longjmp: between setjmp and the calls into libpng stand only trivial locals.

namespace vitrine::render {

struct PngRows::State {
    PngRowTarget target;
    FileOps& ops;
    int fd = -1;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::array<char, 200> problem{};
};

namespace {

std::string said(const std::array<char, 200>& problem)
{
    return std::string("writing failed (") + problem.data() + ")";
}

}  // namespace

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
        while (size > 0) {
            const ssize_t wrote = state->ops.write(state->fd, bytes, size);
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote <= 0) png_error(png, std::strerror(wrote < 0 ? errno : ENOSPC));
            bytes += wrote;
            size -= static_cast<std::size_t>(wrote);
        }
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
    if (setjmp(png_jmpbuf(s.png))) return said(s.problem);  // NOLINT(cert-err52-cpp): libpng's own protocol.
    png_set_write_fn(s.png, &s, onWrite, [](png_structp) {});
    png_set_user_limits(s.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_compression_buffer_size(s.png, 1U << 18U);
    // Beyond level 1 interlaced prints shrink little and take eight times as long.
    png_set_compression_level(s.png, 1);
    png_set_filter(s.png, PNG_FILTER_TYPE_BASE, s.target.likeRowAbove ? PNG_FILTER_UP : PNG_FILTER_SUB);
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
    if (s.target.bits == 16 && std::endian::native == std::endian::little) png_set_swap(s.png);
    return {};
}

std::string PngRows::write(const void* rows, std::int64_t count)
{
    State& s = *state_;
    const std::size_t stride =
        static_cast<std::size_t>(s.target.width) * 3 * static_cast<std::size_t>(s.target.bits / 8);
    const auto* at = static_cast<png_const_bytep>(rows);
    if (setjmp(png_jmpbuf(s.png))) return said(s.problem);  // NOLINT(cert-err52-cpp)
    for (std::int64_t y = 0; y < count; ++y) png_write_row(s.png, at + static_cast<std::size_t>(y) * stride);
    return {};
}

std::string PngRows::close()
{
    State& s = *state_;
    if (setjmp(png_jmpbuf(s.png))) return said(s.problem);  // NOLINT(cert-err52-cpp)
    png_write_end(s.png, s.info);
    const int fd = s.fd;
    s.fd = -1;
    if (s.ops.close(fd) != 0) return std::string("closing it failed (") + std::strerror(errno) + ")";
    return {};
}

}  // namespace vitrine::render
