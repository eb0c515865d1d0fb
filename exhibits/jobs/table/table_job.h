#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::jobs {

/// `vitrine table`: runs the measurements of an exhibit (`MeasuresTable`) and writes them as text with separators.
class TableJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "table"; }
    [[nodiscard]] std::string_view title() const override { return "Export measurements"; }
    [[nodiscard]] std::string_view product() const override { return "Table"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Run the measurements of an exhibit, such as the methods of the pixel art, and write them as CSV";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override
    {
        return {.anySettings = true,
                .extensions = {"csv"},
                .inWindow = true,
                .timesPasses = true,
                .preview = PreviewForm::text};
    }
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    /// Returns the values of a run that measures the first lines.
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
    [[nodiscard]] std::string_view draftNote() const override { return "The preview shows the first lines."; }
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
};

}  // namespace vitrine::jobs
