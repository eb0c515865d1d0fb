#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/recording/camera_path.h"

#include <memory>
#include <optional>
#include <string>

namespace vitrine::recording {

/// Input of a recording. Every frame depends on this and on its index only.
struct RecordingRequest {
    PictureRequest picture;  ///< Request of every frame. Its time is that of the first frame; its camera is not used.
    CameraMotion camera;
    double seconds = 0;
    double framesPerSecond = 1;
    bool closed = false;     ///< Whether the frame after the last one equals the first, so the recording can be looped.
    double shutter = 0;      ///< Share of a frame's duration for which it is exposed, 0 to 1.
    int shutterSamples = 1;  ///< Number of averaged times within the exposure; 1 if the shutter is 0.

    /// Returns the number of frames, at least 1.
    [[nodiscard]] int frames() const;
};

/// Returns cameras and times of the samples of frame `k`, in order. Times begin at the request's plus k /
/// framesPerSecond.
[[nodiscard]] std::vector<MotionSample> motionSamplesOf(const RecordingRequest&, int k);

/// Returns the request of frame `k` with its first camera and time, and with the camera of the frame before if it has
/// motion vectors. Before the first frame of a recording that is no loop, the camera stood still.
[[nodiscard]] PictureRequest pictureAt(const RecordingRequest&, int k);

/// Returns one line on how the frame is made, besides the settings. Two frames with the same settings and the same line
/// are the same picture.
[[nodiscard]] std::string frameLine(const RecordingRequest&, int k);

/// Makes one frame step by step, as PictureMaker makes a picture.
class FrameMaker {
public:
    /// Museum and backend must outlive it. Throws Failure like PictureMaker.
    FrameMaker(const Museum&, render::RenderBackend&, SceneState, const RecordingRequest&, int k);

    /// Draws one sample of one tile at one time. Returns false if the frame is finished.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const { return done_ == moments_.size(); }
    /// Returns the mean of the samples in the format of PictureMaker::picture, with colors weighted by alpha. Valid
    /// once finished.
    [[nodiscard]] const render::Image& picture() const { return sum_; }

private:
    void begin();
    void take();
    void divide();

    const Museum& museum_;
    render::RenderBackend& backend_;
    SceneState sceneState_;
    PictureRequest request_;
    std::vector<MotionSample> moments_;
    std::size_t done_ = 0;
    std::unique_ptr<PictureMaker> maker_;
    render::Image sum_;
};

}  // namespace vitrine::recording
