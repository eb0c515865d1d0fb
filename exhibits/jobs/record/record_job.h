#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::jobs {

/// `vitrine record`: records a video, an animated picture, or the frames of one.
class RecordJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "record"; }
    [[nodiscard]] std::string_view title() const override { return "Record"; }
    [[nodiscard]] std::string_view product() const override { return "Recording"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Record a video or frames: around an exhibit, through the hall, or along the bookmarks of a tour";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override;
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    /// Returns true if the camera turns around its target or stays.
    [[nodiscard]] bool usesCamera(const ParameterValues&, const JobScene&) const override;
    [[nodiscard]] double effort(const ParameterValues&, const JobScene&) const override;
    /// Returns the values of small frames without motion blur.
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
    [[nodiscard]] std::string_view draftNote() const override
    {
        return "The preview has frames from start to end, small and with one sample per pixel.";
    }
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
    /// Returns the pattern of a video's frames. Frames that are files themselves need no merging.
    [[nodiscard]] std::string partItems(const std::filesystem::path& out) const override;
};

}  // namespace vitrine::jobs
