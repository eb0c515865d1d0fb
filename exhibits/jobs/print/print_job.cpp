#include "exhibits/jobs/print/print_job.h"

#include "exhibits/jobs/kit/job_options.h"
#include "exhibits/jobs/print/print_run.h"
#include "exhibits/printing/sheet.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/image/picture_formats.h"

#include <utility>

namespace vitrine::jobs {

using printing::printTable;
using printing::ViewOrigin;

namespace print_job {
namespace {

/// Checks of given parameters that have no effect with others.
class Checks {
public:
    explicit Checks(const GivenArguments& given) : given_(given), options_(optionsOf(printTable())) {}

    /// Refuses each of the parameters that is given, if `when`. `how`: "has no effect on a --chart; leave it out."
    template <typename... Rows> void refuse(bool when, const std::string& how, const Rows&... rows) const
    {
        if (when) (refuseOne(rows.row, how), ...);
    }

private:
    void refuseOne(std::size_t row, const std::string& how) const
    {
        if (given_.has(row)) throw Failure(ErrorKind::usage, optionOf(options_, row).name + ' ' + how);
    }

    const GivenArguments& given_;
    std::vector<JobOption> options_;
};

std::string without(const std::string& other)
{
    return "has no effect without " + other + "; leave it out, or give that too.";
}

std::string on(const std::string& what)
{
    return "has no effect on " + what + "; leave it out.";
}

/// Returns why the views cannot come from where they should; empty if they can.
std::string originRefusal(ViewOrigin origin, bool hasScene)
{
    if (hasScene && origin != ViewOrigin::shown)
        return "The views come from one place: give only one of --views, --quilt and --exhibit.";
    if (!hasScene && origin == ViewOrigin::shown)
        return "There are no views; give pictures with --views or --quilt, or an --exhibit.";
    return {};
}

void refuseUseless(const GivenArguments& given)
{
    const printing::PrintTable& t = printTable();
    const Checks check(given);
    const ViewOrigin origin = given.values[t.origin];
    const bool chart = origin == ViewOrigin::chart, scene = !given.subject.empty();
    const std::string onChart = on("a --chart, which has views of its own");
    if (chart && scene) throw Failure(ErrorKind::usage, "--exhibit " + onChart);
    check.refuse(chart, onChart, t.files, t.quilt, t.compensate, t.fitting, t.places, t.every, t.pingPong, t.cropMarks,
                 t.registrationMarks, t.colorBar, t.pitchStrip);
    check.refuse(given.values[t.outputProfile].empty(), without("--profile"), t.intent, t.blackPoint);
    if (scene && origin != ViewOrigin::shown) throw Failure(ErrorKind::usage, originRefusal(origin, scene));
    check.refuse(!chart || given.values[t.chart] != printing::ChartKind::pitch, without("--chart pitch"), t.chartSpan);
    check.refuse(!scene, without("--exhibit"), t.viewWidth, t.samples, t.baselineScale, t.convergence, t.turn, t.sweeps,
                 t.saveViews);
    check.refuse(scene, "and --exhibit exclude each other; give one of them.", t.fitting, t.places, t.every,
                 t.pingPong);
    check.refuse(origin != ViewOrigin::quilt, without("--quilt"), t.quiltOrder);
    check.refuse(::vitrine::render::lowerExtension(given.out) == ".png", on("a PNG, which is always compressed"),
                 t.compression);
    check.refuse(!given.values[t.sheet].empty(), on("a --sheet, whose lenses are known"), t.radius, t.thickness,
                 t.refractiveIndex, t.conic, t.lens, t.zone);
    if (chart && given.values[t.border] != 0)
        throw Failure(ErrorKind::usage, "--border-mm: charts have a border of their own.");
}

}  // namespace
}  // namespace print_job

JobNeeds PrintJob::needs() const
{
    std::vector<std::string_view> extensions;
    for (const ::vitrine::render::PictureFileFormat& format : ::vitrine::render::pictureFormats())
        if (format.isStreamed) extensions.push_back(format.extensions.front().substr(1));
    return {.anyScene = true,
            .extensions = std::move(extensions),
            .sceneByOption = true,
            .inParts = true,
            .report = "Additional file for the print's description, as JSON; it is always written beside the print and "
                      "into it",
            .carriesSettings = true};
}

std::shared_ptr<const JobInputs> PrintJob::read(const ParameterValues& values) const
{
    auto inputs = std::make_shared<ProfileInputs>();
    inputs->profile = printing::outputProfile(values);
    return inputs;
}

ParameterValues PrintJob::completed(const GivenArguments& given) const
{
    const printing::PrintTable& t = printTable();
    print_job::refuseUseless(given);
    const std::string& name = given.values[t.sheet];
    const bool lpiGiven = given.has(t.lensesPerInch.row);
    if (!lpiGiven && name.empty())
        throw Failure(ErrorKind::usage, "--lpi is missing: give the sheet's lenses per inch, or a --sheet.");
    if (name.empty()) return given.values;
    printing::Sheet sheet = printing::knownSheet(name);
    if (lpiGiven) sheet.effectiveLpi = given.values[t.lensesPerInch];
    if (given.values[t.measuredPerInch] != 0) sheet.effectiveLpi = given.values[t.measuredPerInch];
    return withSheet(given.values, sheet);
}

bool PrintJob::needsOutput(const ParameterValues& values) const
{
    return values[printTable().saveViews].empty() || values[printTable().origin] == ViewOrigin::chart;
}

std::string PrintJob::refusedInParts(const ParameterValues& values) const
{
    if (values[printTable().origin] == ViewOrigin::shown) return {};
    return "only views that are rendered are made in parts; give an --exhibit and --out.";
}

JobPlan PrintJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs& inputs,
                       const std::filesystem::path& out) const
{
    const std::string& profile = static_cast<const ProfileInputs&>(inputs).profile;
    JobPlan plan;
    plan.ifStopped = "Stopped; nothing was written.";
    plan.refusal = print_job::originRefusal(values[printTable().origin], scene.museum != nullptr);
    if (!plan.refusal.empty()) return plan;
    try {
        const printing::PrintLayout layout(printing::printSettings(values, printing::viewCount(values)));
        if (scene.museum) static_cast<void>(printing::viewSize(layout, values));
        if (out.empty()) return plan;
        const printing::PrintPlan print = printing::printPlan(values, nullptr, out, &profile);
        plan.refusal = print.refusal;
        if (!plan.refusal.empty()) return plan;
        plan.facts = printFacts(print, values[printTable().origin] != ViewOrigin::chart);
        for (const std::filesystem::path& file :
             printing::printFiles(layout, printing::printFile(values, out, &profile))) {
            plan.files.push_back({file, "print"});
            plan.files.push_back({file.string() + ".json", "description"});
        }
    } catch (const Failure& failure) {
        plan.refusal = failure.what();
    }
    return plan;
}

std::unique_ptr<JobRun> PrintJob::start(JobOrder order) const
{
    return std::make_unique<PrintRun>(std::move(order));
}

}  // namespace vitrine::jobs
