#include "exhibits/jobs/table/table_job.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/table/measured_table.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/table/measurements_table.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/text/joined.h"

#include <array>
#include <cmath>

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

/// Returns the lines as a file. Texts that contain the separator or a quote are put into quotes.
std::string separated(const std::vector<std::vector<std::string>>& lines, char separator)
{
    const auto cell = [&](const std::string& text) {
        if (text.find_first_of(std::string("\"\n") + separator) == std::string::npos) return text;
        std::string quoted = "\"";
        for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
        return quoted + '"';
    };
    std::string file;
    for (const std::vector<std::string>& line : lines) file += joined(line, std::string(1, separator), cell) + '\n';
    return file;
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
        ++done_;
        if (!table_->step(*backend_) || done_ >= lines()) end();
    }
    [[nodiscard]] double progress() const override { return isDone_ ? 1 : table_ ? table_->progress() / share() : 0; }
    [[nodiscard]] std::string_view doing() const override { return "measuring"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override { render::publishAll(staged_); }
    [[nodiscard]] std::string previewText() const override { return text_; }

    /// Returns the finished share of the whole table's time, 0 to 1.
    [[nodiscard]] double shareOfTable() const { return table_ ? table_->progress() : 0; }
    /// Returns the number of lines of the whole table.
    [[nodiscard]] std::size_t linesOfTable() const { return table_ ? table_->expectedLines() : 0; }

private:
    /// Returns how many lines are measured.
    [[nodiscard]] std::size_t lines() const
    {
        const auto most = static_cast<std::size_t>(order_.values[tableTable().lines]);
        return most > 0 ? std::min(most, table_->expectedLines()) : table_->expectedLines();
    }
    /// Returns the share of the table that these lines are.
    [[nodiscard]] double share() const
    {
        return static_cast<double>(lines()) / static_cast<double>(std::max<std::size_t>(table_->expectedLines(), 1));
    }
    void end()
    {
        constexpr std::array separators{',', ';', '\t'};
        const auto& texts = table_->lines();
        backend_.reset();
        isDone_ = true;
        report_.facts = {{"Lines", static_cast<double>(texts.size() - 1)}};
        const auto chosen = static_cast<std::size_t>(order_.values[tableTable().separator]);
        text_ = separated(texts, separators.at(chosen));
        if (order_.out.empty()) return;
        staged_.push_back(render::stagedFile(order_.out, text_));
        staged_.push_back(
            render::stagedFile(documentFile(order_.out), documentText(TableJob(), order_, report_.facts)));
        report_.files = {order_.out, documentFile(order_.out)};
    }

    JobOrder order_;
    std::unique_ptr<TableMeasurement> table_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    std::string text_;  ///< The finished file.
    std::size_t done_ = 0;
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

ParameterValues TableJob::draft(const ParameterValues& values, const JobInputs&) const
{
    constexpr int draftLines = 3;
    const Count& lines = table_job::tableTable().lines;
    ParameterValues first = values;
    first.set(lines, values[lines] > 0 ? std::min(values[lines], draftLines) : draftLines);
    return first;
}

JobForecast TableJob::forecast(const ParameterValues& values, const FinishedDraft& draft,
                               const std::filesystem::path&) const
{
    const auto& run = static_cast<const table_job::TableRun&>(draft.run);
    const Count& limit = table_job::tableTable().lines;
    const auto all = static_cast<double>(run.linesOfTable()), drawn = static_cast<double>(draft.values[limit]);
    const double lines = values[limit] > 0 ? std::min<double>(values[limit], all) : all;
    if (!(run.shareOfTable() > 0)) return {};
    const double seconds = draft.seconds / run.shareOfTable() * lines / all;
    const double kilobytes = static_cast<double>(run.previewText().size()) * lines / drawn / 1000;
    return {{{"Lines", lines}, {"File about", std::max(std::round(kilobytes), 1.0), "kB"}}, seconds};
}

}  // namespace vitrine::jobs
