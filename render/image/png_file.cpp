#include "render/image/png_file.h"

#include "render/failure.h"
#include "render/image/orientation.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>

// libpng reports errors by longjmp. Every function that calls setjmp below holds only trivially
// destructible locals between setjmp and the calls into libpng; results live in the caller's objects.

namespace vitrine::render {
namespace {

constexpr char presetKey[] = "vitrine:preset";

struct Source {
    std::string_view bytes;
    std::size_t at = 0;
};

struct Problem {
    std::array<char, 160> text{};
};

[[noreturn]] void onError(png_structp png, png_const_charp text)
{
    auto* problem = static_cast<Problem*>(png_get_error_ptr(png));
    std::strncpy(problem->text.data(), text, problem->text.size() - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp /*png*/, png_const_charp /*text*/) {}

void readBytes(png_structp png, png_bytep out, std::size_t size)
{
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (size > source->bytes.size() - source->at) png_error(png, "the file ends too early");
    std::memcpy(out, source->bytes.data() + source->at, size);
    source->at += size;
}

/// RAII owner of a libpng reader and its structures.
struct Reader {
    Reader()
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &problem, onError, onWarning);
        if (png) info = png_create_info_struct(png);
        if (!info) png_destroy_read_struct(&png, &info, nullptr);
        if (!png) throw std::bad_alloc();
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    Problem problem;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

struct Writer {
    Writer()
    {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &problem, onError, onWarning);
        if (png) info = png_create_info_struct(png);
        if (!info) png_destroy_write_struct(&png, &info);
        if (!png) throw std::bad_alloc();
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    Problem problem;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

struct Header {
    png_uint_32 width = 0;
    png_uint_32 height = 0;
    int channels = 0;
    int bits = 0;
    int passes = 1;
};

/// Returns the orientation in chunk eXIf; 1 if there is none. Call it after the last chunk: eXIf may follow the pixels.
int orientationOf(Reader& reader)
{
    png_uint_32 size = 0;
    png_bytep exif = nullptr;
    if (png_get_eXIf_1(reader.png, reader.info, &size, &exif) == 0 || !exif) return 1;
    return exifOrientation({reinterpret_cast<const char*>(exif), size});
}

std::string profileOf(Reader& reader)
{
    png_charp title = nullptr;
    int compression = 0;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    if (png_get_iCCP(reader.png, reader.info, &title, &compression, &profile, &size) == 0) return {};
    return {reinterpret_cast<const char*>(profile), size};
}

/// Returns the color space of the chunks iCCP, sRGB, gAMA and cHRM, in this order of precedence (W3C, PNG
/// Specification, 4.3).
PictureColor colorOf(Reader& reader)
{
    PictureColor color{.profile = profileOf(reader)};
    int intent = 0;
    if (!color.profile.empty() || png_get_sRGB(reader.png, reader.info, &intent) != 0) return color;
    double gamma = 0;
    if (png_get_gAMA(reader.png, reader.info, &gamma) != 0 && gamma > 0) color.gamma = 1 / gamma;
    std::array<double, 8>& c = color.chromaticities;
    double whiteX = 0;
    double whiteY = 0;
    if (png_get_cHRM(reader.png, reader.info, &whiteX, &whiteY, &c[0], &c[1], &c[2], &c[3], &c[4], &c[5]) != 0) {
        c[6] = whiteX;
        c[7] = whiteY;
    }
    return color;
}

[[noreturn]] void failReading(const std::string& name, std::string_view why)
{
    throw Failure(ErrorKind::file, "Cannot read " + name + ": " + std::string(why) + "; choose another picture.");
}

/// Checks that every chunk lies inside the file. libpng 1.6 only warns about a longer one, and then allocates its size,
/// up to 2 GB.
void checkChunks(std::string_view bytes, const std::string& name)
{
    constexpr std::size_t signature = 8;
    constexpr std::size_t frame = 12;  // Length, type and checksum.
    for (std::size_t at = signature;;) {
        if (bytes.size() < at + frame) failReading(name, "the file ends too early");
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
        if (length > bytes.size() - at - frame) failReading(name, "the file ends too early");
        if (bytes.substr(at + 4, 4) == "IEND") return;
        at += frame + length;
    }
}

bool readHeader(Reader& reader, Source& source, const ImageLimits& limits, Header& header)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;  // NOLINT(cert-err52-cpp): libpng's own protocol.
    png_set_read_fn(reader.png, &source, readBytes);
    png_set_user_limits(reader.png, static_cast<png_uint_32>(std::min<std::uint64_t>(limits.side, PNG_UINT_31_MAX)),
                        static_cast<png_uint_32>(std::min<std::uint64_t>(limits.side, PNG_UINT_31_MAX)));
    png_set_chunk_cache_max(reader.png, 128);
    png_set_chunk_malloc_max(reader.png, 32U << 20U);
    png_read_info(reader.png, reader.info);
    png_set_expand(reader.png);  // Palettes, low bit depths, transparent colors.
    if (std::endian::native == std::endian::little) png_set_swap(reader.png);
    header.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    header.width = png_get_image_width(reader.png, reader.info);
    header.height = png_get_image_height(reader.png, reader.info);
    header.channels = png_get_channels(reader.png, reader.info);
    header.bits = png_get_bit_depth(reader.png, reader.info);
    return true;
}

bool readRow(Reader& reader, png_bytep row)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;  // NOLINT(cert-err52-cpp)
    png_read_row(reader.png, row, nullptr);
    return true;
}

bool readEnd(Reader& reader)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;  // NOLINT(cert-err52-cpp)
    png_read_end(reader.png, reader.info);
    return true;
}

void appendBytes(png_structp png, png_bytep bytes, std::size_t size)
{
    auto* out = static_cast<std::string*>(png_get_io_ptr(png));
    bool full = false;
    try {
        out->append(reinterpret_cast<const char*>(bytes), size);
    } catch (const std::exception&) {
        full = true;  // Leaves the exception handler before the jump.
    }
    if (full) png_error(png, "memory is full");
}

void noFlush(png_structp /*png*/) {}

struct Rows {
    const std::uint8_t* first = nullptr;
    std::size_t stride = 0;
    png_uint_32 count = 0;
};

bool writeHeader(Writer& writer, const Header& header, png_textp texts, int textCount, png_uint_32 pixelsPerMeter,
                 std::string* out)
{
    if (setjmp(png_jmpbuf(writer.png))) return false;  // NOLINT(cert-err52-cpp)
    constexpr std::array<int, 4> types = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                          PNG_COLOR_TYPE_RGBA};
    png_set_write_fn(writer.png, out, appendBytes, noFlush);
    png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(writer.png, writer.info, header.width, header.height, header.bits,
                 types[static_cast<std::size_t>(header.channels - 1)], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (pixelsPerMeter > 0) png_set_pHYs(writer.png, writer.info, pixelsPerMeter, pixelsPerMeter, PNG_RESOLUTION_METER);
    if (textCount > 0) png_set_text(writer.png, writer.info, texts, textCount);
    png_write_info(writer.png, writer.info);
    if (header.bits == 16 && std::endian::native == std::endian::little) png_set_swap(writer.png);
    return true;
}

bool writeRows(Writer& writer, const Rows& rows)
{
    if (setjmp(png_jmpbuf(writer.png))) return false;  // NOLINT(cert-err52-cpp)
    for (png_uint_32 y = 0; y < rows.count; ++y) png_write_row(writer.png, rows.first + y * rows.stride);
    png_write_end(writer.png, writer.info);
    return true;
}

png_text textChunk(const char* key, const std::string& value)
{
    png_text text{};
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<png_charp>(key);
    text.text = const_cast<png_charp>(value.c_str());
    text.itxt_length = value.size();
    return text;
}

}  // namespace

StoredPicture decodePng(std::string_view bytes, const std::string& name, const ImageLimits& limits,
                        const std::function<bool()>& canceled)
{
    checkChunks(bytes, name);
    Reader reader;
    Source source{bytes};
    Header header;
    if (!readHeader(reader, source, limits, header)) failReading(name, reader.problem.text.data());
    const std::uint64_t sampleBytes = header.bits == 16 ? 2 : 1;
    const DeclaredImage declared{header.width, header.height, static_cast<std::uint64_t>(header.channels), sampleBytes};
    if (const std::string why = whyTooLarge(declared, ImageFormat::png, bytes.size(), limits); !why.empty()) {
        failReading(name, why);
    }

    StoredPicture picture;
    picture.width = static_cast<int>(header.width);
    picture.height = static_cast<int>(header.height);
    picture.channels = header.channels;
    png_bytep first = nullptr;
    if (header.bits == 16) {
        first = reinterpret_cast<png_bytep>(picture.samples.emplace<1>(picture.sampleCount()).data());
    } else {
        first = picture.samples.emplace<0>(picture.sampleCount()).data();
    }
    const std::size_t stride = picture.rowSamples() * sampleBytes;
    for (int pass = 0; pass < header.passes; ++pass) {
        for (std::size_t y = 0; y < header.height; ++y) {
            if (canceled && canceled()) failReading(name, "reading was canceled");
            if (!readRow(reader, first + y * stride)) failReading(name, reader.problem.text.data());
        }
    }
    if (!readEnd(reader)) failReading(name, reader.problem.text.data());
    picture.orientation = orientationOf(reader);
    picture.color = colorOf(reader);
    return picture;
}

std::string encodePng(const StoredPicture& picture, const PngText& extra, const std::string& name)
{
    Writer writer;
    std::string out;
    std::array<png_text, 2> texts{};
    int textCount = 0;
    if (!extra.preset.empty()) texts.at(static_cast<std::size_t>(textCount++)) = textChunk(presetKey, extra.preset);
    if (!extra.description.empty()) {
        texts.at(static_cast<std::size_t>(textCount++)) = textChunk("Description", extra.description);
    }
    const bool wide = std::holds_alternative<std::vector<std::uint16_t>>(picture.samples);
    const Header header{static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
                        picture.channels, wide ? 16 : 8, 1};
    const Rows rows{wide ? reinterpret_cast<const std::uint8_t*>(std::get<1>(picture.samples).data())
                         : std::get<0>(picture.samples).data(),
                    picture.rowSamples() * (wide ? 2U : 1U), header.height};
    const auto perMeter = static_cast<png_uint_32>(std::lround(std::clamp(extra.pixelsPerMeter, 0.0, 1e9)));
    if (!writeHeader(writer, header, texts.data(), textCount, perMeter, &out) || !writeRows(writer, rows)) {
        throw Failure(ErrorKind::file,
                      "Cannot write " + name + ": " + writer.problem.text.data() + "; try a smaller picture.");
    }
    return out;
}

std::optional<std::string> presetInPng(std::string_view bytes, const std::string& name)
{
    return textInPng(bytes, presetKey, name);
}

std::string profileInPng(std::string_view bytes, const std::string& name)
{
    checkChunks(bytes, name);
    Reader reader;
    Source source{bytes};
    Header header;
    if (!readHeader(reader, source, ImageLimits{}, header)) failReading(name, reader.problem.text.data());
    return profileOf(reader);
}

std::optional<std::string> textInPng(std::string_view bytes, const char* key, const std::string& name)
{
    checkChunks(bytes, name);
    Reader reader;
    Source source{bytes};
    Header header;
    if (!readHeader(reader, source, ImageLimits{}, header)) failReading(name, reader.problem.text.data());
    png_textp texts = nullptr;
    const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
    for (int i = 0; i < count; ++i) {
        if (std::strcmp(texts[i].key, key) == 0 && texts[i].text) return std::string(texts[i].text);
    }
    return std::nullopt;
}

}  // namespace vitrine::render
