#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/recording/recorder.h"

#include <optional>
#include <vector>

namespace vitrine::jobs {

/// Draft of a recording: draws some of its frames, evenly spaced over its path, and writes nothing. Two of them are
/// drawn together with the frame that follows, by which the size of a video is judged.
class RecordPreview final : public JobRun {
public:
    /// Returns the request with the motion of the camera. Throws Failure (ErrorKind::usage).
    using RequestMaker = recording::RecordingRequest (*)(const JobOrder&);

    RecordPreview(JobOrder, RequestMaker);

    [[nodiscard]] Next next() const override;
    void step(const Watch&) override;
    [[nodiscard]] double progress() const override;
    [[nodiscard]] std::string_view doing() const override { return "recording"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override {}
    /// Returns the frames in rows of two, the first one at the upper left.
    [[nodiscard]] render::Image previewPicture() const override;

    /// Returns the size in bytes of the recording with these frames, were its pictures as small as those of the draft.
    /// Valid once the run is done. Throws Failure as `videoBytes` and `pictureBytes` do.
    [[nodiscard]] double bytes(const std::filesystem::path& out) const;
    [[nodiscard]] const recording::RecordingRequest& request() const { return *request_; }

private:
    struct Frame {
        int number = 0;  ///< In the recording, from 0.
        bool isShown = true;
        render::Image picture = {};
    };
    void chooseFrames();

    JobOrder order_;
    RequestMaker makeRequest_;
    std::optional<recording::RecordingRequest> request_;
    std::vector<Frame> frames_;
    std::size_t drawn_ = 0;
    std::unique_ptr<render::RenderBackend> backend_;
    std::unique_ptr<recording::FrameMaker> maker_;  ///< Declared last: destroyed before the renderer that it uses.
    JobReport report_;
};

}  // namespace vitrine::jobs
