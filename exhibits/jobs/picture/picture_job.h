#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/museum/picture.h"
#include "render/image/image_io.h"

namespace vitrine::jobs {

/// Run that draws one picture. Its file carries the settings, so no document lies beside it.
class PictureRun final : public JobRun {
public:
    explicit PictureRun(JobOrder);

    [[nodiscard]] Next next() const override;
    void step(const Watch&) override;
    [[nodiscard]] double progress() const override;
    [[nodiscard]] std::string_view doing() const override { return "drawing"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override;

    /// Returns the picture of a run without an output; empty until the run is done.
    [[nodiscard]] const render::Image& picture() const { return picture_; }
    [[nodiscard]] render::Image previewPicture() const override { return picture_; }
    [[nodiscard]] const JobScene& scene() const { return order_.scene; }
    [[nodiscard]] const PictureRequest& request() const { return request_; }

private:
    void begin();
    void end();

    JobOrder order_;
    PictureRequest request_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::unique_ptr<PictureMaker> maker_;
    render::Image picture_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    bool isDone_ = false;
};

/// `vitrine render`: draws one picture.
class PictureJob final : public Job {
public:
    [[nodiscard]] std::string_view name() const override { return "render"; }
    [[nodiscard]] std::string_view title() const override { return "Export picture"; }
    [[nodiscard]] std::string_view product() const override { return "Picture"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "Render an exhibit at its place in the hall, or the hall, to a file; needs no display";
    }
    [[nodiscard]] const Parameters& parameters() const override;
    [[nodiscard]] JobNeeds needs() const override;
    [[nodiscard]] std::shared_ptr<const JobInputs> read(const ParameterValues&) const override;
    [[nodiscard]] JobPlan plan(const ParameterValues&, const JobScene&, const JobInputs&,
                               const std::filesystem::path& out) const override;
    [[nodiscard]] std::unique_ptr<JobRun> start(JobOrder) const override;
    /// Widens the view if the picture is narrower than those for which views are made, and the window shows it.
    [[nodiscard]] JobScene sceneFor(const ParameterValues&, JobScene) const override;
    [[nodiscard]] ParameterValues draft(const ParameterValues&, const JobInputs&) const override;
    [[nodiscard]] double effort(const ParameterValues&, const JobScene&) const override;
    [[nodiscard]] std::string_view draftNote() const override
    {
        return "The preview is smaller, with one sample per pixel.";
    }
    [[nodiscard]] JobForecast forecast(const ParameterValues&, const FinishedDraft&,
                                       const std::filesystem::path&) const override;
};

/// Returns the picture that these values order. `out` decides whether samples are averaged in linear light, and which
/// channels the picture has.
[[nodiscard]] PictureRequest pictureRequest(const ParameterValues&, const JobScene&, const std::filesystem::path& out);

/// Returns the format of the file. Throws Failure (ErrorKind::usage) if its extension belongs to no format, or to one
/// without 16 bits.
[[nodiscard]] render::PictureFormat pictureFormat(const ParameterValues&, const std::filesystem::path& out);

/// Returns what the file of a picture says about it: the settings, and the attributes of OpenEXR (`exrMetadata`).
[[nodiscard]] render::PictureMetadata pictureMetadata(const JobScene&, const PictureRequest&);

/// Writes a finished picture in the format of the values and of its name, with its metadata, as a file that does not
/// yet replace `out`.
[[nodiscard]] std::unique_ptr<render::PartFile> stagedPicture(const JobScene&, const PictureRequest&,
                                                              const ParameterValues&, const std::filesystem::path& out,
                                                              const render::Image&);

}  // namespace vitrine::jobs
