#include "render/video/video_file.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/extension.h"
#include "render/image/srgb.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cerrno>
#include <utility>

namespace vitrine::render {
namespace {

bool storesHalfChroma(VideoFormat format)
{
    return format == VideoFormat::mp4 || format == VideoFormat::webm;
}

VideoSpec legal(const VideoSpec& spec)
{
    if (const std::string why = whyNoVideo(spec); !why.empty()) throw Failure(ErrorKind::usage, why);
    return spec;
}

constexpr std::array<std::pair<std::string_view, VideoFormat>, 5> formatsByEnding{{
    {"mp4", VideoFormat::mp4},
    {"webm", VideoFormat::webm},
    {"gif", VideoFormat::gif},
    {"webp", VideoFormat::webp},
    {"apng", VideoFormat::apng},
}};

}  // namespace

std::optional<VideoFormat> videoFormatOf(const std::filesystem::path& path)
{
    const std::string extension = lowerExtension(path);
    for (const auto& [ending, format] : formatsByEnding)
        if (!extension.empty() && extension.substr(1) == ending) return format;
    return std::nullopt;
}

std::string videoEndings()
{
    std::string endings;
    for (const auto& each : formatsByEnding) (endings += endings.empty() ? "" : " ") += each.first;
    return endings;
}

std::string whyNoVideo(const VideoSpec& spec)
{
    const std::string size = std::to_string(spec.width) + " × " + std::to_string(spec.height);
    // Largest side that all formats support.
    constexpr int longest = 16383;
    if (spec.width < 1 || spec.height < 1 || spec.width > longest || spec.height > longest)
        return "A video has sides of 1 to 16383 pixels, and not " + size + "; give another size.";
    if (!(spec.framesPerSecond >= 0.1 && spec.framesPerSecond <= 240))
        return "A video has 0.1 to 240 frames a second; give another number.";
    if (storesHalfChroma(spec.format) && (spec.width % 2 != 0 || spec.height % 2 != 0))
        return "This kind of video keeps one color for two by two pixels and needs even sizes, and not " + size +
               "; give " + std::to_string(spec.width + spec.width % 2) + "x" +
               std::to_string(spec.height + spec.height % 2) + ", or choose .gif, .webp or .apng.";
    if (spec.format == VideoFormat::gif && spec.framesPerSecond > 50)
        return "A GIF counts in hundredths of a second, and programs show no more than 50 frames a second of it; give "
               "at most 50, or choose .webp or .apng.";
    if (spec.transparent && (spec.format == VideoFormat::mp4 || spec.format == VideoFormat::gif))
        return "Only the videos .webm, .webp and .apng can be transparent; choose one of them, or frames.";
    return {};
}

/// A part file that is being written.
class VideoFile::Output final : public VideoOutput {
public:
    Output(const PartFile& part, FileOps& ops) : ops_(ops)
    {
        file_ = ops.open(part.path().c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file_ < 0) part.fail("creating it", errno);
    }
    ~Output() override
    {
        if (file_ >= 0) ops_.close(file_);
    }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    bool write(const void* bytes, std::size_t count) noexcept override
    {
        const char* at = static_cast<const char*>(bytes);
        while (count > 0) {
            const ssize_t wrote = ops_.write(file_, at, count);
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote <= 0) error_ = wrote < 0 ? errno : ENOSPC;
            if (wrote <= 0) return false;
            at += wrote;
            count -= static_cast<std::size_t>(wrote);
        }
        return true;
    }
    bool seek(std::int64_t offset) noexcept override
    {
        if (::lseek(file_, offset, SEEK_SET) == offset) return true;
        error_ = errno;
        return false;
    }
    /// Closes the file. Returns 0, or the errno of the first failure.
    int close()
    {
        if (ops_.close(file_) != 0 && error_ == 0) error_ = errno;
        file_ = -1;
        return error_;
    }
    [[nodiscard]] int error() const { return error_; }

private:
    FileOps& ops_;
    int file_ = -1;
    int error_ = 0;
};

struct VideoFile::State {
    State(const std::filesystem::path& path, const VideoSpec& asked, FileOps& ops)
        : spec(legal(asked)), codec(videoCodec()), part(std::make_unique<PartFile>(path, ops)), output(*part, ops)
    {
    }

    VideoSpec spec;
    VideoCodec& codec;
    std::unique_ptr<PartFile> part;
    Output output;
    std::unique_ptr<VideoFrames> frames{};  ///< Declared after `output`, so destroyed before it.
    std::vector<std::uint8_t> codes{};
};

VideoFile::VideoFile(const std::filesystem::path& path, const VideoSpec& spec, FileOps& ops)
    : state_(std::make_unique<State>(path, spec, ops))
{
    State& s = *state_;
    require(s.codec.open(s.spec, s.part->path().string(), s.output, s.frames));
}

VideoFile::~VideoFile() = default;

void VideoFile::require(const std::string& problem)
{
    if (state_->output.error() != 0) state_->part->fail("writing", state_->output.error());
    if (problem.empty()) return;
    throw Failure(ErrorKind::file, "Cannot write " + state_->part->target().string() + ": " + problem +
                                       "; the old content is untouched; choose another kind of file, such as .apng.");
}

void VideoFile::add(const Image& image)
{
    State& s = *state_;
    assert(image.width == s.spec.width && image.height == s.spec.height && image.channels >= 3);
    const std::size_t channels = s.spec.transparent ? 4 : 3;
    const auto stride = static_cast<std::size_t>(image.channels);
    const std::size_t pixels = image.pixels.size() / stride;
    s.codes.resize(pixels * channels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < 3; ++c) s.codes[i * channels + c] = srgb8FromLinear(image.pixels[i * stride + c]);
        if (channels == 4) s.codes[i * channels + 3] = stride > 3 ? code8(image.pixels[i * stride + 3]) : 255;
    }
    require(s.frames->add(s.codes.data()));
}

std::unique_ptr<PartFile> VideoFile::staged()
{
    State& s = *state_;
    require(s.frames->close());
    s.frames.reset();
    if (const int error = s.output.close(); error != 0) s.part->fail("writing", error);
    return std::move(s.part);
}

void VideoFile::finish()
{
    staged()->publish();
}

}  // namespace vitrine::render
