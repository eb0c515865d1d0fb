#include "app/jobs/run_job.h"

#include "app/progress.h"
#include "app/say.h"
#include "app/stop_signal.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/text/joined.h"

#include <cctype>
#include <cstdio>
#include <optional>

namespace vitrine::app {
namespace {

using render::Json;

class HeadlessBackend final : public render::RenderBackend {
public:
    render::FrameReport draw(const render::FramePlan& plan) override { return renderer_.draw(plan); }
    [[nodiscard]] render::Image read(const std::string& image) override { return renderer_.read(image); }
    [[nodiscard]] const render::PersistentState& persistentState() const override
    {
        return renderer_.persistentState();
    }
    [[nodiscard]] int largestSide() const override { return renderer_.largestSide(); }

private:
    render::gl::HeadlessContext context_;
    render::gl::Renderer renderer_;
};

/// "frames 12, volume 0.523 m³".
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

void printReport(const jobs::Job& job, const jobs::JobReport& report, bool asJson)
{
    for (const std::string& warning : report.warnings) say(warning);
    if (asJson) {
        Json files = Json::array();
        for (const auto& file : report.files) files.push_back(file.string());
        print({{"job", std::string(job.name())},
               {"files", files},
               {"facts", factsJson(report.facts)},
               {"warnings", report.warnings}});
        return;
    }
    std::printf("%s: %s\n", report.files.front().c_str(), factsText(report.facts).c_str());
}

/// Shows the progress of a run, a line for each kind of step.
class ProgressLines {
public:
    explicit ProgressLines(const jobs::JobRun& run) : run_(run) {}

    bool show(double part)
    {
        if (run_.doing() != doing_) {
            doing_ = run_.doing();
            line_.emplace(doing_);
        }
        return line_->show(part);
    }

private:
    const jobs::JobRun& run_;
    std::string doing_;
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

}  // namespace

std::unique_ptr<render::RenderBackend> headlessBackend()
{
    return std::make_unique<HeadlessBackend>();
}

int runJob(const jobs::Job& job, jobs::JobOrder order, const jobs::JobPlan& plan, bool asJson)
{
    if (!plan.refusal.empty()) throw Failure(Blame::usage, plan.refusal);
    for (const std::string& warning : plan.warnings) say(warning);
    for (const jobs::PlannedFile& file : plan.files) const render::PartFile writable(file.path);
    const StopSignal stop;
    try {
        const std::unique_ptr<jobs::JobRun> run = job.start(std::move(order));
        stepThrough(*run);
        printReport(job, run->report(), asJson);
        return 0;
    } catch (const jobs::Stopped&) {
        if (!plan.ifStopped.empty()) say(plan.ifStopped);
        return StopSignal::exitCode;
    }
}

void printPlan(const jobs::Job& job, const jobs::JobPlan& plan, bool asJson)
{
    if (asJson) {
        Json files = Json::array();
        for (const jobs::PlannedFile& file : plan.files)
            files.push_back({{"path", file.path.string()}, {"content", file.content}});
        Json json{{"job", std::string(job.name())},
                  {"files", files},
                  {"facts", factsJson(plan.facts)},
                  {"warnings", plan.warnings}};
        if (!plan.refusal.empty()) json["refusal"] = plan.refusal;
        print(json);
        return;
    }
    for (const std::string& warning : plan.warnings) say(warning);
    for (const jobs::PlannedFile& file : plan.files) std::printf("%s (%s)\n", file.path.c_str(), file.content.c_str());
    if (!plan.facts.empty()) std::printf("%s\n", factsText(plan.facts).c_str());
}

}  // namespace vitrine::app
