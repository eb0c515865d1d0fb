#include "exhibits/jobs/study/study_job.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/study/study_table.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"

namespace vitrine::jobs {
namespace {

/// Returns the study. Throws Failure (ErrorKind::usage) as `studyRequest`.
study::StudyRequest orderedStudy(const ParameterValues& values, const JobScene& scene)
{
    study::StudyRequest request = study::studyRequest(values, *scene.museum, scene.state, scene.subject);
    request.needsFiles = scene.frame.needsFiles;
    for (const PinnedParameter& each : scene.pinned) request.pinned.push_back({each.subject, each.row});
    return request;
}

std::vector<Fact> factsOf(const study::StudyRequest& request)
{
    const bool isSearch = request.axes.size() > 2;
    double settings = 1;
    for (const study::StudyAxis& axis : request.axes) settings *= static_cast<double>(axis.values.size());
    if (isSearch) settings = std::min(settings, static_cast<double>(request.settings));
    return {{isSearch ? "Settings at most" : "Settings", settings},
            {"Views at most", static_cast<double>(request.views)},
            {"Picture size", std::to_string(request.size.x) + " × " + std::to_string(request.size.y), "px"}};
}

}  // namespace

void StudyRun::step(const Watch&)
{
    if (!study_) {
        study::StudyRequest request = orderedStudy(order_.values, order_.scene);
        request.largestTile = order_.largestTile;
        backend_ = order_.backend ? order_.backend() : nullptr;
        if (!backend_) throw Failure(ErrorKind::openGl, "Nothing can be measured: there is no graphics context.");
        study_ =
            std::make_unique<study::Study>(*order_.scene.museum, *backend_, std::move(request), order_.share.measures);
    }
    study_->step();
    if (study_->finished()) end();
}

std::string_view StudyRun::doing() const
{
    return study_ && !study_->doing().empty() ? std::string_view(study_->doing()) : "measuring";
}

bool StudyRun::isPart() const
{
    return order_.share.measures && order_.share.measures->isPart();
}

void StudyRun::end()
{
    if (isPart()) return;
    const study::StudyResult& result = study_->result();
    report_.facts = {{"Settings", static_cast<double>(result.points.size())},
                     {"Views", static_cast<double>(result.views.size())}};
    if (!order_.out.empty()) report_.files = {order_.out, documentFile(order_.out)};
}

void StudyRun::publish()
{
    if (isPart() || !order_.writeFolder) return;
    const auto document = render::stagedFile(documentFile(order_.out), documentText(StudyJob(), order_, report_.facts));
    order_.writeFolder(*this);
    document->publish();
}

render::Json StudyRun::answer() const
{
    return study::studyJson(subjects(), study_->request(), study_->result(),
                            order_.machine ? order_.machine() : render::Json());
}

study::CostAxis StudyRun::costs() const
{
    return study::chartCosts(order_.values, study_->result());
}

std::string StudyRun::chosenPreset() const
{
    const study::StudyResult& result = study_->result();
    if (!result.choice || !result.choice->holds) return {};
    const SceneState sceneState = study_->sceneStateOf(result.points[result.choice->point]);
    const std::size_t subject = study_->request().subject;
    const std::string name = "Chosen by a study";
    for (const study::StudyAxis& axis : study_->request().axes)
        if (axis.subject != subject)
            return exhibitionText({name, namedValues(subjects(), sceneState.values), sceneState.camera});
    return presetText(Preset{std::string(subjects()[subject]->name()), name, sceneState.values[subject], std::nullopt});
}

const Parameters& StudyJob::parameters() const
{
    return study::studyTable();
}

std::shared_ptr<const JobInputs> StudyJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan StudyJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs&,
                       const std::filesystem::path& out) const
{
    JobPlan plan;
    plan.ifStopped = "Stopped; nothing was written.";
    if (scene.museum) {
        try {
            plan.facts = factsOf(orderedStudy(values, scene));
        } catch (const Failure& why) {
            plan.refusal = why.what();
        }
    }
    if (!out.empty()) plan.files = {{out, "page, charts, pictures and numbers"}, {documentFile(out), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> StudyJob::start(JobOrder order) const
{
    return std::make_unique<StudyRun>(std::move(order));
}

std::vector<std::pair<const char*, const char*>> StudyJob::idleOptions(const ParameterValues& values,
                                                                       const JobScene& scene) const
{
    const study::StudyTable& t = study::studyTable();
    const std::size_t varied = linesOf(values[t.varied]).size();
    std::vector<std::pair<const char*, const char*>> idle;
    if (!values[t.values].empty()) idle.emplace_back("--points", "a study of --values");
    if (varied == 1 || varied == 2) idle.emplace_back("--settings", "a study of one or two parameters");
    if (scene.subject == hallIndex) idle.emplace_back("--alone", "the hall as a whole");
    return idle;
}

}  // namespace vitrine::jobs
