#include "render/image/png_row_reader.h"

#include "render/files/descriptor.h"
#include "render/image/orientation.h"

#include <fcntl.h>
#include <png.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>

// libpng reports errors by longjmp. Only trivially destructible locals may live between setjmp and the calls into
// libpng.

namespace vitrine::render {

struct PngRowReader::State {
    Descriptor file{};
    png_structp png = nullptr;
    png_infop info = nullptr;
    png_uint_32 width = 0, height = 0;
    int bits = 8;
    std::array<char, 200> problem{};

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State()
    {
        if (png) png_destroy_read_struct(&png, &info, nullptr);
    }
    [[nodiscard]] std::string said() const { return std::string("it is broken (") + problem.data() + ")"; }
};

namespace {

constexpr png_alloc_size_t mostChunkBytes = 16U << 20U;  // Limit for descriptions and profiles.

}  // namespace

PngRowReader::PngRowReader(std::filesystem::path path) : path_(std::move(path)) {}

PngRowReader::~PngRowReader() = default;

std::string PngRowReader::begin()
{
    state_ = std::make_unique<State>();
    State& s = *state_;
    s.file = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!s.file.open()) return std::strerror(errno);
    const auto onError = [](png_structp png, png_const_charp text) {
        auto* state = static_cast<State*>(png_get_error_ptr(png));
        std::strncpy(state->problem.data(), text, state->problem.size() - 1);
        png_longjmp(png, 1);
    };
    const auto onRead = [](png_structp png, png_bytep bytes, std::size_t size) {
        auto* state = static_cast<State*>(png_get_io_ptr(png));
        while (size > 0) {
            const ssize_t got = ::read(state->file.get(), bytes, size);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) png_error(png, got < 0 ? std::strerror(errno) : "the file ends too early");
            bytes += got;
            size -= static_cast<std::size_t>(got);
        }
    };
    s.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &s, onError, [](png_structp, png_const_charp) {});
    if (s.png) s.info = png_create_info_struct(s.png);
    if (!s.info) return "memory is full";
    if (setjmp(png_jmpbuf(s.png))) return s.said();  // NOLINT(cert-err52-cpp): libpng's own protocol.
    png_set_read_fn(s.png, &s, onRead);
    png_set_user_limits(s.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_chunk_malloc_max(s.png, mostChunkBytes);
    png_read_info(s.png, s.info);
    int type = 0;
    int interlace = 0;
    png_get_IHDR(s.png, s.info, &s.width, &s.height, &s.bits, &type, &interlace, nullptr, nullptr);
    if (interlace != PNG_INTERLACE_NONE) return "its rows come in several passes; save it without interlacing";
    png_set_expand(s.png);
    png_set_strip_alpha(s.png);
    if (type == PNG_COLOR_TYPE_GRAY || type == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(s.png);
    s.bits = s.bits == 16 ? 16 : 8;
    if (s.bits == 16 && std::endian::native == std::endian::little) png_set_swap(s.png);
    png_read_update_info(s.png, s.info);
    if (png_get_rowbytes(s.png, s.info) != static_cast<std::size_t>(s.width) * 3 * static_cast<std::size_t>(s.bits / 8))
        return "its pixels are of an unknown kind";
    return {};
}

std::string PngRowReader::read(void* rows, std::int64_t count)
{
    State& s = *state_;
    const std::size_t stride = static_cast<std::size_t>(s.width) * 3 * static_cast<std::size_t>(s.bits / 8);
    auto* at = static_cast<png_bytep>(rows);
    if (setjmp(png_jmpbuf(s.png))) return s.said();  // NOLINT(cert-err52-cpp)
    for (std::int64_t y = 0; y < count; ++y) png_read_row(s.png, at + static_cast<std::size_t>(y) * stride, nullptr);
    return {};
}

std::int64_t PngRowReader::width() const
{
    return state_->width;
}
std::int64_t PngRowReader::height() const
{
    return state_->height;
}
int PngRowReader::bits() const
{
    return state_->bits;
}

int PngRowReader::orientation() const
{
    png_uint_32 size = 0;
    png_bytep exif = nullptr;
    if (png_get_eXIf_1(state_->png, state_->info, &size, &exif) == 0 || !exif) return 1;
    return exifOrientation({reinterpret_cast<const char*>(exif), size});
}

std::string PngRowReader::profile() const
{
    png_charp title = nullptr;
    int compression = 0;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    if (png_get_iCCP(state_->png, state_->info, &title, &compression, &profile, &size) == 0) return {};
    return {reinterpret_cast<const char*>(profile), size};
}

std::string PngRowReader::text(const char* key) const
{
    png_textp texts = nullptr;
    const int count = png_get_text(state_->png, state_->info, &texts, nullptr);
    for (int i = 0; i < count; ++i)
        if (std::strcmp(texts[i].key, key) == 0 && texts[i].text) return texts[i].text;
    return {};
}

}  // namespace vitrine::render
