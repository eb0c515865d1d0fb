#pragma once

#include "exhibits/recording/recorder.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace vitrine::render {
class VideoFile;
}

namespace vitrine {

/// Throws Failure (Blame::usage) naming what to give instead when `out` is no name of a video (render::videoFormatOf)
/// nor of frames, "folder/%04d.png", or the request's size, frame rate or transparency is not of that kind of video.
void requireRecordable(const RecordingRequest&, const std::filesystem::path& out);

/// The file of frame `k` (from 0), which is counted from 1: "folder/0001.png".
[[nodiscard]] std::filesystem::path framePath(const std::filesystem::path& pattern, int k);

/// Of which frames a recording is made, where it is not drawn as a whole by one process.
struct RecordingShare {
    std::function<bool(int)> draws = {};  ///< Whether frame k (from 0) is drawn: of frames only. Empty: all are.
    std::filesystem::path from = {};      ///< Frames that were drawn before, "folder/%04d.png": of a video only.
};

/// Draws all frames into a video, or into PNG files, step by step. Each file carries the settings of everything as a
/// preset, a frame with its own camera. A video that is not finished leaves nothing; frames stay as far as they are
/// drawn, each of them whole, and those that are there already, made by the same settings and the same program, are
/// kept.
class Recording {
public:
    /// Museum and backend must outlive it. Throws Failure as `requireRecordable`, render::VideoFile, and when the
    /// frames' folder cannot be made.
    Recording(const Museum&, render::RenderBackend&, SceneState, std::size_t subject, RecordingRequest,
              std::filesystem::path out, RecordingShare = {});
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// As FrameMaker::step, and writes what is finished. Returns false when all was finished already. Throws Failure as
    /// FrameMaker, render::VideoFile and render::writePicture; Blame::check where a frame that was drawn before is of
    /// other settings.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const { return finished_; }
    [[nodiscard]] int drawn() const { return drawn_; }  ///< Frames, by this one.
    [[nodiscard]] int kept() const { return kept_; }    ///< Frames that were there already.

private:
    [[nodiscard]] std::string presetAt(int k) const;
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
    std::unique_ptr<render::VideoFile> video_;  ///< Null: frames.
    std::unique_ptr<FrameMaker> maker_;
    int next_ = 0, drawn_ = 0, kept_ = 0;
    bool finished_ = false;
};

}  // namespace vitrine
