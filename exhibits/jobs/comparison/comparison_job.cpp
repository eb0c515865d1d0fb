#include "exhibits/jobs/comparison/comparison_job.h"

#include "exhibits/compare/offered_comparison.h"
#include "exhibits/jobs/comparison/comparison_folder.h"
#include "exhibits/jobs/comparison/comparison_table.h"
#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"

namespace vitrine::jobs {

const std::vector<std::string>& comparisonGainTexts()
{
    static const std::vector<std::string> texts = [] {
        std::vector<std::string> all;
        for (const int gain : comparisonGains) all.push_back(std::to_string(gain));
        return all;
    }();
    return texts;
}

const ComparisonTable& comparisonTable()
{
    static const ComparisonTable table;
    return table;
}

namespace comparisons {
namespace {

constexpr int draftSide = 320;  // Pixels of each picture in the preview.

/// Returns the pictures of A and B beside each other, with a line between them.
render::Image besideEachOther(const render::Image& a, const render::Image& b)
{
    constexpr int gap = 2;  // Pixels.
    render::Image both(a.width + gap + b.width, a.height, 4);
    for (int y = 0; y < a.height; ++y)
        for (int c = 0; c < 4; ++c) {
            const auto from = [&](const render::Image& one, int x) {
                return c < one.channels ? one.at(x, y, c) : 1.0F;
            };
            for (int x = 0; x < a.width; ++x) both.at(x, y, c) = from(a, x);
            for (int x = 0; x < b.width; ++x) both.at(a.width + gap + x, y, c) = from(b, x);
        }
    return both;
}

/// Returns the other settings. Throws Failure (ErrorKind::usage) if there are none, or two.
OtherSettings otherOf(const ParameterValues& values, const JobScene& scene)
{
    const std::string& with = values[comparisonTable().with];
    if (with.empty() && !scene.other)
        throw Failure(ErrorKind::usage,
                      "There are no settings B to compare with. Choose B in the menu Compare of the window, name a "
                      "second setting on the command line, or choose another technique (--with).");
    if (with.empty()) return *scene.other;
    if (scene.other)
        throw Failure(ErrorKind::usage, "Choose either settings B or another technique (--with), not both.");
    if (scene.subject == hallIndex)
        throw Failure(ErrorKind::usage,
                      "--with: these settings change no exhibit; say with --exhibit which one is compared.");
    const OfferedComparison offered = compare::offeredComparison(scene.museum->subject(scene.subject), with);
    return {compare::otherSide(scene.state, scene.subject, offered), offered.title};
}

compare::ComparisonRequest requestOf(const ParameterValues& values, const JobScene& scene)
{
    const ComparisonTable& t = comparisonTable();
    compare::ComparisonRequest request;
    request.frame = scene.frame;
    request.frame.raster.size = {values[t.width], values[t.height]};
    request.frame.needsFiles = true;  // A picture without a named object would be wrong.
    request.runs = values[t.runs];
    request.pixelsPerDegree = values[t.pixelsPerDegree];
    request.settings = {scene.state, otherOf(values, scene).state};
    for (std::size_t side = 0; side < 2; ++side) {
        request.settings[side].camera = request.frame.camera;
        const int samples = values[t.samples];
        request.samples[side] = samples > 0 ? samples : usualSamples(request.settings[side].hall());
    }
    return request;
}

}  // namespace
}  // namespace comparisons

void ComparisonRun::step(const Watch&)
{
    if (!comparison_) {
        if (!order_.out.empty()) requireComparisonFolder(order_.out);  // Before anything is drawn.
        compare::ComparisonRequest request = comparisons::requestOf(order_.values, order_.scene);
        request.largestTile = order_.largestTile;
        names_ = {order_.scene.name, comparisons::otherOf(order_.values, order_.scene).name};
        backend_ = order_.backend ? order_.backend() : nullptr;
        if (!backend_) throw Failure(ErrorKind::openGl, "Nothing can be compared: there is no graphics context.");
        comparison_.emplace(*order_.scene.museum, *backend_, std::move(request));
    }
    if (!comparison_->step()) end();
}

void ComparisonRun::end()
{
    const compare::ComparisonResult& result = comparison_->result();
    report_.facts = {{"Parameters that differ", static_cast<double>(result.rows.size())},
                     {"Frame of A", result.sides[0].report.milliseconds, "ms"},
                     {"Frame of B", result.sides[1].report.milliseconds, "ms"}};
    if (!order_.out.empty()) report_.files = {order_.out, documentFile(order_.out)};
}

ComparisonText ComparisonRun::text() const
{
    ComparisonText text{
        names_, {}, comparisonGains.at(static_cast<std::size_t>(order_.values[comparisonTable().gain]))};
    const compare::ComparisonRequest& request = comparison_->request();
    for (std::size_t side = 0; side < 2; ++side)
        text.presets[side] = pictureSettings(*order_.scene.museum, order_.scene.subject, request.settings[side],
                                             {.frame = request.frame, .samples = request.samples[side]}, names_[side]);
    if (order_.machine) text.machine = order_.machine();
    return text;
}

void ComparisonRun::publish()
{
    if (order_.out.empty()) return;
    const auto document =
        render::stagedFile(documentFile(order_.out), documentText(ComparisonJob(), order_, report_.facts));
    writeComparisonFolder(order_.out, subjects(), *comparison_, text());
    document->publish();
}

render::Image ComparisonRun::previewPicture() const
{
    if (!comparison_ || !comparison_->finished()) return {};
    const compare::ComparisonResult& result = comparison_->result();
    return comparisons::besideEachOther(result.sides[0].picture, result.sides[1].picture);
}

render::Json ComparisonRun::answer() const
{
    return comparisonJson(subjects(), *comparison_, text());
}

const Parameters& ComparisonJob::parameters() const
{
    return comparisonTable();
}

std::shared_ptr<const JobInputs> ComparisonJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan ComparisonJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs&,
                            const std::filesystem::path& out) const
{
    const ComparisonTable& t = comparisonTable();
    JobPlan plan;
    plan.ifStopped = "Stopped; nothing was written.";
    plan.facts = {{"Picture size", std::to_string(values[t.width]) + " × " + std::to_string(values[t.height]), "px"}};
    if (scene.museum) {
        try {
            const compare::ComparisonRequest request = comparisons::requestOf(values, scene);
            const auto rows = compare::differingParameters(request.settings[0], request.settings[1]);
            plan.facts.push_back({"Parameters that differ", static_cast<double>(rows.size())});
        } catch (const Failure& why) {
            plan.refusal = why.what();
        }
        plan.offers["with"] = {std::string()};  // None: the settings B.
        for (const OfferedComparison& each : compare::offeredComparisons(scene.museum->subject(scene.subject)))
            plan.offers["with"].push_back(each.name);
    }
    if (!out.empty()) plan.files = {{out, "page, pictures, differences and numbers"}, {documentFile(out), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> ComparisonJob::start(JobOrder order) const
{
    return std::make_unique<ComparisonRun>(std::move(order));
}

JobScene ComparisonJob::sceneFor(const ParameterValues& values, JobScene scene) const
{
    if (!scene.usual.widens) return scene;
    const ComparisonTable& t = comparisonTable();
    scene.frame.camera = widened(scene.frame.camera, static_cast<double>(values[t.width]) / values[t.height]);
    scene.usual.widens = false;
    return scene;
}

double ComparisonJob::effort(const ParameterValues& values, const JobScene& scene) const
{
    const ComparisonTable& t = comparisonTable();
    const int given = values[t.samples];
    const int samples = given > 0 ? given : scene.museum ? usualSamples(scene.state.hall()) : 1;
    // Each side is drawn, and timed once more than it has runs.
    const int frames = values[t.runs] > 0 ? values[t.runs] + 1 : 0;
    return 2.0 * values[t.width] * values[t.height] * (samples + frames);
}

ParameterValues ComparisonJob::draft(const ParameterValues& values, const JobInputs&) const
{
    const ComparisonTable& t = comparisonTable();
    ParameterValues small = values;
    shrinkTo(comparisons::draftSide, {values[t.width], values[t.height]}, small, t.width, t.height);
    small.set(t.samples, 1);
    small.set(t.runs, 1);
    return small;
}

}  // namespace vitrine::jobs
