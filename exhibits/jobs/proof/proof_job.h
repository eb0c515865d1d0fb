#pragma once

#include "exhibits/jobs/kit/job.h"
#include "render/image/picture_formats.h"

namespace vitrine::jobs {

/// `vitrine proof`: shows an interlaced print as it looks through its lens sheet.
class ProofJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "proof"; }
    [[nodiscard]] std::string_view title() const override { return "Proof of a print"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Show an interlaced print as it looks through its lens sheet, one pixel for each lens";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override { return {.extensions = render::writtenEndings(8)}; }
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
};

}  // namespace vitrine::jobs
