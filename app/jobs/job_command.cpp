#include "app/jobs/job_command.h"

#include "app/jobs/run_job.h"
#include "app/jobs/typed_parameters.h"
#include "app/picture_options.h"
#include "app/say.h"
#include "exhibits/exhibits.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/kit/given_values.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/failure.h"
#include "render/text/joined.h"

#include <CLI/CLI.hpp>

#include <map>
#include <optional>

namespace vitrine::app {
namespace {

/// Arguments of a job's command, as they were typed.
struct TypedJob {
    TypedParameters parameters;
    std::string out, like, preset;
    std::vector<std::string> sets;
    bool asJson = false, dryRun = false;
};

std::string extensionsText(const jobs::Job& job)
{
    return joined(job.needs().extensions, ", ", [](std::string_view each) { return '.' + std::string(each); });
}

void addCommon(CLI::App& command, const jobs::Job& job, TypedJob& typed)
{
    const std::string subject(job.needs().subject);
    if (!subject.empty()) {
        command.add_option("--preset", typed.preset, "Preset of " + subject + ": the name of a shipped one, or a file");
        command.add_option("--set", typed.sets, "Value of a parameter of " + subject + ", name=value")
            ->take_all()
            ->allow_extra_args(true);
    }
    command.add_option("--out", typed.out, "Output file (" + extensionsText(job) + "); further files take its name");
    command.add_option("--like", typed.like,
                       "Settings document (.vitrine-job.json), or an output beside which one lies: its settings, where "
                       "no option gives others");
    command.add_flag("--dry-run", typed.dryRun, "Print what would be written; write nothing");
    command.add_flag("--json", typed.asJson, "Print the outcome as JSON");
}

/// Returns the scene of the job: the initial one, or that of the document, with the typed preset and values.
jobs::JobScene sceneOf(const jobs::Job& job, const Museum& museum, const TypedJob& typed, const SceneState* like)
{
    PictureOptions options;
    options.subject = job.needs().subject;
    options.preset = typed.preset;
    options.settingsOnly = true;
    options.sets = typed.sets;
    const RequestedPicture picture =
        requestedPicture(museum, options, like ? *like : museum.initialSceneState(), std::nullopt);
    for (const std::string& note : picture.notes) say(note);
    jobs::JobScene scene{&museum, picture.sceneState, picture.subject, picture.request.frame};
    // Only settings were asked for: the camera stays where it was, whatever the best view of the exhibit is.
    scene.state.camera = like ? like->camera : museum.initialSceneState().camera;
    return scene;
}

int runTyped(const CLI::App& command, const jobs::Job& job, const TypedJob& typed)
{
    const std::string name = "vitrine " + std::string(job.name());
    std::unique_ptr<Museum> museum;
    std::optional<jobs::JobDocument> like;
    const bool hasScene = !job.needs().subject.empty();
    if (!typed.like.empty()) {
        if (hasScene) museum = std::make_unique<Museum>(allExhibits());
        like = jobs::readDocument(typed.like, job, museum.get());
        for (const std::string& note : like->notes) say(note);
    }
    jobs::GivenValues given = like ? jobs::GivenValues(like->values) : jobs::GivenValues(job.parameters());
    typed.parameters.read(command, given);
    jobs::JobOrder order{given.settled(name)};
    order.out = typed.out.empty() && like ? like->out : std::filesystem::path(typed.out);
    if (order.out.empty() && !typed.dryRun)
        throw Failure(Blame::usage, '`' + name + "` needs --out; `" + name + " --help` says what it is.");
    if (const std::string refusal = jobs::refusedExtension(job, order.out); !order.out.empty() && !refusal.empty())
        throw Failure(Blame::usage, refusal);
    order.inputs = job.read(order.values);
    if (hasScene) {
        if (!museum) museum = std::make_unique<Museum>(allExhibits());
        order.scene = sceneOf(job, *museum, typed, like ? &like->scene : nullptr);
    }
    order.backend = headlessBackend;
    const jobs::JobPlan plan = job.plan(order.values, order.scene, *order.inputs, order.out);
    if (!typed.dryRun) return runJob(job, std::move(order), plan, typed.asJson);
    if (!plan.refusal.empty() && !typed.asJson) throw Failure(Blame::usage, plan.refusal);
    printPlan(job, plan, typed.asJson);
    return plan.refusal.empty() ? 0 : static_cast<int>(Blame::usage);
}

}  // namespace

void addJobCommands(CLI::App& parser, Action& chosen)
{
    for (const auto& each : jobs::allJobs()) {
        const jobs::Job& job = *each;
        CLI::App* command = parser.add_subcommand(std::string(job.name()), std::string(job.summary()));
        auto typed = std::make_shared<TypedJob>();
        typed->parameters.addTo(*command, job.parameters());
        addCommon(*command, job, *typed);
        command->callback([&chosen, command, typed, &job] {
            chosen = [command, typed, &job] { return runTyped(*command, job, *typed); };
        });
    }
}

}  // namespace vitrine::app
