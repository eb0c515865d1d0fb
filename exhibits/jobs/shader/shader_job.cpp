#include "exhibits/jobs/shader/shader_job.h"

#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/shader_export/scene_shader.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"

#include <optional>

namespace vitrine::jobs {
namespace {

struct ShaderTable final : Parameters {
    Group page = group("Page");
    Count width = side("width", 960);
    Count height = side("height", 540);
    Toggle runs = toggle("runs", true, "Whether time runs when the page is opened. Readers can stop and start it.",
                         labeled("Time runs"));

private:
    Count side(std::string_view name, int pixels)
    {
        return count(name, pixels, Range{16, 4096, logarithmic}.soft(160, 1920),
                     "Width x height of the picture on a web page, in pixels.", tuple("size", 'x'));
    }
};

const ShaderTable& shaderTable()
{
    static const ShaderTable table;
    return table;
}

guest::ExportForm formOf(const std::filesystem::path& out)
{
    const std::string ending = out.extension().string();
    if (ending == ".fs") return guest::ExportForm::isf;
    if (ending == ".glsl") return guest::ExportForm::shadertoy;
    return ending == ".json" ? guest::ExportForm::shadertoyJson : guest::ExportForm::web;
}

std::string formName(guest::ExportForm form)
{
    switch (form) {
    case guest::ExportForm::isf: return "ISF";
    case guest::ExportForm::shadertoy: return "Shadertoy code";
    case guest::ExportForm::shadertoyJson: return "Shadertoy JSON";
    case guest::ExportForm::web: break;
    }
    return "web page";
}

/// Returns the text of the shader, as ISF where that is possible. Throws Failure if it cannot be exported at all.
std::string textOf(const guest::ExportedShader& shader)
{
    try {
        return exportedFiles(shader, guest::ExportForm::isf, "shader.fs").files.front().bytes;
    } catch (const Failure&) {
        return exportedFiles(shader, guest::ExportForm::web, "shader.html").files.front().bytes;
    }
}

/// Writes the files in one step, which takes as long as preparing a frame.
class ShaderRun final : public JobRun {
public:
    explicit ShaderRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override { return isDone_ ? Next::done : Next::work; }
    void step(const Watch& watch) override
    {
        if (!watch(0)) throw Stopped();
        const ShaderTable& t = shaderTable();
        const JobScene& scene = order_.scene;
        guest::ExportedShader shader = guest::sceneShader(*scene.museum, scene.state, scene.subject, scene.frame);
        shader.start.size = {order_.values[t.width], order_.values[t.height]};
        shader.start.runs = order_.values[t.runs];
        report_.facts = {{"Inputs", static_cast<double>(shader.shader.inputs.size())},
                         {"Passes", static_cast<double>(shader.shader.passes.size())}};
        if (order_.out.empty()) {
            text_ = textOf(shader);
            shader_ = std::move(shader);
        } else {
            const guest::ExportForm form = formOf(order_.out);
            guest::ExportedFiles exported = exportedFiles(shader, form, order_.out);
            report_.facts.insert(report_.facts.begin(), {"Form", formName(form)});
            for (const Message& note : exported.notes) report_.warnings.push_back(note.english());
            stage(std::move(exported));
        }
        isDone_ = true;
        if (!watch(1)) throw Stopped();
    }
    [[nodiscard]] double progress() const override { return isDone_ ? 1 : 0; }
    [[nodiscard]] std::string_view doing() const override { return "translating"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override { render::publishAll(staged_); }
    [[nodiscard]] std::string previewText() const override { return text_; }
    /// Returns the shader of a finished run without an output.
    [[nodiscard]] const guest::ExportedShader& shader() const { return *shader_; }

private:
    void stage(guest::ExportedFiles exported)
    {
        exported.files.push_back({documentFile(order_.out), documentText(ShaderJob(), order_, report_.facts)});
        for (const render::NamedBytes& file : exported.files) {
            staged_.push_back(render::stagedFile(file.path, file.bytes));
            report_.files.push_back(file.path);
        }
    }

    JobOrder order_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    std::optional<guest::ExportedShader> shader_;
    std::string text_;  ///< Text of the shader, for the preview.
    bool isDone_ = false;
};

}  // namespace

const Parameters& ShaderJob::parameters() const
{
    return shaderTable();
}

std::shared_ptr<const JobInputs> ShaderJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan ShaderJob::plan(const ParameterValues&, const JobScene& scene, const JobInputs&,
                        const std::filesystem::path& out) const
{
    JobPlan plan;
    if (scene.subject == hallIndex) plan.refusal = "The hall is drawn by many passes; visit an exhibit first.";
    if (out.empty()) return plan;
    plan.facts = {{"Form", formName(formOf(out))}};
    plan.files = {{out, "shader"}, {documentFile(out), "settings"}};
    return plan;
}

JobForecast ShaderJob::forecast(const ParameterValues&, const FinishedDraft& draft,
                                const std::filesystem::path& out) const
{
    const auto& run = static_cast<const ShaderRun&>(draft.run);
    try {
        const guest::ExportForm form = formOf(out);
        double bytes = 0;
        for (const render::NamedBytes& file : exportedFiles(run.shader(), form, out).files)
            bytes += static_cast<double>(file.bytes.size());
        return {{{"Form", formName(form)}, fileAbout(bytes)}};
    } catch (const Failure&) {
        return {};  // The export says why there is no such form.
    }
}

std::unique_ptr<JobRun> ShaderJob::start(JobOrder order) const
{
    return std::make_unique<ShaderRun>(std::move(order));
}

}  // namespace vitrine::jobs
