#include "app/kit/command.h"

#include "exhibits/your_shader/shader_check.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/text/translation.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

using guest::Finding;
using guest::Form;
using render::Json;

Json shaderFindingsJson(const std::vector<Finding>& findings)
{
    Json all = Json::array();
    for (const Finding& finding : findings)
        all.push_back(Json{{"file", finding.file},
                           {"line", finding.line},
                           {"column", finding.column},
                           {"sentence", finding.sentence.english()}});
    return all;
}

/// Returns the name of the form, with its version: "ISF 2".
std::string formName(const guest::Shader& shader)
{
    switch (shader.form) {
    case Form::isf: return "ISF " + shader.version;
    case Form::shadertoy: return "Shadertoy";
    case Form::plain: break;
    }
    return "plain";
}

Json shaderJson(const std::string& file, const guest::CheckedShader& checked)
{
    Json json{{"file", file}, {"good", checked.isGood()}, {"errors", shaderFindingsJson(checked.errors)}};
    if (!checked.shader) return json;
    json["notes"] = shaderFindingsJson(checked.shader->notes);
    json["form"] = formName(*checked.shader);
    json["title"] = checked.shader->title;
    json["inputs"] = Json::array();
    for (const guest::Input& input : checked.shader->inputs)
        json["inputs"].push_back(Json{{"name", input.name}, {"label", input.label}, {"type", input.glslType}});
    json["passes"] = Json::array();
    for (std::size_t i = 0; i < checked.shader->passes.size(); ++i) {
        Json pass{{"name", checked.shader->passes[i].name}, {"target", checked.shader->passes[i].target}};
        if (i < checked.programs.size()) pass["instructions"] = checked.programs[i].counts.instructions;
        json["passes"].push_back(std::move(pass));
    }
    return json;
}

/// Prints a finding in the form that editors read: "file:line:column: sentence", in the locale's language.
void printFinding(const Finding& finding)
{
    std::printf("%s:%d:%d: %s\n", finding.file.c_str(), finding.line, finding.column,
                ui::translatedInLocale(finding.sentence).c_str());
}

/// Checks one file and prints the findings. Returns 0, or the exit code of a failed check or a failed read.
int checkShader(const std::string& file, guest::ShaderCompiler& compiler, Json* report)
{
    const guest::CheckedShader checked = guest::checkShaderFile(file, compiler);
    if (report) {
        report->push_back(shaderJson(file, checked));
    } else {
        if (checked.isGood())
            std::printf("%s: good (%s, %zu inputs, %zu passes)\n", file.c_str(), formName(*checked.shader).c_str(),
                        checked.shader->inputs.size(), checked.shader->passes.size());
        for (const Finding& finding : checked.errors) printFinding(finding);
        if (checked.shader)
            for (const Finding& finding : checked.shader->notes) printFinding(finding);
    }
    if (checked.isGood()) return 0;
    return static_cast<int>(checked.fileRead ? ErrorKind::check : ErrorKind::file);
}

int checkShaders(const std::vector<std::string>& files, bool asJson)
{
    guest::ShaderCompiler compiler;
    Json report = Json::array();
    int worst = 0;
    for (const std::string& file : files)
        worst = std::max(worst, checkShader(file, compiler, asJson ? &report : nullptr));
    if (asJson) std::fputs(render::writeJson(report).c_str(), stdout);
    return worst;
}

}  // namespace

void addShaderCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("shader", "Work with shaders of your own");
    command->require_subcommand(1);
    CLI::App* checking =
        command->add_subcommand("check", "Check shader files, and list their errors as file:line:column: ...");
    auto files = std::make_shared<std::vector<std::string>>();
    auto asJson = std::make_shared<bool>(false);
    checking->add_option("files", *files, "Shaders: ISF, Shadertoy's code or JSON, or plain fragment shaders")
        ->required();
    checking->add_flag("--json", *asJson, "Print the errors, inputs and passes as JSON");
    checking->callback(
        [&chosen, files, asJson] { chosen = [files, asJson] { return checkShaders(*files, *asJson); }; });
}

}  // namespace vitrine::app
