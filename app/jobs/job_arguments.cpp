#include "app/jobs/job_arguments.h"

#include "app/jobs/compared_scene.h"
#include "app/jobs/job_folder.h"
#include "app/kit/useless_option.h"
#include "exhibits/jobs/kit/given_values.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/kit/job_options.h"
#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/translation.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

/// Heading of the options of a scene that may be left out.
constexpr const char* sceneHeading = "Scene";

std::string extensionsText(const jobs::Job& job)
{
    return joined(job.needs().extensions, ", ", [](std::string_view each) { return '.' + std::string(each); });
}

std::string commandName(const jobs::Job& job)
{
    return "vitrine " + std::string(job.command());
}

[[noreturn]] void refuseMissing(const jobs::Job& job, const std::string& option)
{
    const std::string name = commandName(job);
    throw Failure(ErrorKind::usage, '`' + name + "` needs " + option + "; `" + name + " --help` says what it is.");
}

/// Returns the parameters that options set one by one, and all that a document has changed.
std::vector<jobs::PinnedParameter> pinnedParameters(const jobs::JobScene& scene, const std::vector<std::string>& sets,
                                                    bool like)
{
    std::vector<jobs::PinnedParameter> rows;
    for (const std::string& set : sets) {
        const NamedParameter named =
            namedParameter(*scene.museum, scene.state, scene.subject, set.substr(0, set.find('=')), "--set");
        rows.push_back({named.owner, named.row});
    }
    for (std::size_t subject = 0; like && subject < scene.state.values.size(); ++subject)
        for (std::size_t row = 0; row < scene.state.values[subject].rows().size(); ++row)
            if (!scene.state.values[subject].isInitial(row)) rows.push_back({subject, row});
    return rows;
}

/// Refuses options of the scene if there is none.
void refuseSceneOptions(const CLI::App& command)
{
    for (const CLI::Option* option : command.get_options())
        if (option->get_group() == sceneHeading) refuseWithout(command, option->get_name(), false, "--exhibit");
}

jobs::JobScene sceneOf(const CLI::App& command, const jobs::Job& job, const JobArguments& typed, const JobStart& start,
                       const jobs::JobDocument* like, std::vector<std::string>& notes)
{
    const Museum& museum = start.museum();
    const SceneState state = like ? like->scene : start.state ? *start.state : museum.initialSceneState();
    const jobs::JobNeeds needs = job.needs();
    PictureOptions options = typed.scene;
    if (!needs.choosesSubject()) options.subject = needs.subject;
    if (options.subject.empty() && like) options.subject = like->chosen;
    if (options.subject.empty()) refuseMissing(job, "exhibit");
    if (const auto& [exhibit, row] = needs.fileOf; !exhibit.empty() && !museum.find(options.subject)) {
        std::error_code error;
        if (std::filesystem::is_regular_file(options.subject, error)) {
            options.sets.insert(options.sets.begin(), std::string(row) + '=' + options.subject);
            options.subject = exhibit;
        }
    }
    RequestedPicture picture;
    if (needs.anyScene) {
        refuseUselessSceneOptions(command, options);
        std::optional<render::Camera> camera = start.camera ? start.camera(options.subject) : std::nullopt;
        const bool sameExhibit = like && options.subject == like->chosen;
        if (sameExhibit) camera = like->scene.camera;
        picture = requestedPicture(museum, options, state, camera, sameExhibit ? like->taken : std::nullopt);
    } else {
        options.settingsOnly = true;
        picture = requestedPicture(museum, options, state, std::nullopt);
        if (!needs.anySettings) picture.sceneState.camera = state.camera;
    }
    notes.insert(notes.end(), picture.notes.begin(), picture.notes.end());
    jobs::JobScene scene{&museum, picture.sceneState, picture.subject, picture.request.frame};
    scene.usual.samples = picture.request.samples;
    if (picture.taken) {
        scene.usual.size = picture.taken->size;
        scene.usual.channels = picture.taken->channels;
        scene.usual.depth = picture.taken->depth;
        scene.usual.position = picture.taken->position;
        scene.usual.objects = picture.taken->objects;
        scene.usual.before = picture.taken->before;
        // Plaques are in the language of the picture.
        if (picture.taken->language != language() && !ui::languageAsked())
            ui::setLanguage(QString::fromStdString(picture.taken->language));
    }
    if (needs.anySettings) scene.pinned = pinnedParameters(scene, options.sets, like != nullptr);
    return scene;
}

/// Returns the scene of a job that compares two settings.
jobs::JobScene comparedSceneOf(const CLI::App& command, const JobArguments& typed, const JobStart& start,
                               const jobs::JobDocument* like, std::vector<std::string>& notes)
{
    const CLI::Option* with = command.get_option_no_throw("--with");
    const bool keepsOffer = like && typed.compared[1].empty() && !like->other;
    return comparedScene(command, start.museum(), typed.scene, typed.compared,
                         {start.state, like, keepsOffer || (with && with->count() > 0)}, notes);
}

/// Returns the settings to start from; nullopt: the initial ones.
std::optional<jobs::JobDocument> startingDocument(const jobs::Job& job, const JobArguments& typed,
                                                  const JobStart& start, std::vector<std::string>& notes)
{
    if (typed.like.empty()) return std::nullopt;
    jobs::JobDocument like = jobs::readDocument(typed.like, job, job.needs().hasScene() ? &start.museum() : nullptr);
    notes.insert(notes.end(), like.notes.begin(), like.notes.end());
    return like;
}

}  // namespace

void addJobArguments(CLI::App& command, const jobs::Job& job, JobArguments& typed)
{
    const jobs::JobNeeds needs = job.needs();
    if (needs.anyScene) {
        command
            .add_option(needs.sceneByOption ? "--exhibit" : "exhibit", typed.scene.subject,
                        needs.sceneByOption ? "Name of the exhibit, or hall, that is rendered"
                                            : "Name of an exhibit, or hall")
            ->required(needs.carriesSettings && !needs.sceneByOption);
        addSceneOptions(command, typed.scene, needs.sceneByOption ? sceneHeading : "Options");
        // A parameter of the job is no option of the scene.
        for (const jobs::JobOption& option : jobs::optionsOf(job.parameters()))
            if (CLI::Option* ofScene = command.get_option_no_throw(option.name)) command.remove_option(ofScene);
        if (CLI::Option* samples = command.get_option_no_throw("--samples")) command.remove_option(samples);
    } else if (needs.twoSettings) {
        addComparedOptions(command, typed.scene, typed.compared);
    } else if (needs.hasScene()) {
        const std::string subject(needs.anySettings ? "the exhibit" : needs.subject);
        const bool takesFile = !needs.fileOf.first.empty();
        if (needs.anySettings)
            command.add_option("exhibit", typed.scene.subject,
                               takesFile
                                   ? "Name of an exhibit, or a file that " + std::string(needs.fileOf.first) + " shows"
                                   : "Name of an exhibit, or hall");
        command.add_option("--preset", typed.scene.preset,
                           "Preset of " + subject + ": the name of a shipped one, or a file");
        command.add_option("--set", typed.scene.sets, "Value of a parameter of " + subject + ", name=value")
            ->take_all()
            ->allow_extra_args(true);
    }
    typed.parameters.addTo(command, job.parameters());
    command.add_option(
        "--out", typed.out,
        needs.extensions.empty()
            ? "Output folder; an older output in it is replaced"
            : "Output file (" + extensionsText(job) + "); further files have the same name and other endings" +
                  (needs.carriesSettings ? ". - is standard output, as " + std::string(needs.extensions.front()) +
                                               "; -.exr names another kind"
                                         : std::string()));
    if (!needs.carriesSettings)
        command.add_option("--like", typed.like,
                           "File whose settings are the initial ones: a settings document (.vitrine-job.json), or an "
                           "output with one beside it");
    if (!needs.report.empty()) command.add_option("--report", typed.report, std::string(needs.report));
    command.add_flag("--dry-run", typed.dryRun, "Print what would be written; write nothing");
}

OrderedJob orderedJob(const CLI::App& command, const jobs::Job& job, const JobArguments& typed, const JobStart& start)
{
    std::vector<std::string> notes;
    const std::optional<jobs::JobDocument> like = startingDocument(job, typed, start, notes);
    jobs::GivenValues given = like ? jobs::GivenValues(like->values) : jobs::GivenValues(job.parameters());
    typed.parameters.read(command, given);
    OrderedJob ordered{{given.settled(commandName(job))}, {}, std::move(notes)};
    jobs::JobOrder& order = ordered.order;
    order.out = typed.out.empty() && like ? like->out : std::filesystem::path(typed.out);
    if (!order.out.has_filename()) order.out = order.out.parent_path();  // "folder/".
    order.values = job.completed({std::move(order.values), [&](std::size_t parameter) { return given.has(parameter); },
                                  typed.scene.subject, order.out});
    const bool needsOutput = !typed.dryRun && !start.answers && job.needsOutput(order.values);
    if (order.out.empty() && needsOutput) refuseMissing(job, "--out");
    if (const JobFolder* folder = folderOf(job); folder && !order.out.empty()) folder->require(order.out);
    if (const std::string refusal = jobs::refusedExtension(job, order.out); !order.out.empty() && !refusal.empty())
        throw Failure(ErrorKind::usage, refusal);
    order.inputs = job.read(order.values);
    if (job.needs().sceneByOption && typed.scene.subject.empty()) {
        refuseSceneOptions(command);
    } else if (job.needs().twoSettings) {
        order.scene = comparedSceneOf(command, typed, start, like ? &*like : nullptr, ordered.notes);
    } else if (job.needs().hasScene()) {
        order.scene = sceneOf(command, job, typed, start, like ? &*like : nullptr, ordered.notes);
        const bool still = job.needs().anyScene && !job.usesCamera(order.values, order.scene);
        for (const char* option : {"--eye", "--target", "--fov"})
            refuseOn(command, option, still, "a camera that follows a tour");
        for (const auto& [option, what] : job.idleOptions(order.values, order.scene))
            refuseOn(command, option, true, what);
    }
    order.scene = job.sceneFor(order.values, std::move(order.scene));
    order.reportFile = typed.report;
    ordered.plan = job.plan(order.values, order.scene, *order.inputs, order.out);
    return ordered;
}

}  // namespace vitrine::app
