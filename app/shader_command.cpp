#include "app/kit/command.h"
#include "app/kit/findings.h"

#include "exhibits/your_shader/shader_check.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/text/translation.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

using guest::Finding;
using guest::Form;
using render::Json;

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

/// Adds a file to the report, with the inputs and passes of its shader.
void reportShader(const std::string& file, const guest::CheckedShader& checked, FindingsReport& report)
{
    std::vector<CheckFinding> all;
    const auto add = [&](const std::vector<Finding>& findings, bool areErrors) {
        for (const Finding& finding : findings)
            all.push_back({areErrors, finding.sentence, finding.file, finding.line, finding.column});
    };
    add(checked.errors, true);
    if (checked.shader) add(checked.shader->notes, false);
    Json& json = report.add(file, checked.isGood(), all);
    if (!checked.shader) return;
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
}

/// Prints a finding in the form that editors read: "file:line:column: sentence", in the locale's language.
void printFinding(const Finding& finding)
{
    std::printf("%s:%d:%d: %s\n", finding.file.c_str(), finding.line, finding.column,
                ui::translatedInLocale(finding.sentence).c_str());
}

/// Checks one file and prints the findings. Returns 0, or the exit code of a failed check or a failed read.
int checkShader(const std::string& file, guest::ShaderCompiler& compiler, FindingsReport* report)
{
    const guest::CheckedShader checked = guest::checkShaderFile(file, compiler);
    if (report) {
        reportShader(file, checked, *report);
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
    return checkEach(files, "shader check", asJson, [&](const std::string& file, FindingsReport* report) {
        return checkShader(file, compiler, report);
    });
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
    checking->add_flag("--json", *asJson, "Print the findings, inputs and passes as JSON");
    checking->callback(
        [&chosen, files, asJson] { chosen = [files, asJson] { return checkShaders(*files, *asJson); }; });
}

}  // namespace vitrine::app
