#include "exhibits/jobs/proof/proof_job.h"

#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/printing/proof.h"
#include "exhibits/printing/read_print.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"

#include <cmath>
#include <limits>

namespace vitrine::jobs {
namespace {

struct ProofTable final : Parameters {
    Group printGroup = group("Print");
    File print = file("print", "Print that `vitrine print` wrote; of a print in tiles, any of them.",
                      extensions(render::streamedEndings()), positional(), mustBeGiven());

    Group eyeGroup = group("Eye");
    Real angle = real("angle", 0, degree, {degrees(-85), degrees(85)},
                      "Angle of the eye across the lenses; positive to the right, or below for horizontal lenses.",
                      typedIn(degree), mustBeGiven());
    Real angleAlong = real("angleY", 0, degree, {degrees(-85), degrees(85)},
                           "Angle of the eye along the lenses; positive above, or to the right for horizontal lenses.",
                           typedIn(degree), labeled("Angle along the lenses"));
    Real distance = real("distance", std::numeric_limits<double>::infinity(), centimeter,
                         Range{0.0001, 1000, logarithmic}.soft(0.1, 10), "Distance of the eye from the print.",
                         reads(std::numeric_limits<double>::infinity(), "inf"), option("distance-mm", millimeter));
};

const ProofTable& proofTable()
{
    static const ProofTable table;
    return table;
}

struct ProofInputs final : JobInputs {
    std::string doubt;
};

class ProofRun final : public JobRun {
public:
    explicit ProofRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override { return isDone_ ? Next::done : Next::work; }
    void step(const Watch&) override
    {
        const ProofTable& t = proofTable();
        // Rounded, to remove the error in the last digits that the conversion from meters adds.
        const double distance = std::round(order_.values[t.distance] * 1e12) / 1e9;
        const printing::Eye eye{order_.values[t.angle], order_.values[t.angleAlong], distance};
        printing::PrintRaster print = printing::readPrint(order_.values[t.print]);
        const render::Image seen = printing::lookThrough(print, eye);
        report_.facts = {{"Picture", std::to_string(seen.width) + " × " + std::to_string(seen.height), "px"}};
        stage(seen, print.layout().settings().sheet.lpi());
        isDone_ = true;
    }
    [[nodiscard]] double progress() const override { return isDone_ ? 1 : 0; }
    [[nodiscard]] std::string_view doing() const override { return "looking through the lenses"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override { render::publishAll(staged_); }

private:
    void stage(const render::Image& seen, double lensesPerInch)
    {
        const std::filesystem::path& out = order_.out;
        if (out.empty()) return;
        staged_.push_back(
            render::stagedPicture(out, seen, render::writtenFormat(out, 8).value(), {.pixelsPerInch = lensesPerInch}));
        staged_.push_back(render::stagedFile(documentFile(out), documentText(ProofJob(), order_, report_.facts)));
        report_.files = {out, documentFile(out)};
    }

    JobOrder order_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    bool isDone_ = false;
};

}  // namespace

const Parameters& ProofJob::parameters() const
{
    return proofTable();
}

std::shared_ptr<const JobInputs> ProofJob::read(const ParameterValues& values) const
{
    auto inputs = std::make_shared<ProofInputs>();
    inputs->doubt = printing::readPrint(values[proofTable().print]).doubt();
    return inputs;
}

JobPlan ProofJob::plan(const ParameterValues&, const JobScene&, const JobInputs& inputs,
                       const std::filesystem::path& out) const
{
    JobPlan plan;
    const std::string& doubt = static_cast<const ProofInputs&>(inputs).doubt;
    if (!doubt.empty()) plan.warnings.push_back(doubt);
    if (out.empty()) return plan;
    plan.refusal = refusedExtension(*this, out);
    plan.files = {{out, "picture"}, {documentFile(out), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> ProofJob::start(JobOrder order) const
{
    return std::make_unique<ProofRun>(std::move(order));
}

}  // namespace vitrine::jobs
