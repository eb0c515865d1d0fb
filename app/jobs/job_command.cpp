#include "app/jobs/job_command.h"

#include "app/jobs/job_arguments.h"
#include "app/jobs/run_job.h"
#include "app/jobs/standard_output.h"
#include "app/kit/say.h"
#include "app/queue/shard.h"
#include "exhibits/exhibits.h"
#include "exhibits/jobs.h"
#include "render/failure.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

struct TypedJob {
    JobArguments arguments;
    PartOptions part;
    bool asJson = false;
};

/// Makes the job and writes it to standard output, which then has nothing else.
int runToStandardOutput(const jobs::Job& job, OrderedJob ordered, const TypedJob& typed, const StandardOutput& to)
{
    if (typed.asJson)
        throw Failure(ErrorKind::usage, "--json: standard output already takes the file of --out " +
                                            typed.arguments.out + "; leave one of the two out.");
    const int code = runJob(job, std::move(ordered.order), ordered.plan, typed.part, Outcome::nothing);
    if (code == 0) to.send();
    return code;
}

int runTyped(const CLI::App& command, const jobs::Job& job, const TypedJob& typed)
{
    std::unique_ptr<Museum> museum;
    const JobStart start{[&museum]() -> const Museum& {
        if (!museum) museum = std::make_unique<Museum>(allExhibits());
        return *museum;
    }};
    JobArguments arguments = typed.arguments;
    std::unique_ptr<StandardOutput> standard;
    // A file that carries its settings stands alone; others have a document beside them.
    if (job.needs().carriesSettings && !arguments.dryRun)
        standard = StandardOutput::named(arguments.out, std::string(job.needs().extensions.front()));
    if (standard) arguments.out = standard->file();
    OrderedJob ordered = orderedJob(command, job, arguments, start);
    for (const std::string& note : ordered.notes) say(note);
    if (standard) return runToStandardOutput(job, std::move(ordered), typed, *standard);
    const jobs::JobPlan& plan = ordered.plan;
    if (!typed.arguments.dryRun)
        return runJob(job, std::move(ordered.order), plan, typed.part, typed.asJson ? Outcome::json : Outcome::text);
    if (!plan.refusal.empty() && !typed.asJson) throw Failure(ErrorKind::usage, plan.refusal);
    printPlan(job, plan, typed.asJson);
    return plan.refusal.empty() ? 0 : static_cast<int>(ErrorKind::usage);
}

/// Adds the command of a job. That of "shader export" belongs to the group "shader".
CLI::App* addCommand(CLI::App& parser, const jobs::Job& job)
{
    const std::string words(job.command());
    const std::size_t blank = words.find(' ');
    CLI::App* group = blank == std::string::npos ? &parser : parser.get_subcommand(words.substr(0, blank));
    return group->add_subcommand(blank == std::string::npos ? words : words.substr(blank + 1),
                                 std::string(job.summary()));
}

}  // namespace

void addJobCommands(CLI::App& parser, Action& chosen)
{
    for (const auto& each : jobs::allJobs()) {
        const jobs::Job& job = *each;
        CLI::App* command = addCommand(parser, job);
        auto typed = std::make_shared<TypedJob>();
        addJobArguments(*command, job, typed->arguments);
        command->add_flag("--json", typed->asJson, "Print the outcome as JSON");
        if (job.needs().inParts) addPartOptions(*command, typed->part);
        command->callback([&chosen, command, typed, &job] {
            chosen = [command, typed, &job] { return runTyped(*command, job, *typed); };
        });
    }
}

}  // namespace vitrine::app
