#include "app/jobs/run_job.h"

#include "app/jobs/job_folder.h"
#include "app/kit/progress.h"
#include "app/kit/report.h"
#include "app/kit/say.h"
#include "app/kit/stop_signal.h"
#include "render/failure.h"
#include "render/gl/context.h"
#include "render/gl/machine_json.h"
#include "render/gl/renderer.h"
#include "render/text/joined.h"

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace vitrine::app {
namespace {

using render::Json;

/// Backend that draws with a renderer that others may use, too.
class SharedBackend final : public render::RenderBackend {
public:
    explicit SharedBackend(std::shared_ptr<render::gl::Renderer> renderer) : renderer_(std::move(renderer)) {}

    render::FrameReport draw(const render::FramePlan& plan) override { return renderer_->draw(plan); }
    [[nodiscard]] render::Image read(const std::string& image) override { return renderer_->read(image); }
    [[nodiscard]] const render::PersistentState& persistentState() const override
    {
        return renderer_->persistentState();
    }
    [[nodiscard]] int largestSide() const override { return renderer_->largestSide(); }

private:
    std::shared_ptr<render::gl::Renderer> renderer_;
};

/// Renderer that draws without a window.
struct HeadlessRenderer {
    render::gl::HeadlessContext context;
    render::gl::Renderer renderer;
};

/// Formats facts: "frames 12, volume 0.523 m³".
std::string factsText(const std::vector<jobs::Fact>& facts)
{
    return joined(facts, ", ", [](const jobs::Fact& fact) {
        std::string label = fact.label;
        label.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(label.front())));
        return label + ' ' + valueText(fact);
    });
}

Json factsJson(const std::vector<jobs::Fact>& facts)
{
    Json all = Json::array();
    for (const jobs::Fact& fact : facts) {
        Json json{{"label", fact.label}};
        std::visit([&](const auto& value) { json["value"] = value; }, fact.value);
        if (!fact.unit.empty()) json["unit"] = fact.unit;
        all.push_back(std::move(json));
    }
    return all;
}

void print(const Json& json)
{
    std::fputs(render::writeJson(json).c_str(), stdout);
}

/// Shows the progress of a run, a line for each kind of step.
class ProgressLines {
public:
    explicit ProgressLines(const jobs::JobRun& run) : run_(run) {}

    bool show(double part)
    {
        if (!line_ || run_.next() != kind_) {
            kind_ = run_.next();
            line_.emplace(std::string(run_.doing()));
            line_->estimate();
        }
        line_->rename(run_.doing());
        return line_->show(part);
    }

private:
    const jobs::JobRun& run_;
    jobs::JobRun::Next kind_ = jobs::JobRun::Next::done;
    std::optional<ProgressLine> line_;
};

void stepThrough(jobs::JobRun& run)
{
    {
        ProgressLines lines(run);
        const jobs::Watch watch = [&](double part) { return lines.show(part); };
        while (run.next() != jobs::JobRun::Next::done) {
            if (!watch(run.progress())) throw jobs::Stopped();
            run.step(watch);
        }
    }
    if (StopSignal::stopped()) throw jobs::Stopped();
    run.publish();
}

/// Runs the job to its end and prints its warnings. Returns null if it was stopped.
std::unique_ptr<jobs::JobRun> finishedRun(const jobs::Job& job, jobs::JobOrder order, const jobs::JobPlan& plan)
{
    const StopSignal stop;
    try {
        std::unique_ptr<jobs::JobRun> run = job.start(std::move(order));
        stepThrough(*run);
        for (const std::string& warning : run->report().warnings) say(warning);
        return run;
    } catch (const jobs::Stopped&) {
        if (!plan.ifStopped.empty()) say(plan.ifStopped);
        return nullptr;
    }
}

/// Creates the backend of a job that draws without a window, and stores what draws in `info`. Throws Failure
/// (ErrorKind::openGl).
std::unique_ptr<render::RenderBackend> headlessBackend(const jobs::Job& job, render::gl::ContextInfo& info)
{
    const auto made = std::make_shared<HeadlessRenderer>();
    info = made->context.info();
    return backendOf(job, {made, &made->renderer});
}

/// Makes one part of a job whose parts must be merged.
int runPartOf(const jobs::Job& job, jobs::JobOrder order, const jobs::JobPlan& plan, const Shard& shard)
{
    return runPart(order.out, shard, [&](Parts& parts) -> std::optional<std::string> {
        render::gl::ContextInfo drawn;
        const JobFolder* folder = folderOf(job);
        const std::unique_ptr<study::StudyParts> measures = folder ? folder->measures(parts, true) : nullptr;
        order.share.measures = measures.get();
        order.share.keep = [&parts](const std::string& name, const render::Image& image) { parts.keep(name, image); };
        order.out = parts.file(job.partItems(order.out));
        order.backend = [&job, &drawn] { return headlessBackend(job, drawn); };
        const std::unique_ptr<jobs::JobRun> run = finishedRun(job, std::move(order), plan);
        if (!run) return std::nullopt;
        for (const auto& file : run->report().files) parts.wrote(file.filename().string());
        return drawn.renderer;
    });
}

}  // namespace

std::unique_ptr<render::RenderBackend> backendOf(const jobs::Job& job, std::shared_ptr<render::gl::Renderer> renderer)
{
    renderer->timeSteps(job.needs().timesPasses);
    return std::make_unique<SharedBackend>(std::move(renderer));
}

int runJob(const jobs::Job& job, jobs::JobOrder order, const jobs::JobPlan& plan, const PartOptions& part,
           Outcome printed)
{
    if (!plan.refusal.empty()) throw Failure(ErrorKind::usage, plan.refusal);
    for (const std::string& warning : plan.warnings) say(warning);
    const std::filesystem::path out = order.out;
    const std::string items = job.partItems(out);
    render::gl::ContextInfo drawn;
    order.backend = [&job, &drawn] { return headlessBackend(job, drawn); };
    order.machine = [&drawn] { return render::gl::machineJson(drawn); };
    std::shared_ptr<HeadlessRenderer> renderer;  // Measures the report after the picture is drawn.
    if (!order.reportFile.empty()) {
        order.backend = [&job, &drawn, &renderer] {
            renderer = std::make_shared<HeadlessRenderer>();
            drawn = renderer->context.info();
            return backendOf(job, {renderer, &renderer->renderer});
        };
        order.frameReport = [&drawn, &renderer](const jobs::JobScene& scene, const PictureRequest& request,
                                                const render::FrameReport& first) {
            return pictureReport(*scene.museum, renderer->renderer, drawn, {scene.subject, scene.state, request},
                                 first);
        };
    }
    const JobFolder* folder = folderOf(job);
    std::optional<Parts> made;
    std::unique_ptr<study::StudyParts> measures;
    if (part.fromParts) {
        made.emplace(out);
        order.share.from = made->file(items);
        if (folder) measures = folder->measures(*made, false);
        order.share.measures = measures.get();
        order.share.kept = [&made](const std::string& name) {
            if (std::optional<render::Image> image = made->kept(name)) return std::move(*image);
            throw Failure(ErrorKind::check, made->file(name).string() + " is missing; make all parts anew.");
        };
    }
    if (!part.shard.empty()) {
        const Shard shard = parseShard(part.shard);
        if (const std::string why = job.refusedInParts(order.values); !why.empty())
            throw Failure(ErrorKind::usage, "--shard " + part.shard + ": " + why);
        order.share.makes = [shard](int k) { return shard.makes(static_cast<std::size_t>(k)); };
        if (!items.empty()) return runPartOf(job, std::move(order), plan, shard);
    }
    if (folder && folder->write) order.writeFolder = [&](const jobs::JobRun& run) { folder->write(out, run); };
    jobs::requireWritable(job, order);
    const std::unique_ptr<jobs::JobRun> run = finishedRun(job, std::move(order), plan);
    if (!run) return StopSignal::exitCode;
    if (printed == Outcome::json)
        print(reportJson(job, run->report()));
    else if (!folder && printed == Outcome::text)
        std::printf("%s%s%s\n", out.c_str(), out.empty() ? "" : ": ", factsText(run->report().facts).c_str());
    return folder ? folder->tell(out, *run, printed == Outcome::json) : 0;
}

Json reportJson(const jobs::Job& job, const jobs::JobReport& report)
{
    Json files = Json::array();
    for (const auto& file : report.files) files.push_back(file.string());
    return {{"job", std::string(job.name())},
            {"files", files},
            {"facts", factsJson(report.facts)},
            {"warnings", report.warnings}};
}

Json planJson(const jobs::Job& job, const jobs::JobPlan& plan)
{
    Json files = Json::array();
    for (const jobs::PlannedFile& file : plan.files)
        files.push_back({{"path", file.path.string()}, {"content", file.content}});
    Json json{{"job", std::string(job.name())},
              {"files", files},
              {"facts", factsJson(plan.facts)},
              {"warnings", plan.warnings}};
    if (!plan.refusal.empty()) json["refusal"] = plan.refusal;
    return json;
}

void printPlan(const jobs::Job& job, const jobs::JobPlan& plan, bool asJson)
{
    if (asJson) {
        print(planJson(job, plan));
        return;
    }
    for (const std::string& warning : plan.warnings) say(warning);
    for (const jobs::PlannedFile& file : plan.files) std::printf("%s (%s)\n", file.path.c_str(), file.content.c_str());
    if (!plan.facts.empty()) std::printf("%s\n", factsText(plan.facts).c_str());
}

}  // namespace vitrine::app
