#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/jobs/sprite/sprite_shots.h"
#include "render/files/atomic_write.h"

namespace vitrine::jobs {

/// Inputs of the job, read from files.
struct SpriteInputs final : JobInputs {
    explicit SpriteInputs(std::shared_ptr<const SpriteSubject> read) : object(std::move(read)) {}
    std::shared_ptr<const SpriteSubject> object;  ///< Object of which sprites are drawn.
    std::vector<Rgb8> palette{};                  ///< Colors of the palette's file, if one is taken.
};

/// Run that draws a sprite sheet. The preview shows the sheet when the run is done.
class SpriteRun final : public JobRun {
public:
    explicit SpriteRun(JobOrder);

    [[nodiscard]] Next next() const override;
    void step(const Watch&) override;
    [[nodiscard]] double progress() const override;
    [[nodiscard]] std::string_view doing() const override;
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override;

    /// Returns the sheet; null until the run is done.
    [[nodiscard]] const SpriteSheet* sheet() const { return sheet_.get(); }

private:
    void makeSheet();

    JobOrder order_;
    std::shared_ptr<const SpriteSubject> object_;
    SpriteShots shots_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::unique_ptr<SpriteSheet> sheet_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
};

/// `vitrine sprite`: draws an object from all sides as a sprite sheet.
class SpriteJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "sprite"; }
    [[nodiscard]] std::string_view title() const override { return "Export sprites"; }
    [[nodiscard]] std::string_view product() const override { return "Sprites"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Draw an object from all sides as a sprite sheet, with normals, depth and Aseprite's JSON beside it";
    }
    [[nodiscard]] const Parameters& parameters() const override { return spriteTable(); }
    [[nodiscard]] JobNeeds needs() const override;
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    /// Returns values with fewer frames and directions if drawing all of them takes long.
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
};

}  // namespace vitrine::jobs
