#include "exhibits/recording/recorder.h"

#include "render/files/number_text.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vitrine::recording {
namespace {

/// Returns the seconds from the first frame to the end of the motion.
double motionSeconds(const RecordingRequest& request)
{
    const int frames = request.frames();
    return (request.closed ? frames : frames - 1) / request.framesPerSecond;
}

std::string numbersText(const glm::dvec3& v)
{
    return render::shortestNumber(v.x) + ',' + render::shortestNumber(v.y) + ',' + render::shortestNumber(v.z);
}

std::string cameraText(const render::Camera& camera)
{
    return "eye " + numbersText(camera.eye) + " target " + numbersText(camera.target) + " fov " +
           render::shortestNumber(camera.fovY);
}

}  // namespace

int RecordingRequest::frames() const
{
    return std::max(static_cast<int>(std::lround(seconds * framesPerSecond)), 1);
}

std::vector<MotionSample> motionSamplesOf(const RecordingRequest& request, int k)
{
    const int count = request.shutter > 0 ? std::max(request.shutterSamples, 1) : 1;
    const double whole = motionSeconds(request);
    std::vector<MotionSample> moments;
    for (int j = 0; j < count; ++j) {
        // The times are at the centers of equal parts of the exposure.
        const double within = request.shutter > 0 ? request.shutter * (j + 0.5) / count : 0;
        const double time = (k + within) / request.framesPerSecond;
        const double part = whole > 0 ? time / whole : 0;
        const double motionPart = request.closed ? part - std::floor(part) : std::min(part, 1.0);
        moments.push_back({request.camera(motionPart), request.picture.frame.time + time});
    }
    return moments;
}

PictureRequest pictureAt(const RecordingRequest& request, int k)
{
    PictureRequest picture = request.picture;
    const MotionSample first = motionSamplesOf(request, k).front();
    picture.frame.camera = first.camera;
    picture.frame.time = first.time;
    const bool hasBefore = k > 0 || request.closed;
    if (picture.before) picture.before->camera = motionSamplesOf(request, hasBefore ? k - 1 : k).front().camera;
    return picture;
}

std::string frameLine(const RecordingRequest& request, int k)
{
    const FrameRequest& frame = request.picture.frame;
    std::string line = "Frame " + std::to_string(k) + ", " + std::to_string(frame.raster.size.x) + " x " +
                       std::to_string(frame.raster.size.y) + ", " + std::to_string(request.picture.samples) +
                       " samples, seed " + std::to_string(frame.seed);
    if (frame.alone) line += ", alone " + std::to_string(*frame.alone);
    if (frame.subject) line += ", subject " + std::to_string(*frame.subject);
    if (frame.transparent) line += ", transparent";
    if (frame.exhibitTransform != glm::dmat4(1)) {
        line += ", transform";
        for (int column = 0; column < 3; ++column)
            line += ' ' + numbersText(glm::dvec3(frame.exhibitTransform[column]));
    }
    for (const MotionSample& moment : motionSamplesOf(request, k))
        line += "; " + render::shortestNumber(moment.time) + " s " + cameraText(moment.camera);
    return line;
}

FrameMaker::FrameMaker(const Museum& museum, render::RenderBackend& backend, SceneState sceneState,
                       const RecordingRequest& request, int k)
    : museum_(museum), backend_(backend), sceneState_(std::move(sceneState)), request_(pictureAt(request, k)),
      moments_(motionSamplesOf(request, k))
{
    begin();
}

void FrameMaker::begin()
{
    request_.frame.camera = moments_[done_].camera;
    request_.frame.time = moments_[done_].time;
    SceneState sceneState = sceneState_;
    sceneState.camera = request_.frame.camera;
    maker_ = std::make_unique<PictureMaker>(museum_, backend_, std::move(sceneState), request_);
}

bool FrameMaker::step()
{
    if (done_ == moments_.size()) return false;
    maker_->step();
    if (maker_->finished()) take();
    return true;
}

void FrameMaker::take()
{
    render::Image picture = maker_->picture();
    ++done_;
    if (moments_.size() > 1) {
        for (std::size_t i = 0; i < picture.pixels.size(); i += 4)
            for (std::size_t c = 0; c < 3; ++c) picture.pixels[i + c] *= picture.pixels[i + 3];
        if (done_ > 1)
            std::transform(sum_.pixels.begin(), sum_.pixels.end(), picture.pixels.begin(), picture.pixels.begin(),
                           std::plus());
    }
    sum_ = std::move(picture);
    if (done_ < moments_.size()) {
        begin();
        return;
    }
    if (moments_.size() > 1) divide();
    maker_.reset();
}

void FrameMaker::divide()
{
    const auto count = static_cast<float>(moments_.size());
    for (std::size_t i = 0; i < sum_.pixels.size(); i += 4) {
        const float alpha = sum_.pixels[i + 3];
        for (std::size_t c = 0; c < 3; ++c) sum_.pixels[i + c] /= alpha > 0 ? alpha : 1;
        sum_.pixels[i + 3] = alpha / count;
    }
}

double FrameMaker::progress() const
{
    return (static_cast<double>(done_) + (maker_ ? maker_->progress() : 0)) / static_cast<double>(moments_.size());
}

}  // namespace vitrine::recording
