#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/recording/camera_path.h"

#include <memory>
#include <optional>
#include <string>

namespace vitrine {

/// A film to make: every frame is a function of this and its number alone.
struct RecordingRequest {
    PictureRequest picture;  ///< Of every frame; its time is that of the first one, its camera is not used.
    CameraMotion camera;
    double seconds = 8;
    double framesPerSecond = 30;
    bool closed = false;     ///< The frame after the last one would be the first again: it can be shown in a loop.
    double shutter = 0;      ///< Share of a frame's time for which it is exposed, 0 to 1.
    int shutterSamples = 8;  ///< Moments that are averaged over it; where the shutter is 0, one is drawn.

    /// At least 1.
    [[nodiscard]] int frames() const;
};

/// Where and when the moments of frame `k` are, in order: times begin at the request's plus k / framesPerSecond.
[[nodiscard]] std::vector<Moment> momentsOf(const RecordingRequest&, int k);

/// How the frame is made besides the settings of everything, one line: two frames of the same settings and the same
/// line are the same picture.
[[nodiscard]] std::string frameLine(const RecordingRequest&, int k);

/// Makes one frame step by step, as PictureMaker makes a picture.
class FrameMaker {
public:
    /// Museum and backend must outlive it. Throws Failure as PictureMaker.
    FrameMaker(const Museum&, render::RenderBackend&, SceneState, const RecordingRequest&, int k);

    /// Draws one sample of one tile of one moment. Returns false when it was already finished.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const { return done_ == moments_.size(); }
    /// As PictureMaker::picture: the mean of the moments, colors weighed by their alpha. Only when finished.
    [[nodiscard]] const render::Image& picture() const { return sum_; }

private:
    void begin();
    void take();
    void divide();

    const Museum& museum_;
    render::RenderBackend& backend_;
    SceneState sceneState_;
    PictureRequest request_;
    std::vector<Moment> moments_;
    std::size_t done_ = 0;
    std::unique_ptr<PictureMaker> maker_;
    render::Image sum_;
};

}  // namespace vitrine
