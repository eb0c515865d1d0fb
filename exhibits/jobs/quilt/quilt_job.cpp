#include "exhibits/jobs/quilt/quilt_job.h"

#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/quilt/quilt_table.h"
#include "exhibits/museum/picture_settings.h"
#include "exhibits/printing/quilt.h"
#include "exhibits/printing/view_maker.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/number_text.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <optional>

namespace vitrine::jobs {

const QuiltTable& quiltTable()
{
    static const QuiltTable table;
    return table;
}

namespace quilts {
namespace {

constexpr int longestSide = 16384;  ///< Pixels of a quilt: what displays and graphics cards take.
constexpr int draftSide = 960;      ///< Pixels of a quilt in the preview.

printing::QuiltGrid gridOf(const ParameterValues& values)
{
    const QuiltTable& t = quiltTable();
    return {values[t.columns], values[t.rows], static_cast<double>(values[t.width]) / values[t.height]};
}

glm::ivec2 quiltSize(const ParameterValues& values)
{
    const QuiltTable& t = quiltTable();
    return {values[t.columns] * values[t.width], values[t.rows] * values[t.height]};
}

int samplesOf(const ParameterValues& values, const JobScene& scene)
{
    if (const int given = values[quiltTable().samples]; given > 0) return given;
    if (scene.usual.samples > 0) return scene.usual.samples;
    return scene.museum ? usualSamples(scene.state.hall()) : 1;
}

/// Returns the picture of the camera in the middle, whose target is in the plane that is sharp.
PictureRequest middleRequest(const ParameterValues& values, const JobScene& scene)
{
    const QuiltTable& t = quiltTable();
    PictureRequest request;
    request.frame = scene.frame;
    request.frame.raster.size = {values[t.width], values[t.height]};
    request.frame.needsFiles = true;
    request.samples = samplesOf(values, scene);
    render::Camera& camera = request.frame.camera;
    if (const double distance = values[t.convergence]; distance > 0)
        camera.target = camera.eye + distance * glm::normalize(camera.target - camera.eye);
    return request;
}

std::vector<printing::ViewShot> shotsOf(const JobOrder& order)
{
    const int count = gridOf(order.values).count();
    printing::ViewShot middle{order.scene.state, middleRequest(order.values, order.scene)};
    middle.request.largestTile = order.largestTile;
    std::vector<printing::ViewShot> shots(static_cast<std::size_t>(count), middle);
    for (int k = 0; k < count; ++k) {
        printing::ViewShot& shot = shots[static_cast<std::size_t>(k)];
        const double cone = order.values[quiltTable().cone];
        shot.request.frame.camera = printing::quiltCamera(middle.request.frame.camera, k, count, cone);
        shot.sceneState.camera = shot.request.frame.camera;
    }
    return shots;
}

std::vector<Fact> factsOf(const ParameterValues& values, const JobScene& scene)
{
    const glm::dvec2 size = quiltSize(values);
    return {{"Views", static_cast<double>(gridOf(values).count())},
            {"Size", render::shortestNumber(size.x) + " × " + render::shortestNumber(size.y), "px"},
            {"Samples per pixel", static_cast<double>(samplesOf(values, scene))}};
}

/// Returns a picture without its alpha, unless it is transparent.
render::Image asStored(const render::Image& picture, bool transparent)
{
    if (transparent) return picture;
    render::Image opaque(picture.width, picture.height, 3);
    for (std::size_t i = 0; i < opaque.pixels.size(); ++i) opaque.pixels[i] = picture.pixels[i / 3 * 4 + i % 3];
    return opaque;
}

class QuiltRun final : public JobRun {
public:
    explicit QuiltRun(JobOrder order) : order_(std::move(order))
    {
        if (!order_.out.empty()) order_.out = printing::quiltPath(order_.out, gridOf(order_.values));
    }

    [[nodiscard]] Next next() const override { return isDone_ ? Next::done : Next::draw; }
    void step(const Watch&) override
    {
        if (!maker_) begin();
        if (!maker_->step()) end();
    }
    [[nodiscard]] double progress() const override { return maker_ ? maker_->progress() : isDone_ ? 1 : 0; }
    [[nodiscard]] std::string_view doing() const override { return "drawing"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override { render::publishAll(staged_); }
    [[nodiscard]] render::Image previewPicture() const override { return quilt_; }

private:
    void begin()
    {
        backend_ = order_.backend ? order_.backend() : nullptr;
        if (!backend_) throw Failure(ErrorKind::openGl, "No quilt can be drawn: there is no graphics context.");
        const glm::ivec2 size = quiltSize(order_.values);
        const bool transparent = order_.scene.frame.transparent;
        quilt_ = render::Image(size.x, size.y, transparent ? 4 : 3);
        maker_.emplace(*order_.scene.museum, *backend_, shotsOf(order_), [this, transparent](int k, const auto& view) {
            printing::placeInQuilt(quilt_, asStored(view, transparent), gridOf(order_.values), k);
        });
    }
    void end()
    {
        maker_.reset();
        backend_.reset();
        report_.facts = factsOf(order_.values, order_.scene);
        isDone_ = true;
        if (order_.out.empty()) return;
        const JobScene& scene = order_.scene;
        const PictureRequest middle = middleRequest(order_.values, scene);
        const render::Camera* view = scene.frame.alone ? nullptr : &scene.state.camera;
        staged_.push_back(render::stagedPicture(
            order_.out, quilt_, *render::writtenFormat(order_.out),
            {.preset = pictureSettings(*scene.museum, scene.subject, scene.state, middle, "Quilt", view)}));
        staged_.push_back(
            render::stagedFile(documentFile(order_.out), documentText(QuiltJob(), order_, report_.facts)));
        report_.files = {order_.out, documentFile(order_.out)};
    }

    JobOrder order_;
    render::Image quilt_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::optional<printing::ViewMaker> maker_;  ///< Declared after the backend, which it uses.
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    bool isDone_ = false;
};

}  // namespace
}  // namespace quilts

const Parameters& QuiltJob::parameters() const
{
    return quiltTable();
}

JobNeeds QuiltJob::needs() const
{
    return {
        .anyScene = true, .extensions = render::writtenEndings(8), .inWindow = true, .preview = PreviewForm::picture};
}

std::shared_ptr<const JobInputs> QuiltJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan QuiltJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs&,
                       const std::filesystem::path& out) const
{
    JobPlan plan;
    plan.facts = quilts::factsOf(values, scene);
    const glm::ivec2 size = quilts::quiltSize(values);
    if (std::max(size.x, size.y) > quilts::longestSide)
        plan.refusal = "A quilt of " + std::to_string(size.x) + " × " + std::to_string(size.y) +
                       " pixels is larger than the 16384 × 16384 that displays take; give a smaller --size, or fewer "
                       "--columns and --rows.";
    if (out.empty()) return plan;
    if (plan.refusal.empty()) plan.refusal = refusedExtension(*this, out);
    const std::filesystem::path file = printing::quiltPath(out, quilts::gridOf(values));
    plan.files = {{file, "quilt"}, {documentFile(file), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> QuiltJob::start(JobOrder order) const
{
    return std::make_unique<quilts::QuiltRun>(std::move(order));
}

double QuiltJob::effort(const ParameterValues& values, const JobScene& scene) const
{
    const glm::dvec2 size = quilts::quiltSize(values);
    return size.x * size.y * quilts::samplesOf(values, scene);
}

JobForecast QuiltJob::forecast(const ParameterValues& values, const FinishedDraft& draft,
                               const std::filesystem::path& out) const
{
    const render::Image quilt = draft.run.previewPicture();
    const glm::dvec2 size = quilts::quiltSize(values);
    try {
        return {{fileAbout(grownBytes(pictureBytes(quilt, out), size.x * size.y / quilt.width / quilt.height, out))}};
    } catch (const Failure&) {
        return {};  // The plan or the export says why nothing can be written.
    }
}

ParameterValues QuiltJob::draft(const ParameterValues& values, const JobInputs&) const
{
    const QuiltTable& t = quiltTable();
    ParameterValues small = values;
    shrinkTo(quilts::draftSide, quilts::quiltSize(values), small, t.width, t.height);
    small.set(t.samples, 1);
    return small;
}

}  // namespace vitrine::jobs
