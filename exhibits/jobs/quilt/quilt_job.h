#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::jobs {

/// `vitrine quilt`: draws many views of an exhibit into one picture, for light-field displays.
class QuiltJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "quilt"; }
    [[nodiscard]] std::string_view title() const override { return "Export quilt"; }
    [[nodiscard]] std::string_view product() const override { return "Quilt"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Draw many views of an exhibit into one picture, for light-field displays";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override;
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    [[nodiscard]] double effort(const ParameterValues&, const JobScene&) const override;
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
    [[nodiscard]] std::string_view draftNote() const override
    {
        return "The views of the preview are smaller, with one sample per pixel.";
    }
};

}  // namespace vitrine::jobs
