#include "exhibits/jobs/table/table_job.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/table/measured_table.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/table/measurements_table.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"

#include <algorithm>
#include <array>

namespace vitrine::jobs {
namespace table_job {
namespace {

const MeasurementsTable& tableTable()
{
    static const MeasurementsTable table;
    return table;
}

/// Returns the exhibit's measurements; null if it has none.
const MeasuresTable* measuresOf(const JobScene& scene)
{
    return scene.museum ? capability<MeasuresTable>(scene.museum->subject(scene.subject)) : nullptr;
}

/// Returns comma-separated values with another separator. Fields that contain it are put into quotes.
std::string separated(const std::string& csv, char separator)
{
    if (separator == ',') return csv;
    std::string text, field;
    bool isQuoted = false;
    const auto endField = [&] {
        const bool quotes = field.find(separator) != std::string::npos && field.front() != '"';
        text += quotes ? '"' + field + '"' : field;
        field.clear();
    };
    for (const char c : csv) {
        if (c == '"') isQuoted = !isQuoted;
        if (isQuoted || (c != ',' && c != '\n')) {
            field += c;
            continue;
        }
        endField();
        text += c == ',' ? separator : c;
    }
    endField();
    return text;
}

class TableRun final : public JobRun {
public:
    explicit TableRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override { return isDone_ ? Next::done : Next::draw; }
    void step(const Watch&) override
    {
        if (!table_) {
            const JobScene& scene = order_.scene;
            table_ = measuresOf(scene)->measureTable(scene.state.values[scene.subject]);
            backend_ = order_.backend ? order_.backend() : nullptr;
            if (!backend_) throw Failure(ErrorKind::openGl, "Nothing can be measured: there is no graphics context.");
        }
        if (!table_->step(*backend_)) end();
    }
    [[nodiscard]] double progress() const override { return isDone_ ? 1 : table_ ? table_->progress() : 0; }
    [[nodiscard]] std::string_view doing() const override { return "measuring"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override { render::publishAll(staged_); }

private:
    void end()
    {
        constexpr std::array separators{',', ';', '\t'};
        const std::string csv = table_->csv();
        backend_.reset();
        isDone_ = true;
        const auto lines = std::count(csv.begin(), csv.end(), '\n');
        report_.facts = {{"Lines", static_cast<double>(lines - 1)}};
        if (order_.out.empty()) return;
        const auto chosen = static_cast<std::size_t>(order_.values[tableTable().separator]);
        staged_.push_back(render::stagedFile(order_.out, separated(csv, separators[chosen])));
        staged_.push_back(
            render::stagedFile(documentFile(order_.out), documentText(TableJob(), order_, report_.facts)));
        report_.files = {order_.out, documentFile(order_.out)};
    }

    JobOrder order_;
    std::unique_ptr<TableMeasurement> table_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    bool isDone_ = false;
};

}  // namespace
}  // namespace table_job

const Parameters& TableJob::parameters() const
{
    return table_job::tableTable();
}

std::shared_ptr<const JobInputs> TableJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan TableJob::plan(const ParameterValues&, const JobScene& scene, const JobInputs&,
                       const std::filesystem::path& out) const
{
    JobPlan plan;
    if (const MeasuresTable* measures = table_job::measuresOf(scene))
        plan.facts = {{"Measurements", std::string(measures->tableTitle())}};
    else
        plan.refusal = "This exhibit has no table of measurements; a study measures its parameters.";
    if (out.empty()) return plan;
    if (plan.refusal.empty()) plan.refusal = refusedExtension(*this, out);
    plan.files = {{out, "measurements"}, {documentFile(out), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> TableJob::start(JobOrder order) const
{
    return std::make_unique<table_job::TableRun>(std::move(order));
}

}  // namespace vitrine::jobs
