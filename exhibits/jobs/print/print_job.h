#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/printing/print_table.h"

namespace vitrine::jobs {

/// `vitrine print`: interlaces views of a scene or pictures into a print for a lenticular sheet, or writes a
/// calibration chart.
class PrintJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "print"; }
    [[nodiscard]] std::string_view title() const override { return "Export lenticular print"; }
    [[nodiscard]] std::string_view product() const override { return "Lenticular print"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Interlace views into a print for a lenticular sheet";
    }
    [[nodiscard]] const Parameters& parameters() const override { return printing::printTable(); }
    [[nodiscard]] JobNeeds needs() const override;
    /// Reads nothing: pictures are read by the run, after everything that can be refused without them.
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    /// Returns the values with the lenses of the sheet that is named.
    [[nodiscard]] ParameterValues completed(const GivenArguments&) const override;
    /// Saved views need no print.
    [[nodiscard]] bool needsOutput(const ParameterValues&) const override;
    [[nodiscard]] std::string refusedInParts(const ParameterValues&) const override;
    /// Views, each of which has a picture.
    [[nodiscard]] std::string partItems(const std::filesystem::path&) const override { return "view_%04d.picture"; }
};

}  // namespace vitrine::jobs
