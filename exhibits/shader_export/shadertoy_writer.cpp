// Writes a shader as Shadertoy's code, or as Shadertoy's JSON.

#include "exhibits/shader_export/code_rewriter.h"
#include "exhibits/shader_export/exported_shader.h"
#include "exhibits/shader_export/form_bridge.h"
#include "exhibits/shader_export/picture_files.h"
#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/reading.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/files/strict_json.h"

#include <algorithm>
#include <cmath>

namespace vitrine::guest {
namespace {

using render::Json;

[[noreturn]] void refuseForShadertoy(Message sentence)
{
    throw Failure(ErrorKind::check, std::move(sentence));
}

/// Returns numbers with blanks between them.
std::string spaced(const std::vector<double>& numbers)
{
    std::string text;
    for (const double each : numbers) text += (text.empty() ? "" : " ") + render::shortestNumber(each);
    return text;
}

/// Returns the type of an input in an `#iUniform` line; empty if such a line has none for it.
std::string sliderType(const Input& input)
{
    if (input.type == InputType::color) return input.glslType == "vec4" ? "color4" : "color3";
    for (const char* type : {"float", "int", "bool", "vec2", "vec3", "vec4"})
        if (input.glslType == type) return type;
    return "";
}

/// Returns the initial value of a slider: "0.5", "vec2(0.5, 0.25)".
std::string sliderValue(const Input& input, const std::string& type)
{
    const bool isWhole = type == "int" || type == "bool";
    std::string numbers;
    for (const double each : input.initial)
        numbers += (numbers.empty() ? "" : ", ") + (isWhole ? std::to_string(std::llround(each)) : floatText(each));
    return input.initial.size() == 1 ? numbers : type + '(' + numbers + ')';
}

/// Returns the line that makes a slider of an input.
std::string sliderLine(const Input& input)
{
    const std::string type = sliderType(input);
    if (type.empty())
        refuseForShadertoy(
            message("Shadertoy's code has no input of the type {1}, which “{2}” is; export ISF or a web page.",
                    input.glslType, input.name));
    std::string line = "#iUniform " + type + ' ' + input.name + " = " + sliderValue(input, type);
    if (input.type == InputType::color || input.type == InputType::toggle) return line + '\n';
    std::vector<double> low = input.low, high = input.high;
    for (const InputChoice& choice : input.choices) {
        low.resize(1, choice.value);
        high.resize(1, choice.value);
        low[0] = std::min(low[0], static_cast<double>(choice.value));
        high[0] = std::max(high[0], static_cast<double>(choice.value));
    }
    if (input.type == InputType::choice && !(high[0] > low[0])) high[0] = low[0] + 1;
    const double lowest = *std::min_element(low.begin(), low.end()),
                 highest = *std::max_element(high.begin(), high.end());
    if (!(highest > lowest)) return line + '\n';
    line += " in {" + floatText(lowest) + ", " + floatText(highest) + '}';
    std::string label = input.label;
    std::erase_if(label, [](char c) { return c == '"' || c == '\n'; });
    line += " // " + spaced(low) + " .. " + spaced(high) + ", default " + spaced(input.initial);
    if (input.exact) line += ", exact " + render::shortestNumber(*input.exact);
    if (!input.unit.empty()) line += ", " + input.unit;
    if (!label.empty() && label != input.name) line += ", \"" + label + '"';
    return line + '\n';
}

constexpr const char* imageMacros = R"(#define IMG_NORM_PIXEL(image, at) texture(image, at)
#define IMG_PIXEL(image, at) texture(image, (at) / vec2(textureSize(image, 0)))
#define IMG_THIS_NORM_PIXEL(image) texture(image, isf_FragNormCoord)
#define IMG_THIS_PIXEL(image) texture(image, isf_FragNormCoord)
#define IMG_SIZE(image) vec2(textureSize(image, 0))
)";

/// Writes the code of the one pass of a shader.
class ShadertoyWriter {
public:
    ShadertoyWriter(const ExportedShader& exported, const std::filesystem::path& out)
        : exported_(exported), shader_(exported.shader), out_(out)
    {
    }

    ExportedFiles code()
    {
        if (shader_.passes.size() > 1)
            refuseForShadertoy(
                message("The shader has {1} passes, and Shadertoy's code has one; give --out a name that ends "
                        "in .json, .fs or .html.",
                        shader_.passes.size()));
        std::string text = heading() + sliders() + channelLines(shader_.passes[0]) + '\n' + body(shader_.passes[0]);
        files_.files.insert(files_.files.begin(), {out_, std::move(text)});
        return std::move(files_);
    }

    ExportedFiles json()
    {
        if (shader_.passes.size() > 1 && shader_.form != Form::shadertoy)
            refuseForShadertoy(
                message("The passes of this shader are not Shadertoy's buffers; export ISF or a web page."));
        Json passes = Json::array();
        if (const std::string lines = sliders(); !lines.empty())
            passes.push_back(Json{{"type", "common"}, {"name", "Common"}, {"code", lines}});
        for (const Pass& pass : shader_.passes) passes.push_back(passJson(pass));
        const Json info{{"name", shader_.title}, {"description", shader_.description}, {"username", shader_.credit}};
        const Json whole{{"Shader", Json{{"ver", "0.1"}, {"info", info}, {"renderpass", std::move(passes)}}}};
        files_.files.insert(files_.files.begin(), {out_, render::writeJson(whole)});
        return std::move(files_);
    }

private:
    std::string heading() const
    {
        std::string text;
        for (std::string line : {shader_.description.empty() ? shader_.title : shader_.description, shader_.credit}) {
            std::replace(line.begin(), line.end(), '\n', ' ');
            if (!line.empty()) text += "// " + line + '\n';
        }
        return text;
    }
    std::string sliders()
    {
        std::string text;
        for (const Input& input : shader_.inputs) {
            if (isPicture(input)) continue;
            if (input.type == InputType::event) {
                files_.notes.push_back(message("Shadertoy's code has no buttons: “{1}” is never pressed.", input.name));
                continue;
            }
            if (input.type == InputType::choice)
                files_.notes.push_back(
                    message("Shadertoy's code has no labels of choices: “{1}” is a whole number.", input.name));
            text += sliderLine(input);
        }
        return text;
    }
    /// Names the pictures of the inputs, in the order of the channels.
    std::string channelLines(const Pass& pass)
    {
        std::string text;
        if (shader_.form == Form::shadertoy) {
            for (const Channel& channel : pass.channels) text += channelLine(channel);
            return text;
        }
        std::size_t count = 0;
        const auto name = [&](const std::string& variable, const std::string& path) {
            if (count == 4)
                refuseForShadertoy(message("The shader reads more than the four pictures that Shadertoy's code has; "
                                           "export ISF or a web page."));
            const std::string channel = "iChannel" + std::to_string(count++);
            text += '#' + channel + " \"file://" + path + "\"\n";
            macros_ += "#define " + variable + ' ' + channel + '\n';
        };
        for (std::size_t i = 0; i < shader_.inputs.size(); ++i) {
            const Input& input = shader_.inputs[i];
            if (!isPicture(input)) continue;
            if (input.source == "buffer")
                refuseForShadertoy(message(
                    "Shadertoy's code has no buffers, and “{1}” is one; export ISF or a web page.", input.name));
            const std::filesystem::path& file = exported_.ofInputs[i];
            if (input.type != InputType::image || file.empty())
                refuseForShadertoy(message("“{1}” has no picture file; choose one with --set {1}=FILE.", input.name));
            name(input.name, besideOutput(file, file.filename().string(), out_, files_));
        }
        for (const Import& import : shader_.imports)
            name(import.name, besideOutput(exported_.path, import.path, out_, files_));
        return text;
    }
    std::string channelLine(const Channel& channel)
    {
        std::string text;
        const std::string line = '#' + channel.name;
        if (channel.kind == "buffer")
            text += line + " \"self\"\n";
        else if (channel.kind == "texture" && !channel.source.empty() && !channel.source.starts_with('/'))
            text += line + " \"file://" + besideOutput(exported_.path, channel.source, out_, files_) + "\"\n";
        else if (channel.kind != "texture")
            refuseForShadertoy(
                message("Shadertoy's code names no channel of the kind “{1}”; give --out a name that ends in .json.",
                        channel.kind));
        if (text.empty()) return text;
        if (!channel.filter.empty()) text += line + "::MinFilter \"" + channel.filter + "\"\n";
        if (!channel.wrap.empty()) text += line + "::WrapMode \"" + channel.wrap + "\"\n";
        return text;
    }

    std::string body(const Pass& pass)
    {
        if (shader_.form == Form::shadertoy) return rewritten(shader_, pass.code, {});
        if (!shader_.vertexCode.empty())
            refuseForShadertoy(message("Shadertoy's code has no vertex shader; export ISF or a web page."));
        if (pass.isPersistent)
            refuseForShadertoy(
                message("Shadertoy's code has no buffers, and the picture of this shader is one; export ISF or a "
                        "web page."));
        Renaming renaming{{"main", exportedMain}, {"gl_FragColor", exportedColor}};
        freeExportedNames(globalNames(pass.code), renaming);
        std::vector<BridgedVariable> variables = bridgedVariables(exported_, pass, shadertoyWords());
        for (BridgedVariable& each : variables)
            if (each.name.starts_with('i') && each.name != "isf_FragNormCoord") renaming[each.name] = each.name += '_';
        std::string text;
        for (const Input& input : shader_.inputs)
            if (input.type == InputType::event) text += "const bool " + input.name + " = false;\n";
        text += macros_ + (shader_.form == Form::isf ? imageMacros : "") + declarationsOf(variables);
        if (usesWord(pass.code, "gl_FragData"))
            refuseForShadertoy(
                message("The shader writes gl_FragData, which Shadertoy's code lacks; write gl_FragColor."));
        text += "vec4 " + std::string(exportedColor) + ";\n\n" + rewritten(shader_, pass.code, renaming);
        const std::string own = shader_.form == Form::plain ? outputName(pass.code) : "";
        return text + "\nvoid mainImage(out vec4 fragColor, in vec2 fragCoord)\n{\n" +
               assignmentsOf(variables, "    ") + "    " + exportedColor + " = vec4(0.0);\n    " + exportedMain +
               "();\n    fragColor = " + (own.empty() ? exportedColor : own) + ";\n}\n";
    }

    Json passJson(const Pass& pass)
    {
        const bool isPicture = pass.target.empty();
        Json json{{"type", isPicture ? "image" : "buffer"}, {"name", pass.name}};
        if (shader_.form != Form::shadertoy) {
            const std::string lines = channelLines(pass);
            json["code"] = lines + body(pass);
            json["inputs"] = Json::array();
            return json;
        }
        if (usesWord(pass.code, "mainCubemap")) json["type"] = "cubemap";
        json["code"] = rewritten(shader_, pass.code, {});
        json["inputs"] = Json::array();
        for (const Channel& channel : pass.channels) {
            Json input{{"channel", channel.name.back() - '0'}, {"ctype", channel.kind}};
            if (channel.kind == "buffer")
                input["id"] = channel.source == "self" ? pass.target : channel.source;
            else if (channel.kind == "texture" && !channel.source.empty() && !channel.source.starts_with('/'))
                input["src"] = besideOutput(exported_.path, channel.source, out_, files_);
            else
                input["src"] = channel.source;
            input["sampler"] =
                Json{{"filter", channel.filter}, {"wrap", channel.wrap}, {"vflip", channel.flipped ? "true" : "false"}};
            json["inputs"].push_back(std::move(input));
        }
        if (!isPicture) json["outputs"] = Json::array({Json{{"id", pass.target}, {"channel", 0}}});
        return json;
    }

    const ExportedShader& exported_;
    const Shader& shader_;
    const std::filesystem::path out_;
    std::string macros_;
    ExportedFiles files_;
};

}  // namespace

ExportedFiles shadertoyFiles(const ExportedShader& exported, bool asJson, const std::filesystem::path& out)
{
    ShadertoyWriter writer(exported, out);
    return asJson ? writer.json() : writer.code();
}

}  // namespace vitrine::guest
