#include "exhibits/jobs/handout/handout_job.h"

#include "exhibits/jobs/handout/handout_page.h"
#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/kit/part_folder.h"
#include "exhibits/museum/lesson_scene.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <optional>

namespace vitrine::jobs {

const HandoutTable& handoutTable()
{
    static const HandoutTable table;
    return table;
}

namespace handouts {
namespace {

constexpr int draftSide = 480;  // Pixels.
constexpr std::uint64_t mostPictureBytes = 16U << 20U;
constexpr const char* markFile = "handout.html";

/// Returns the file of the lesson: as given, else that of the exhibit. It need not exist.
std::filesystem::path lessonFile(const ParameterValues& values, const JobScene& scene)
{
    const std::string& given = values[handoutTable().lesson];
    return given.empty() ? shippedLesson(scene.museum->subject(scene.subject).name()) : std::filesystem::path(given);
}

/// Returns the initial values of all subjects.
NamedValues tablesOf(const Museum& museum)
{
    NamedValues tables;
    for (const SceneObject* subject : museum.subjects())
        tables.emplace_back(std::string(subject->name()), subject->parameters().initial());
    return tables;
}

class HandoutRun final : public JobRun {
public:
    explicit HandoutRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override { return isDone_ ? Next::done : Next::draw; }
    void step(const Watch&) override
    {
        if (!backend_) begin();
        if (!maker_) beginStep();
        if (maker_->step() && !maker_->finished()) return;
        endStep();
    }
    [[nodiscard]] double progress() const override
    {
        if (isDone_) return 1;
        const double part = maker_ ? maker_->progress() : 0;
        return steps() > 0 ? (static_cast<double>(step_) + part) / static_cast<double>(steps()) : 0;
    }
    [[nodiscard]] std::string_view doing() const override { return "drawing the steps"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override
    {
        if (order_.out.empty()) return;
        const auto document =
            render::stagedFile(documentFile(order_.out), documentText(HandoutJob(), order_, report_.facts));
        folder_->publish();
        document->publish();
    }
    [[nodiscard]] render::Image previewPicture() const override { return picture_; }

private:
    /// Returns how many steps are drawn; a preview shows the first one.
    [[nodiscard]] std::size_t steps() const
    {
        return order_.out.empty() ? std::min<std::size_t>(lesson_.steps.size(), 1) : lesson_.steps.size();
    }

    void begin()
    {
        const Museum& museum = *order_.scene.museum;
        tables_ = tablesOf(museum);
        lesson_ = readLesson(lessonFile(order_.values, order_.scene), tables_);
        const Subjects subjects = museum.subjects();
        const auto is = [&](const SceneObject* subject) { return subject->name() == lesson_.exhibit; };
        exhibit_ = static_cast<std::size_t>(std::find_if(subjects.begin(), subjects.end(), is) - subjects.begin());
        report_.warnings = lesson_.notes;
        if (!order_.out.empty()) {
            requireFolderFor(order_.out, markFile, "a handout");
            folder_.emplace(order_.out);
        }
        backend_ = order_.backend ? order_.backend() : nullptr;
        if (!backend_) throw Failure(ErrorKind::openGl, "No step can be drawn: there is no graphics context.");
        state_ = order_.scene.state;
        state_.camera = museum.bestView(exhibit_, state_.values[exhibit_]);
    }

    /// Each step has its own settings and those of the scene; the camera stays where a step does not move it.
    void beginStep()
    {
        const LessonStep& lessonStep = lesson_.steps[step_];
        const Museum& museum = *order_.scene.museum;
        SceneState before = order_.scene.state;
        before.camera = state_.camera;
        state_ = sceneOfStep(museum, exhibit_, lessonStep, std::move(before));
        const HandoutTable& t = handoutTable();
        request_ = {};
        request_.frame = order_.scene.frame;
        request_.frame.raster.size = {order_.values[t.width], order_.values[t.height]};
        request_.frame.camera =
            widened(state_.camera, static_cast<double>(order_.values[t.width]) / order_.values[t.height]);
        request_.frame.needsFiles = true;
        request_.samples = order_.values[t.samples] > 0 ? order_.values[t.samples] : usualSamples(state_.hall());
        request_.largestTile = order_.largestTile;
        maker_ = std::make_unique<PictureMaker>(museum, *backend_, state_, request_);
    }

    void endStep()
    {
        if (order_.out.empty())
            picture_ = maker_->picture();
        else
            render::writePicture(folder_->path() / stepPicture(step_), maker_->picture(), render::PictureFormat::png8,
                                 {.preset = pictureSettings(*order_.scene.museum, exhibit_, state_, request_,
                                                            lesson_.steps[step_].title)});
        maker_.reset();
        if (++step_ < steps()) return;
        backend_.reset();
        isDone_ = true;
        report_.facts = {{"Steps", static_cast<double>(lesson_.steps.size())}};
        if (order_.out.empty()) return;
        render::atomicWrite(folder_->path() / markFile,
                            handoutPage(lesson_, tables_, order_.values[handoutTable().answers]));
        for (const std::string& file : lesson_.pictures)
            render::atomicWrite(folder_->path() / lessonPicture(file),
                                render::readFile(lesson_.folder / file, mostPictureBytes));
        render::atomicWrite(folder_->path() / "slides.html", slidesPage(lesson_, tables_));
        report_.files = {order_.out, documentFile(order_.out)};
    }

    JobOrder order_;
    NamedValues tables_;
    Lesson lesson_;
    std::size_t exhibit_ = 0;  ///< In `Museum::subjects`.
    std::size_t step_ = 0;
    SceneState state_;  ///< Scene of the step that is drawn.
    PictureRequest request_;
    std::optional<PartFolder> folder_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::unique_ptr<PictureMaker> maker_;  ///< Declared after the renderer that it uses.
    render::Image picture_;
    JobReport report_;
    bool isDone_ = false;
};

}  // namespace
}  // namespace handouts

const Parameters& HandoutJob::parameters() const
{
    return handoutTable();
}

std::shared_ptr<const JobInputs> HandoutJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan HandoutJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs&,
                         const std::filesystem::path& out) const
{
    const HandoutTable& t = handoutTable();
    JobPlan plan;
    plan.ifStopped = "Stopped; nothing was written.";
    plan.facts = {{"Picture size", std::to_string(values[t.width]) + " × " + std::to_string(values[t.height]), "px"}};
    std::error_code ignored;
    if (scene.museum && !std::filesystem::exists(handouts::lessonFile(values, scene), ignored))
        plan.refusal = values[t.lesson].empty()
                           ? "This has no lesson; choose an exhibit with one, or name the file of a lesson (--lesson)."
                           : "There is no lesson " + values[t.lesson] + "; choose a file.";
    if (!out.empty())
        plan.files = {{out, "page to print, slides, and a picture for each step"}, {documentFile(out), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> HandoutJob::start(JobOrder order) const
{
    return std::make_unique<handouts::HandoutRun>(std::move(order));
}

ParameterValues HandoutJob::draft(const ParameterValues& values, const JobInputs&) const
{
    const HandoutTable& t = handoutTable();
    ParameterValues small = values;
    shrinkTo(handouts::draftSide, {values[t.width], values[t.height]}, small, t.width, t.height);
    small.set(t.samples, 1);
    return small;
}

}  // namespace vitrine::jobs
