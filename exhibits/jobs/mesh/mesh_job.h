#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::jobs {

/// `vitrine mesh`: makes a closed mesh of a scene's surface, for other programs and 3D printers.
class MeshJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "mesh"; }
    [[nodiscard]] std::string_view title() const override { return "Export mesh"; }
    [[nodiscard]] std::string_view product() const override { return "Mesh"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Make a closed mesh of a scene's surface, for other programs and 3D printers";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override;
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    /// Returns the values with the scene that SDF Scenes shows, unless a file is given.
    [[nodiscard]] ParameterValues withScene(const ParameterValues&, const JobScene&) const override;
    /// Returns the values of a coarser mesh.
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
    [[nodiscard]] std::string_view draftNote() const override { return "The preview has larger cells."; }
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
    /// Returns no scene: a mesh depends on its file alone.
    [[nodiscard]] JobScene sceneFor(const ParameterValues&, JobScene) const override { return {}; }
};

}  // namespace vitrine::jobs
