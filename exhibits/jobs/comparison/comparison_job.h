#pragma once

#include "exhibits/compare/comparison.h"
#include "exhibits/jobs/comparison/comparison_json.h"
#include "exhibits/jobs/kit/job.h"

#include <optional>

namespace vitrine::jobs {

/// A comparison in progress, which draws in steps.
class ComparisonRun final : public JobRun {
public:
    explicit ComparisonRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override
    {
        return comparison_ && comparison_->finished() ? Next::done : Next::draw;
    }
    void step(const Watch&) override;
    [[nodiscard]] double progress() const override { return comparison_ ? comparison_->progress() : 0; }
    [[nodiscard]] std::string_view doing() const override { return "comparing"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override;
    /// The pictures of A and B beside each other.
    [[nodiscard]] render::Image previewPicture() const override;
    /// The content of comparison.json.
    [[nodiscard]] render::Json answer() const override;

    /// The comparison, from the first step on.
    [[nodiscard]] const compare::Comparison& comparison() const { return *comparison_; }
    [[nodiscard]] Subjects subjects() const { return order_.scene.museum->subjects(); }
    [[nodiscard]] ComparisonText text() const;

private:
    void end();

    JobOrder order_;
    std::array<std::string, 2> names_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::optional<compare::Comparison> comparison_;  ///< Declared last: destroyed before the renderer that it uses.
    JobReport report_;
};

/// `vitrine compare-settings`: shows two settings beside each other, and what each costs.
class ComparisonJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "comparison"; }
    [[nodiscard]] std::string_view command() const override { return "compare-settings"; }
    [[nodiscard]] std::string_view title() const override { return "Comparison"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Compare two settings on one page: pictures, differences, costs pass by pass";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override
    {
        return {.twoSettings = true,
                .inWindow = true,
                .answers = true,
                .timesPasses = true,
                .preview = PreviewForm::picture};
    }
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    [[nodiscard]] JobScene sceneFor(const ParameterValues&, JobScene) const override;
    [[nodiscard]] std::string_view draftNote() const override
    {
        return "The preview is smaller and shows A at the left, B at the right; its times are those of one frame.";
    }
    [[nodiscard]] double effort(const ParameterValues&, const JobScene&) const override;
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
};

}  // namespace vitrine::jobs
