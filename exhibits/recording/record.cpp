#include "exhibits/recording/record.h"

#include "exhibits/museum/exr_metadata.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/image/image_io.h"
#include "render/video/video_file.h"

#include <optional>

namespace vitrine::recording {
namespace {

namespace fs = std::filesystem;

/// Position of "%04d" or "%d" in a name, and the least number of digits.
struct NumberPlace {
    std::size_t begin = 0, end = 0;
    int digits = 1;
};
std::optional<NumberPlace> numberPlace(const std::string& name)
{
    NumberPlace place;
    place.begin = name.find('%');
    if (place.begin == std::string::npos || name.find('%', place.begin + 1) != std::string::npos) return std::nullopt;
    std::size_t at = place.begin + 1;
    if (at + 1 < name.size() && name[at] == '0' && name[at + 1] >= '1' && name[at + 1] <= '9') {
        place.digits = name[at + 1] - '0';
        at += 2;
    }
    if (at >= name.size() || name[at] != 'd') return std::nullopt;
    place.end = at + 1;
    return place;
}

render::VideoSpec specOf(const RecordingRequest& request, render::VideoFormat format)
{
    const FrameRequest& frame = request.picture.frame;
    return {format, frame.raster.size.x, frame.raster.size.y, request.framesPerSecond, frame.transparent, {}};
}

/// Returns whether frames of this name hold linear light.
bool isLinear(const fs::path& out)
{
    return render::lowerExtension(out) == ".exr";
}

/// Returns whether a frame with the same preset and description exists.
bool isThere(const fs::path& path, const std::string& preset, const std::string& line)
{
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return false;
    try {
        return render::embeddedPreset(path) == preset && render::embeddedDescription(path) == line;
    } catch (const Failure&) {
        return false;  // Another program's file, or a broken one, is replaced.
    }
}

}  // namespace

bool isFramePattern(const fs::path& out)
{
    return numberPlace(out.filename().string()) && (render::lowerExtension(out) == ".png" || isLinear(out));
}

std::string whyNotRecordable(const RecordingRequest& request, const fs::path& out)
{
    if (isFramePattern(out)) return {};
    const std::optional<render::VideoFormat> format = render::videoFormatOf(out);
    if (format) return render::whyNoVideo(specOf(request, *format));
    return "\"" + out.string() +
           "\" is not a valid name of a recording; give one that ends in .mp4, .webm, .gif, .webp or .apng, or "
           "frames/%04d.png "
           "or .exr.";
}

fs::path framePath(const fs::path& pattern, int k)
{
    std::string name = pattern.filename().string();
    const NumberPlace place = numberPlace(name).value_or(NumberPlace{});
    std::string number = std::to_string(k + 1);
    if (const auto digits = static_cast<std::size_t>(place.digits); number.size() < digits)
        number.insert(0, digits - number.size(), '0');
    return pattern.parent_path() / name.replace(place.begin, place.end - place.begin, number);
}

Recording::Recording(const Museum& museum, render::RenderBackend& backend, RecordedScene scene,
                     RecordingRequest request, fs::path out, RecordingShare share)
    : museum_(museum), backend_(backend), sceneState_(std::move(scene.state)), subject_(scene.subject),
      request_(std::move(request)), out_(std::move(out)), share_(std::move(share))
{
    if (const std::string why = whyNotRecordable(request_, out_); !why.empty()) throw Failure(ErrorKind::usage, why);
    if (!isFramePattern(out_)) {
        render::VideoSpec spec = specOf(request_, *render::videoFormatOf(out_));
        spec.comment = presetAt(0);
        video_ = std::make_unique<render::VideoFile>(out_, spec);
        return;
    }
    if (isLinear(out_)) request_.picture.frame.averageIn = AverageIn::radiance;
}

Recording::~Recording() = default;

std::string Recording::presetAt(int k) const
{
    return pictureSettings(museum_, subject_, sceneState_, pictureAt(request_, k),
                           "Recording of " + std::string(museum_.subject(subject_).name()));
}

void Recording::beginFrame()
{
    for (; !video_ && next_ < request_.frames(); ++next_) {
        if (share_.draws && !share_.draws(next_)) continue;
        if (!isThere(framePath(out_, next_), presetAt(next_), frameLine(request_, next_))) break;
        ++kept_;
    }
    if (next_ < request_.frames())
        maker_ = std::make_unique<FrameMaker>(museum_, backend_, sceneState_, request_, next_);
}

void Recording::writeFrame()
{
    render::PictureMetadata metadata = exrMetadata(museum_, pictureAt(request_, next_));
    metadata.preset = presetAt(next_);
    metadata.description = frameLine(request_, next_);
    const render::PictureFormat format = isLinear(out_) ? render::PictureFormat::exr : render::PictureFormat::png8;
    render::writePicture(framePath(out_, next_), maker_->picture(), format, metadata);
}

void Recording::endFrame()
{
    if (video_)
        video_->add(maker_->picture());
    else
        writeFrame();
    maker_.reset();
    ++next_;
    ++drawn_;
}

void Recording::takeFrame()
{
    const fs::path path = framePath(share_.from, next_);
    if (!isThere(path, presetAt(next_), frameLine(request_, next_)))
        throw Failure(ErrorKind::check, path.string() + ": this frame is missing or of other settings; draw it anew.");
    video_->add(render::readColor(path));
    ++next_;
    ++kept_;
}

bool Recording::step()
{
    if (finished_) return false;
    if (!share_.from.empty())
        takeFrame();
    else if (!maker_)
        beginFrame();
    if (maker_) {
        maker_->step();
        if (maker_->finished()) endFrame();
    }
    finished_ = next_ == request_.frames();
    return true;
}

void Recording::publish()
{
    if (video_) video_->finish();
}

double Recording::progress() const
{
    return (next_ + (maker_ ? maker_->progress() : 0)) / request_.frames();
}

}  // namespace vitrine::recording
