#include "exhibits/shader_export/exported_shader.h"

#include "exhibits/framework/files/file_path.h"
#include "exhibits/your_shader/guest_glsl.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <cmath>

namespace vitrine::guest {
namespace {

/// Returns the present numbers of an input, in the unit in which the shader reads them.
std::vector<double> presentNumbers(const Input& input, const std::vector<std::size_t>& rows,
                                   const ParameterValues& values)
{
    if (input.type == InputType::event || isPicture(input) || rows.empty()) return input.initial;
    std::vector<double> numbers;
    if (input.type == InputType::color) {
        const glm::dvec3 linear = std::get<glm::dvec3>(values.row(rows[0]));
        for (int i = 0; i < 3; ++i) numbers.push_back(render::srgbFromLinear(linear[i]));
        if (input.glslType == "vec4") numbers.push_back(rows.size() > 1 ? std::get<double>(values.row(rows[1])) : 1);
        return numbers;
    }
    for (const std::size_t row : rows)
        numbers.push_back(shown(std::get<double>(values.row(row)), values.rows()[row].unit));
    if (input.type != InputType::choice) return numbers;
    const auto index = static_cast<std::size_t>(std::max(numbers[0], 0.0));
    return {static_cast<double>(input.choices[std::min(index, input.choices.size() - 1)].value)};
}

}  // namespace

ExportedShader exportedShader(const Work& work, const YourShaderTable& table, const ParameterValues& values)
{
    ExportedShader exported{.shader = *work.shader, .path = work.path, .ofInputs = {}, .start = {}};
    for (std::size_t i = 0; i < exported.shader.inputs.size(); ++i) {
        Input& input = exported.shader.inputs[i];
        const std::vector<std::size_t>& rows = table.ofInputs[i];
        input.initial = presentNumbers(input, rows, values);
        for (std::size_t c = 0; c < input.initial.size() && c < input.low.size(); ++c) {
            input.low[c] = std::min(input.low[c], input.initial[c]);
            input.high[c] = std::max(input.high[c], input.initial[c]);
        }
        const bool isShown = !table.sourceOf(i, values).empty();
        const bool isFile = input.type == InputType::image && !rows.empty() && !isShown;
        if (isShown)
            exported.notes.push_back(message(
                "“{1}” shows a picture that only the museum has; the exported shader begins without it.", input.name));
        exported.ofInputs.emplace_back(
            isFile ? filePath(table.rows()[rows[0]], std::get<std::string>(values.row(rows[0]))) : std::string());
    }
    exported.start = {.moment = values[table.moment],
                      .runs = values[table.animate],
                      .rate = values[table.rate],
                      .loopRounds = values[table.loopRounds],
                      .mouse = {{values[table.mouseX], values[table.mouseY]}, values[table.mouseDown]}};
    return exported;
}

namespace {

ExportedFiles filesOf(const ExportedShader& shader, ExportForm form, const std::filesystem::path& out)
{
    switch (form) {
    case ExportForm::isf: return isfFiles(shader, out);
    case ExportForm::shadertoy: return shadertoyFiles(shader, false, out);
    case ExportForm::shadertoyJson: return shadertoyFiles(shader, true, out);
    case ExportForm::web: break;
    }
    return webFiles(shader, out);
}

}  // namespace

ExportedFiles exportedFiles(const ExportedShader& shader, ExportForm form, const std::filesystem::path& out)
{
    ExportedFiles files = filesOf(shader, form, out);
    files.notes.insert(files.notes.begin(), shader.notes.begin(), shader.notes.end());
    return files;
}

}  // namespace vitrine::guest
