#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::jobs {

/// `vitrine shader export`: writes a visitor's shader, or one that draws an exhibit, for other programs.
class ShaderJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "shader"; }
    [[nodiscard]] std::string_view command() const override { return "shader export"; }
    [[nodiscard]] std::string_view title() const override { return "Export shader"; }
    [[nodiscard]] std::string_view product() const override { return "Shader"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Write a shader as a web page, as ISF or as Shadertoy code, with the present values of its inputs";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override
    {
        return {.anySettings = true,
                .fileOf = {"your_shader", "file"},
                .extensions = {"html", "fs", "glsl", "json"},
                .inWindow = true,
                .preview = PreviewForm::text};
    }
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    [[nodiscard]] std::string_view draftNote() const override { return "The preview shows the text of the shader."; }
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
};

}  // namespace vitrine::jobs
