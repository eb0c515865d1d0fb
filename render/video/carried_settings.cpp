#include "render/video/carried_settings.h"

#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/image/png_row_reader.h"
#include "render/video/video_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t mostComment = 4U << 20U;  ///< Bytes, the maximum size of a preset.

[[noreturn]] void refuseToRead(const fs::path& path, const std::string& why)
{
    throw Failure(ErrorKind::file, "Cannot read " + path.string() + ": " + why + "; choose another file.");
}

/// Returns the last bytes of a file, at most `most`.
std::string tailOf(std::ifstream& file, std::uintmax_t size, std::uintmax_t most)
{
    std::string bytes(std::min(size, most), '\0');
    file.seekg(static_cast<std::streamoff>(size - bytes.size()));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return bytes;
}

/// Returns the comment of a GIF whose comment extension is the last thing before the trailer: blocks of at most 255
/// bytes, an empty one, the trailer.
std::string commentOfGif(std::ifstream& file, std::uintmax_t size)
{
    constexpr int mostTried = 16;  // The comment's own bytes may look like the start of an extension.
    const std::string tail = tailOf(file, size, mostComment);
    std::size_t at = tail.rfind("\x21\xFE");
    for (int tried = 0; tried < mostTried && at != std::string::npos && at > 0; ++tried) {
        std::string comment;
        std::size_t next = at + 2;
        while (next < tail.size() && tail[next] != '\0') {
            const std::size_t count = static_cast<unsigned char>(tail[next]);
            comment += tail.substr(next + 1, count);
            next += count + 1;
        }
        if (next + 2 == tail.size() && tail[next + 1] == '\x3B') return comment;
        at = tail.rfind("\x21\xFE", at - 1);
    }
    return {};
}

/// Returns the content of the chunk "VTRN" of a WebP.
std::string commentOfWebp(std::ifstream& file, std::uintmax_t size)
{
    std::uintmax_t at = 12;  // After "RIFF", the size and "WEBP".
    while (at + 8 <= size) {
        std::array<char, 8> header{};
        file.seekg(static_cast<std::streamoff>(at));
        if (!file.read(header.data(), header.size())) return {};
        std::uintmax_t count = 0;
        for (std::size_t i = 0; i < 4; ++i)
            count |= static_cast<std::uintmax_t>(static_cast<unsigned char>(header.at(4 + i))) << (8 * i);
        if (count > size - at - 8) return {};
        if (std::string_view(header.data(), 4) == "VTRN" && count <= mostComment) {
            std::string comment(count, '\0');
            file.read(comment.data(), static_cast<std::streamsize>(count));
            return comment;
        }
        at += 8 + count + count % 2;
    }
    return {};
}

std::string commentOf(const fs::path& path, VideoFormat format)
{
    std::error_code error;
    if (!fs::is_regular_file(path, error)) refuseToRead(path, "there is no such file");
    if (format == VideoFormat::mp4 || format == VideoFormat::webm) {
        std::string comment;
        if (const std::string why = videoCodec().readComment(path.string(), format, comment); !why.empty())
            refuseToRead(path, why);
        return comment;
    }
    if (format == VideoFormat::apng) {
        PngRowReader png(path);
        if (const std::string why = png.begin(); !why.empty()) refuseToRead(path, why);
        return png.text("vitrine:preset");
    }
    std::ifstream file(path, std::ios::binary);
    const std::uintmax_t size = fs::file_size(path, error);
    if (!file || error) refuseToRead(path, "it cannot be opened");
    return format == VideoFormat::gif ? commentOfGif(file, size) : commentOfWebp(file, size);
}

}  // namespace

bool mayCarrySettings(const fs::path& path)
{
    const PictureFileFormat* format = formatNamed(path);
    return (format && format->isRead) || videoFormatOf(path);
}

std::string carriedSettingsEndings()
{
    return std::string(settingsEndings()) + ' ' + videoEndings();
}

std::optional<std::string> carriedSettings(const fs::path& path)
{
    const std::optional<VideoFormat> video = videoFormatOf(path);
    return video ? carriedSettings(path, *video) : embeddedPreset(path);
}

std::optional<std::string> carriedSettings(const fs::path& path, VideoFormat format)
{
    return settingsInDescription(commentOf(path, format));
}

}  // namespace vitrine::render
