#include "render/video/video_frames.h"

#include "render/failure.h"
#include "render/files/extension.h"
#include "render/image/orientation.h"
#include "render/image/srgb.h"
#include "render/image/video_codec.h"

#include <array>
#include <sstream>
#include <string>
#include <utility>

namespace vitrine::render {
namespace {

void requireVideo(const std::filesystem::path& path, const std::string& problem)
{
    if (!problem.empty())
        throw Failure(ErrorKind::file, message("Cannot read {1}: {2}; choose another video.", path, problem));
}

Image linearOf(const StoredPicture& picture)
{
    static const std::array<float, 256> light = [] {
        std::array<float, 256> table{};
        for (std::size_t code = 0; code < table.size(); ++code)
            table.at(code) = static_cast<float>(linearFromSrgb(static_cast<double>(code) / 255));
        return table;
    }();
    Image image(picture.width, picture.height, picture.channels);
    const auto& codes = std::get<std::vector<std::uint8_t>>(picture.samples);
    for (std::size_t i = 0; i < codes.size(); ++i) image.pixels[i] = light[codes[i]];
    return image;
}

}  // namespace

bool isReadVideo(const std::filesystem::path& path)
{
    const std::string extension = lowerExtension(path);
    std::istringstream endings(readVideoEndings);
    for (std::string ending; endings >> ending;)
        if (extension == '.' + ending) return true;
    return false;
}

std::size_t countFrames(const std::filesystem::path& path)
{
    std::size_t count = 0;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) requireVideo(path, "there is no such file");
    requireVideo(path, videoCodec().countFrames(path.string(), count));
    return count;
}

VideoFrameReader::VideoFrameReader(std::filesystem::path path) : path_(std::move(path)) {}

VideoFrameReader::~VideoFrameReader() = default;

std::optional<Image> VideoFrameReader::frame(std::size_t number)
{
    if (!reader_ || number < next_) {
        requireVideo(path_, videoCodec().openReader(path_.string(), reader_));
        next_ = 0;
    }
    for (; next_ < number; ++next_) requireVideo(path_, reader_->skip());
    StoredPicture picture;
    bool isEnd = false;
    requireVideo(path_, reader_->next(picture, isEnd));
    ++next_;
    if (isEnd) return std::nullopt;
    orient(picture, picture.orientation);
    return linearOf(picture);
}

}  // namespace vitrine::render
