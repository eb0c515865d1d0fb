#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/study/study.h"
#include "exhibits/study/study_costs.h"

#include <optional>

namespace vitrine::jobs {

/// A study in progress, which draws in steps. Its folder is written by `JobOrder::writeFolder`.
class StudyRun final : public JobRun {
public:
    explicit StudyRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override { return study_ && study_->finished() ? Next::done : Next::draw; }
    void step(const Watch&) override;
    [[nodiscard]] double progress() const override { return study_ ? study_->progress() : 0; }
    [[nodiscard]] std::string_view doing() const override;
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override;
    /// The content of study.json.
    [[nodiscard]] render::Json answer() const override;

    /// The study, from the first step on.
    [[nodiscard]] const study::Study& study() const { return *study_; }
    [[nodiscard]] Subjects subjects() const { return order_.scene.museum->subjects(); }
    /// Returns the cost axis of the chart.
    [[nodiscard]] study::CostAxis costs() const;
    /// Returns the chosen values as a preset of the exhibit; for the hall, as an exhibition. Empty: nothing was chosen.
    [[nodiscard]] std::string chosenPreset() const;

private:
    [[nodiscard]] bool isPart() const;
    void end();

    JobOrder order_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::unique_ptr<study::Study> study_;  ///< Declared last: destroyed before the renderer that it uses.
    JobReport report_;
};

/// `vitrine study`: measures what accuracy costs.
class StudyJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "study"; }
    [[nodiscard]] std::string_view title() const override { return "Study"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Measure what accuracy costs: error over work and time, with pictures";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override { return {.anySettings = true, .inParts = true, .answers = true}; }
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    [[nodiscard]] std::vector<std::pair<const char*, const char*>> idleOptions(const ParameterValues&,
                                                                               const JobScene&) const override;
    /// Returns the pattern of the files with a part's measurements.
    [[nodiscard]] std::string partItems(const std::filesystem::path&) const override { return "%s.picture"; }
};

}  // namespace vitrine::jobs
