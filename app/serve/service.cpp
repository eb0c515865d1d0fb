#include "app/serve/service.h"

#include "app/compare/compared_files.h"
#include "app/jobs/job_arguments.h"
#include "app/jobs/run_job.h"
#include "app/kit/apply_preset.h"
#include "app/kit/number_option.h"
#include "app/kit/passes_json.h"
#include "app/kit/picture_options.h"
#include "app/kit/report.h"
#include "app/kit/table_json.h"
#include "app/serve/base64.h"
#include "app/serve/json_rpc.h"
#include "app/serve/params.h"
#include "app/serve/raw_picture.h"
#include "app/serve/values_json.h"
#include "exhibits/framework/files/preset_store.h"
#include "exhibits/framework/table/preset_values.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/picture/picture_job.h"
#include "exhibits/jobs/picture/picture_table.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"
#include "render/measure/distance.h"
#include "render/plan/diagnostics.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"
#include "render/version.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace vitrine::app {

using render::Json;

namespace {

// Names by which the kind of light of an answer is selected; no file is written.
constexpr const char* answerOfLight = "answer.exr";
constexpr const char* answerOnDisplay = "answer.png";

Json textsJson(const std::vector<std::string>& texts)
{
    Json json = Json::array();
    for (const std::string& text : texts) json.push_back(withoutDashes(text));
    return json;
}

}  // namespace

render::gl::Renderer& ServedGraphics::renderer()
{
    if (!context_) context_ = std::make_unique<render::gl::HeadlessContext>();
    if (!renderer_) renderer_ = std::make_unique<render::gl::Renderer>();
    return *renderer_;
}

const render::gl::ContextInfo& ServedGraphics::info()
{
    (void)renderer();
    return context_->info();
}

Service::Service(const Museum& museum, ServedState& state, ServedGraphics& graphics)
    : museum_(museum), state_(state), graphics_(graphics), sceneState_(state.current())
{
}

void Service::refresh()
{
    state_.takeChanged();
    noteState(state_.current());
}

const std::vector<Service::Entry>& Service::methods()
{
    static const std::vector<Entry> all{
        {"rpc.discover", &Service::discover, "every method with a JSON Schema of its params"},
        {"list", &Service::listExhibits,
         "every exhibit and its rows, as in `exhibits` of `vitrine list --json`; {exhibit}: that one"},
        {"get", &Service::getValues, "{exhibit, names}: values and motions of its rows, or of the named ones"},
        {"set", &Service::setValues, "{exhibit, values: {row: value}, animate: {row: motion}}: what the rows are then"},
        {"reset", &Service::resetValues, "{exhibit}: its rows are initial again; without it, all are"},
        {"visit", &Service::visitExhibit, "{exhibit}: the visitor goes to its best view; the answer has that camera"},
        {"presets", &Service::listPresets, "{exhibit}: its presets"},
        {"load", &Service::loadPreset, "{exhibit, preset}: a shipped preset by its name, or a file"},
        {"plan", &Service::planPicture,
         "{exhibit, size, ...} as of `vitrine render`: what would run, what not and why"},
        {"render", &Service::renderPicture,
         "{exhibit, size, out, ...} as of `vitrine render`; without out, the answer has the PNG in base64; with raw, "
         "its values follow as bytes; with frame_report, what ran"},
        {"compare", &Service::comparePictures,
         "{reference, test, pixels_per_degree}: distance of two picture files by every metric"},
        {"events", nullptr, "notifications of progress and of changes by other connections; {off: true}: no more"},
        {"cancel", nullptr, "{id}: stops that request of this connection at its next step; without it, all of them"}};
    return all;
}

bool Service::hasMethod(std::string_view name)
{
    const std::vector<Entry>& all = methods();
    return std::any_of(all.begin(), all.end(), [&](const Entry& entry) { return entry.name == name; });
}

std::string Service::methodsText()
{
    std::string text;
    const auto add = [&](std::string name, const std::string& help) {
        name.resize(14, ' ');
        text += "  " + name + help + "\n";
    };
    for (const Entry& entry : methods()) add(entry.name, entry.help);
    for (const auto& job : jobs::allJobs()) {
        if (hasMethod(job->name())) continue;
        const std::string name(job->name());
        const bool answers = job->needs().answers;
        add(name, (answers ? "{...} as of `vitrine " : "{out, ...} as of `vitrine ") + std::string(job->command()) +
                      "`: " + (answers ? "what it measured" : "its files and facts") +
                      "; with dry_run, what it would write");
    }
    return text;
}

Json Service::answer(const std::string& method, const Json& params, const Watch& watch)
{
    bytes_.clear();
    std::vector<std::string> names;
    for (const Entry& entry : methods()) {
        if (entry.method && method == entry.name) return (this->*entry.method)(params, watch);
        names.emplace_back(entry.name);
    }
    for (const auto& job : jobs::allJobs()) {
        if (hasMethod(job->name())) continue;
        if (method == job->name()) return runJob(*job, params, watch);
        names.emplace_back(job->name());
    }
    throw RpcFailure(RpcCode::method, "There is no method \"" + method + '"' + didYouMean(method, names) +
                                          " there are " + joined(names) + '.');
}

Json Service::discover(const Json& params, const Watch& watch)
{
    CLI::App none;
    readParams(none, "rpc.discover", params);
    Json all = Json::array();
    const auto add = [&](std::string_view name, const std::string& summary, Json schema) {
        all.push_back({{"name", std::string(name)}, {"summary", summary}, {"params", std::move(schema)}});
    };
    const auto schemaOf = [](const auto& call) -> Json {
        try {
            (void)call();
        } catch (const ParamsSchema& schema) {
            return schema.json;
        }
        return objectSchema();  // The params of `events` and `cancel` are read by the server.
    };
    for (const Entry& entry : methods())
        add(entry.name, entry.help,
            schemaOf([&] { return entry.method ? (this->*entry.method)(nullptr, watch) : Json(); }));
    for (const auto& job : jobs::allJobs())
        if (!hasMethod(job->name()))
            add(job->name(), std::string(job->summary()), schemaOf([&] { return runJob(*job, nullptr, watch); }));
    return {{"app", render::programVersion()}, {"methods", all}};
}

std::size_t Service::subjectNamed(const std::string& name) const
{
    if (const auto subject = museum_.find(name)) return *subject;
    std::vector<std::string> names;
    for (const SceneObject* subject : museum_.subjects()) names.emplace_back(subject->name());
    throw Failure(ErrorKind::usage,
                  "There is no exhibit \"" + name + '"' + didYouMean(name, names) + " the method list names them.");
}

std::optional<render::Camera> Service::cameraOf(const std::string& name) const
{
    const auto subject = museum_.find(name);
    const auto camera = subject ? cameras_.find(*subject) : cameras_.end();
    return camera == cameras_.end() ? std::nullopt : std::optional(camera->second);
}

void Service::become(SceneState next)
{
    state_.change(sceneState_, next);
    noteState(std::move(next));
}

void Service::noteState(SceneState next)
{
    for (std::size_t i = 0; i < next.values.size(); ++i) {
        Json change = changeJson(museum_.subject(i).name(), sceneState_.values[i], next.values[i]);
        if (!change.is_null()) changes_.push_back(std::move(change));
    }
    sceneState_ = std::move(next);
}

Json Service::listExhibits(const Json& params, const Watch&)
{
    std::string exhibit;
    CLI::App options;
    options.add_option("exhibit", exhibit);
    readParams(options, "list", params);
    Json all = exhibitsJson(museum_, sceneState_);
    return exhibit.empty() ? all : Json::array({all[subjectNamed(exhibit)]});
}

Json Service::getValues(const Json& params, const Watch&)
{
    std::string exhibit;
    std::vector<std::string> names;
    CLI::App options;
    options.add_option("exhibit", exhibit)->required();
    options.add_option("--names", names)->take_all();
    readParams(options, "get", params);
    const std::size_t subject = subjectNamed(exhibit);
    const ParameterValues& values = sceneState_.values[subject];
    if (names.empty())
        return Json{{"exhibit", exhibit}, {"values", valuesJson(values)}, {"motions", motionsJson(values)}};
    Json answer{{"exhibit", exhibit}, {"values", Json::object()}, {"motions", Json::object()}};
    for (const std::string& name : names) {
        const NamedParameter at = namedParameter(museum_, sceneState_, subject, name, "names");
        const ParameterValues& owner = sceneState_.values[at.owner];
        answer["values"][name] = jsonFromValue(owner.rows()[at.row], owner.row(at.row));
        const Json motions = motionsJson(owner);
        const std::string row(owner.rows()[at.row].name);
        if (motions.contains(row)) answer["motions"][name] = motions[row];
    }
    return answer;
}

Json Service::setValues(const Json& params, const Watch&)
{
    std::string exhibit;
    std::vector<std::string> values, motions;
    CLI::App options;
    options.add_option("exhibit", exhibit)->required();
    options.add_option("--values", values)->take_all();
    options.add_option("--animate", motions)->take_all();
    readParams(options, "set", params);
    const std::size_t subject = subjectNamed(exhibit);
    SceneState next = sceneState_;
    std::vector<std::string> notes;
    applySets(museum_, next, subject, values, notes);
    for (const std::string& motion : motions) applyMotion(museum_, next, subject, motion);
    Json now = Json::object();
    for (const std::string& assignment : values) {
        const std::string name = assignment.substr(0, assignment.find('='));
        const NamedParameter at = namedParameter(museum_, next, subject, name, "values");
        now[name] = jsonFromValue(next.values[at.owner].rows()[at.row], next.values[at.owner].row(at.row));
    }
    become(std::move(next));
    return Json{{"values", now}, {"notes", textsJson(notes)}};
}

Json Service::resetValues(const Json& params, const Watch&)
{
    std::string exhibit;
    CLI::App options;
    options.add_option("exhibit", exhibit);
    readParams(options, "reset", params);
    const SceneState initial = museum_.readTables(museum_.initialSceneState()).sceneState;
    SceneState next = sceneState_;
    const std::size_t only = exhibit.empty() ? 0 : subjectNamed(exhibit);
    for (std::size_t i = 0; i < next.values.size(); ++i) {
        if (!exhibit.empty() && i != only) continue;
        next.values[i] = initial.values[i];
        cameras_.erase(i);
    }
    become(std::move(next));
    return Json::object();
}

Json Service::visitExhibit(const Json& params, const Watch&)
{
    std::string exhibit;
    CLI::App options;
    options.add_option("exhibit", exhibit)->required();
    readParams(options, "visit", params);
    const std::size_t subject = subjectNamed(exhibit);
    const render::Camera camera = museum_.bestView(subject, sceneState_.values[subject]);
    cameras_.erase(subject);
    state_.visit(subject, camera);
    sceneState_.camera = camera;
    return Json{{"exhibit", exhibit}, {"camera", jsonFromCamera(camera, Json::object())}};
}

Json Service::listPresets(const Json& params, const Watch&)
{
    std::string exhibit;
    CLI::App options;
    options.add_option("exhibit", exhibit)->required();
    readParams(options, "presets", params);
    const std::string subject(museum_.subject(subjectNamed(exhibit)).name());
    Json all = Json::array();
    for (const PresetEntry& preset : PresetStore::standard(render::asset("presets")).list(subject))
        all.push_back(Json{{"preset", preset.shipped ? preset.path.stem().string() : preset.path.string()},
                           {"name", preset.name},
                           {"shipped", preset.shipped},
                           {"problem", preset.problem.empty() ? Json(nullptr) : Json(preset.problem)}});
    return all;
}

Json Service::loadPreset(const Json& params, const Watch&)
{
    std::string exhibit, preset;
    CLI::App options;
    options.add_option("exhibit", exhibit)->required();
    options.add_option("--preset", preset)->required();
    readParams(options, "load", params);
    RequestedPicture job;
    job.subject = subjectNamed(exhibit);
    job.sceneState = sceneState_;
    applyPreset(museum_, preset, job);
    applySets(museum_, job.sceneState, job.subject, {}, job.notes);  // Reads files of the preset that add parameters.
    cameras_.erase(job.subject);
    if (job.cameraFromPreset) cameras_[job.subject] = job.sceneState.camera;
    job.sceneState.camera = sceneState_.camera;
    become(std::move(job.sceneState));
    const ParameterValues& values = sceneState_.values[job.subject];
    return Json{{"exhibit", exhibit},
                {"values", valuesJson(values)},
                {"motions", motionsJson(values)},
                {"notes", textsJson(job.notes)}};
}

using render::Json;

namespace {

/// Largest size of a picture in an answer, in bytes.
constexpr std::size_t mostAnswerBytes = 48U << 20U;

Json sizeJson(const PictureRequest& request)
{
    return Json::array({request.frame.raster.size.x, request.frame.raster.size.y});
}

const jobs::Job& pictureJob()
{
    return *jobs::findJob("render");
}

/// Adds the arguments of `vitrine render`, but not those that only a command has.
void addPictureArguments(CLI::App& options, JobArguments& arguments)
{
    addJobArguments(options, pictureJob(), arguments);
    for (const char* ofCommand : {"--report", "--dry-run"}) options.remove_option(options.get_option(ofCommand));
}

/// Returns the notes on corrected values, and the complaints of the drawn pictures.
Json notesJson(const std::vector<std::string>& notes, const std::vector<render::CulledPass>& skipped)
{
    Json json = Json::array();
    for (const std::string& note : notes) json.push_back(withoutDashes(note));
    for (const render::CulledPass& complaint : render::Diagnostics().begun(skipped)) json.push_back(lineOf(complaint));
    return json;
}

std::string pictureInBase64(const PictureRequest& request, const PictureMaker& maker, render::PictureFormat format,
                            const render::PictureMetadata& metadata)
{
    const std::string bytes = render::encodedPicture("The picture", maker.picture(), format, metadata);
    if (bytes.size() > mostAnswerBytes)
        throw Failure(ErrorKind::usage, "render: a picture of " + sizeJson(request).dump() + " pixels has " +
                                            std::to_string(bytes.size()) + " bytes, and an answer takes " +
                                            std::to_string(mostAnswerBytes) + "; let out name a file.");
    return base64(bytes);
}

}  // namespace

JobStart Service::start(bool answers) const
{
    return {[this]() -> const Museum& { return museum_; }, &sceneState_,
            [this](const std::string& exhibit) { return cameraOf(exhibit); }, answers};
}

Json Service::planPicture(const Json& params, const Watch&)
{
    JobArguments arguments;
    CLI::App options;
    addPictureArguments(options, arguments);
    options.remove_option(options.get_option("--out"));
    readParams(options, "plan", params);
    const OrderedJob ordered = orderedJob(options, pictureJob(), arguments, start(true));
    if (!ordered.plan.refusal.empty()) throw Failure(ErrorKind::usage, ordered.plan.refusal);
    const jobs::JobScene& scene = ordered.order.scene;
    const PictureRequest request = jobs::pictureRequest(ordered.order.values, scene, {});
    PictureMaker maker(museum_, graphics_.renderer(), scene.state, request);
    const render::FramePlan plan = maker.firstPlan();
    return Json{{"exhibit", std::string(museum_.subject(scene.subject).name())},
                {"size", sizeJson(request)},
                {"runs", plannedJson(plan.passes())},
                {"skipped", skippedJson(plan.skipped())},
                {"notes", notesJson(ordered.notes, plan.skipped())}};
}

Json Service::renderPicture(const Json& params, const Watch& watch)
{
    JobArguments arguments;
    std::string raw;
    bool withReport = false;
    CLI::App options;
    addPictureArguments(options, arguments);
    options.add_flag("--frame-report", withReport, "The report of `vitrine render --report` in the answer");
    addRawOption(options, raw);
    readParams(options, "render", params);
    const bool inAnswer = arguments.out.empty();
    if (inAnswer) arguments.out = raw == rawLinear ? answerOfLight : answerOnDisplay;
    const OrderedJob ordered = orderedJob(options, pictureJob(), arguments, start(true));
    const jobs::JobOrder& order = ordered.order;
    requireRawChannels(raw, order.values[jobs::pictureTable().channels]);
    if (!ordered.plan.refusal.empty()) throw Failure(ErrorKind::usage, ordered.plan.refusal);
    const RequestedPicture job{order.scene.subject, order.scene.state,
                               jobs::pictureRequest(order.values, order.scene, order.out)};
    PictureMaker maker(museum_, graphics_.renderer(), job.sceneState, job.request);
    do watch(maker.progress(), "drawing");
    while (maker.step());
    Json answer{{"exhibit", std::string(museum_.subject(job.subject).name())}, {"size", sizeJson(job.request)}};
    if (!raw.empty()) {
        answer["binary"] = rawJson(maker.picture());
        bytes_ = rawBytes(maker.picture(), raw);
    } else if (inAnswer) {
        answer["png"] = pictureInBase64(job.request, maker, jobs::pictureFormat(order.values, order.out),
                                        jobs::pictureMetadata(order.scene, job.request));
    } else {
        jobs::stagedPicture(order.scene, job.request, order.values, order.out, maker.picture())->publish();
        answer["out"] = std::filesystem::absolute(order.out).string();
    }
    if (withReport) {
        const auto between = [&] { watch(maker.progress(), "measuring"); };
        answer["frame_report"] =
            pictureReport(museum_, graphics_.renderer(), graphics_.info(), job, maker.report(), between);
    }
    answer["notes"] = notesJson(ordered.notes, maker.report().skipped);
    return answer;
}

Json Service::comparePictures(const Json& params, const Watch&)
{
    std::string reference, test;
    double pixelsPerDegree = render::flipPixelsPerDegree;
    CLI::App options;
    options.add_option("reference", reference, "Reference picture")->required();
    options.add_option("test", test, "Picture to compare with the reference; of the same size")->required();
    addPixelsPerDegree(options, pixelsPerDegree);
    readParams(options, "compare", params);
    std::vector<std::string> warnings;
    const ComparedFiles files = comparedFiles(reference, test, warnings);
    Json distances = Json::object();
    for (const auto& [metric, value] : render::distances({files.reference, files.test, pixelsPerDegree}))
        distances[std::string(toString(metric))] = std::isfinite(value) ? Json(value) : Json(nullptr);
    return Json{{"distances", distances}, {"notes", textsJson(warnings)}};
}

Json Service::runJob(const jobs::Job& job, const Json& params, const Watch& watch)
{
    JobArguments arguments;
    CLI::App options;
    const bool answers = job.needs().answers;
    addJobArguments(options, job, arguments);
    if (answers) options.remove_option(options.get_option("--out"));
    readParams(options, std::string(job.name()), params);
    OrderedJob ordered = orderedJob(options, job, arguments, start(answers));
    Json answer;
    if (arguments.dryRun) {
        answer = planJson(job, ordered.plan);
    } else {
        if (!ordered.plan.refusal.empty()) throw Failure(ErrorKind::usage, ordered.plan.refusal);
        ordered.order.backend = [this, &job] {
            // Times of passes are for this job alone.
            if (job.needs().timesPasses) return backendOf(job, graphics_.renderer().sibling());
            return backendOf(job, {std::shared_ptr<void>(), &graphics_.renderer()});
        };
        ordered.order.machine = [this] { return machineJson(graphics_.info()); };
        jobs::requireWritable(job, ordered.order);
        const std::unique_ptr<jobs::JobRun> run = job.start(std::move(ordered.order));
        const auto show = [&] { watch(run->progress(), std::string(run->doing())); };
        for (show(); run->next() != jobs::JobRun::Next::done; show())
            run->step([&](double part) {
                watch(part, std::string(run->doing()));
                return true;
            });
        run->publish();
        answer = answers ? run->answer() : reportJson(job, run->report());
    }
    for (const std::string& warning : ordered.plan.warnings) ordered.notes.push_back(warning);
    answer["notes"] = notesJson(ordered.notes, {});
    return answer;
}

}  // namespace vitrine::app
