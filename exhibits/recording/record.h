#pragma once

#include "exhibits/recording/recorder.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace vitrine::render {
class VideoFile;
}

namespace vitrine::recording {

/// Returns whether the name is that of frames: "folder/%04d.png", or ".exr" for linear light.
[[nodiscard]] bool isFramePattern(const std::filesystem::path& out);

/// Returns why nothing can be recorded under this name, as a sentence with an alternative; empty if it can. `out` must
/// be the name of a video (render::videoFormatOf) or of frames. The request's size, frame rate and transparency must
/// suit that kind of video.
[[nodiscard]] std::string whyNotRecordable(const RecordingRequest&, const std::filesystem::path& out);

/// Returns the file of frame `k` (from 0); names count from 1: "folder/0001.png".
[[nodiscard]] std::filesystem::path framePath(const std::filesystem::path& pattern, int k);

/// Frames that this process draws, if several make a recording.
struct RecordingShare {
    std::function<bool(int)> draws = {};  ///< Whether frame k (from 0) is drawn; for frames only. Empty: all are.
    std::filesystem::path from = {};      ///< Frames drawn earlier, "folder/%04d.png"; for a video only.
};

/// Scene state to record, and the exhibit that is shown.
struct RecordedScene {
    SceneState state;
    std::size_t subject = 0;
};

/// Draws all frames into a video, or into PNG or OpenEXR files, step by step. Each file contains all settings as a
/// preset; that of a frame includes its camera.
///
/// An unfinished video leaves no file. Frames remain as far as they are drawn, each of them complete. Existing frames
/// made with the same settings and the same program are kept.
class Recording {
public:
    /// Museum and backend must outlive it; the folder must exist. Throws Failure for what `whyNotRecordable` refuses,
    /// and like render::VideoFile.
    Recording(const Museum&, render::RenderBackend&, RecordedScene, RecordingRequest, std::filesystem::path out,
              RecordingShare = {});
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// Works like FrameMaker::step, and writes what is finished. Returns false if everything is finished. Throws
    /// Failure like FrameMaker, render::VideoFile and render::writePicture, and ErrorKind::check if a frame drawn
    /// earlier has other settings.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const { return finished_; }
    /// Puts a finished video in place. Frames are in place already. On any thread. Throws Failure like
    /// render::VideoFile.
    void publish();
    [[nodiscard]] int drawn() const { return drawn_; }  ///< Frames that this object drew.
    [[nodiscard]] int kept() const { return kept_; }    ///< Frames that existed already.

private:
    [[nodiscard]] std::string presetAt(int k) const;
    void writeFrame();
    void beginFrame();
    void endFrame();
    void takeFrame();

    const Museum& museum_;
    render::RenderBackend& backend_;
    SceneState sceneState_;
    std::size_t subject_;
    RecordingRequest request_;
    std::filesystem::path out_;
    RecordingShare share_;
    std::unique_ptr<render::VideoFile> video_;  ///< Null if frames are written.
    std::unique_ptr<FrameMaker> maker_;
    int next_ = 0, drawn_ = 0, kept_ = 0;
    bool finished_ = false;
};

}  // namespace vitrine::recording
