#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::jobs {

/// `vitrine lesson export`: writes a lesson as a page to print and as slides, with a picture for each step.
class HandoutJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "handout"; }
    [[nodiscard]] std::string_view command() const override { return "lesson export"; }
    [[nodiscard]] std::string_view title() const override { return "Export lesson"; }
    [[nodiscard]] std::string_view product() const override { return "Handout of a lesson"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Write a lesson as a page to print and as slides, with a picture for each step";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override
    {
        return {.anySettings = true, .inWindow = true, .preview = PreviewForm::picture};
    }
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    [[nodiscard]] std::string_view draftNote() const override { return "The preview shows the picture of one step."; }
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
};

}  // namespace vitrine::jobs
