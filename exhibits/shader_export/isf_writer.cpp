// Writes a shader of any form as ISF 2.

#include "exhibits/shader_export/code_rewriter.h"
#include "exhibits/shader_export/exported_shader.h"
#include "exhibits/shader_export/form_bridge.h"
#include "exhibits/shader_export/picture_files.h"
#include "exhibits/your_shader/guest_glsl.h"
#include "render/failure.h"
#include "render/files/strict_json.h"

#include <algorithm>
#include <cmath>

namespace vitrine::guest {
namespace {

using render::Json;

constexpr const char* components[] = {"X", "Y", "Z", "W"};

Json numbersJson(const std::vector<double>& numbers)
{
    if (numbers.size() == 1) return numbers[0];
    return numbers;
}

/// Returns the text without what would end the comment that holds the head.
std::string inComment(std::string text)
{
    for (std::size_t at = 0; (at = text.find("*/", at)) != std::string::npos;) text.insert(at + 1, " ");
    return text;
}

/// Writes one ISF.
class IsfWriter {
public:
    IsfWriter(const ExportedShader& exported, const std::filesystem::path& out)
        : exported_(exported), shader_(exported.shader), out_(out), words_(isfWords())
    {
        // A name of the visitor's own goes first.
        for (const Pass& pass : shader_.passes)
            for (std::string* name : {&words_.pointer, &words_.pressed})
                if (usesWord(pass.code, *name)) *name += "OfMouse";
    }

    ExportedFiles write()
    {
        std::string body =
            shader_.form == Form::isf ? rewritten(shader_, shader_.passes.front().code, {}) : otherBody();
        for (const Input& input : shader_.inputs) addInput(input);
        if (usesMouse_) addMouse();
        Json head{{"ISFVSN", "2"}};
        const std::string& about = shader_.description.empty() ? shader_.title : shader_.description;
        if (!about.empty()) head["DESCRIPTION"] = inComment(about);
        if (!shader_.credit.empty()) head["CREDIT"] = inComment(shader_.credit);
        if (!shader_.categories.empty()) head["CATEGORIES"] = shader_.categories;
        head["INPUTS"] = std::move(inputs_);
        if (Json passes = passesJson(); !passes.empty()) head["PASSES"] = std::move(passes);
        if (Json imported = importedJson(); !imported.empty()) head["IMPORTED"] = std::move(imported);
        std::string text = "/*" + inComment(render::writeJson(head));
        while (text.back() == '\n') text.pop_back();
        files_.files.insert(files_.files.begin(), {out_, text + "*/\n\n" + versionLine(body) + body});
        if (!shader_.vertexCode.empty())
            files_.files.push_back(
                {std::filesystem::path(out_).replace_extension(".vs"), rewritten(shader_, shader_.vertexCode, {})});
        return std::move(files_);
    }

private:
    [[noreturn]] static void refuse(Message sentence) { throw Failure(ErrorKind::check, std::move(sentence)); }

    // Inputs

    Json& newInput(const std::string& name, const char* type, const std::string& label)
    {
        inputs_.push_back(Json{{"NAME", name}, {"TYPE", type}});
        if (!label.empty() && label != name) inputs_.back()["LABEL"] = label;
        return inputs_.back();
    }
    static void setRange(Json& json, const Input& input)
    {
        json["MIN"] = numbersJson(input.low);
        json["MAX"] = numbersJson(input.high);
        json["DEFAULT"] = numbersJson(input.initial);
        if (input.exact) json["EXACT"] = *input.exact;
        if (!input.unit.empty()) json["UNIT"] = input.unit;
    }
    /// Declares a variable of the visitor's type, which is set from inputs of the types that ISF has.
    void bridge(const Input& input, std::string value)
    {
        inputVariables_.push_back({input.glslType, input.name, std::move(value)});
    }
    void addInput(const Input& input)
    {
        if (input.source == "buffer") return;
        const auto whole = [](double x) { return static_cast<std::int64_t>(std::llround(x)); };
        switch (input.type) {
        case InputType::real: return setRange(newInput(input.name, "float", input.label), input);
        case InputType::toggle:
            newInput(input.name, "bool", input.label)["DEFAULT"] = !input.initial.empty() && input.initial[0] != 0;
            return;
        case InputType::integer: {
            Json& json = newInput(input.name + (input.glslType == "int" ? "" : "_"), "long", input.label);
            json["MIN"] = whole(input.low[0]);
            json["MAX"] = whole(input.high[0]);
            json["DEFAULT"] = whole(input.initial[0]);
            if (input.exact) json["EXACT"] = *input.exact;
            return;
        }
        case InputType::choice: {
            Json& json = newInput(input.name, "long", input.label);
            for (const InputChoice& choice : input.choices) {
                json["VALUES"].push_back(choice.value);
                json["LABELS"].push_back(choice.label);
            }
            json["DEFAULT"] = whole(input.initial[0]);
            return;
        }
        case InputType::color: return addColor(input);
        case InputType::point:
        case InputType::vector: return addVector(input);
        case InputType::event: newInput(input.name, "event", input.label); return;
        case InputType::image:
            if (input.glslType != "sampler2D")
                refuse(message("ISF has no {1}, which “{2}” is; export a web page.", input.glslType, input.name));
            newInput(input.name, "image", input.label);
            files_.notes.push_back(
                message("ISF names no picture for the input “{1}”; the host chooses one.", input.name));
            return;
        case InputType::audio: newInput(input.name, "audio", input.label); return;
        case InputType::spectrum: newInput(input.name, "audioFFT", input.label); return;
        }
    }
    void addColor(const Input& input)
    {
        const bool opaque = input.glslType != "vec4";
        Json& json = newInput(input.name + (opaque ? "_" : ""), "color", input.label);
        std::vector<double> initial = input.initial;
        initial.resize(4, 1);
        json["DEFAULT"] = initial;
    }
    void addVector(const Input& input)
    {
        if (input.glslType == "vec2") return setRange(newInput(input.name, "point2D", input.label), input);
        const bool isFloat = input.glslType.starts_with('v');
        for (std::size_t i = 0; i < input.initial.size(); ++i) {
            Json& json = newInput(input.name + components[i], isFloat ? "float" : "long",
                                  (input.label.empty() ? input.name : input.label) + ' ' + components[i]);
            const auto number = [&](double x) { return isFloat ? Json(x) : Json(std::llround(x)); };
            json["MIN"] = number(input.low[i]);
            json["MAX"] = number(input.high[i]);
            json["DEFAULT"] = number(input.initial[i]);
        }
    }
    void addMouse()
    {
        Json& pointer = newInput(words_.pointer, "point2D", "Mouse");
        pointer["MIN"] = {0.0, 0.0};
        pointer["MAX"] = {1.0, 1.0};
        pointer["DEFAULT"] = {exported_.start.mouse.position.x, exported_.start.mouse.position.y};
        newInput(words_.pressed, "bool", "Mouse button")["DEFAULT"] = exported_.start.mouse.isDown;
    }
    /// Notes the variables whose types ISF has no input for.
    void bridgeInputs()
    {
        for (const Input& input : shader_.inputs) {
            if (isPicture(input) || input.type == InputType::event) continue;
            if (input.type == InputType::color && input.glslType != "vec4") bridge(input, input.name + "_.rgb");
            if (input.type == InputType::integer && input.glslType != "int")
                bridge(input, input.glslType + '(' + input.name + "_)");
            if ((input.type != InputType::vector && input.type != InputType::point) || input.glslType == "vec2")
                continue;
            std::string value = input.glslType + '(';
            for (std::size_t i = 0; i < input.initial.size(); ++i)
                value += (i > 0 ? ", " : "") + input.name + components[i];
            bridge(input, value + ')');
        }
    }

    // Code of other forms

    /// Name of a target as a variable: "Buffer A" is "BufferA".
    static std::string targetName(const std::string& name)
    {
        std::string variable;
        for (const char c : name)
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') variable += c;
        return variable;
    }
    [[nodiscard]] std::string targetOf(const Pass& pass) const
    {
        if (!pass.target.empty()) return targetName(pass.target);
        return shader_.inputNamed("backbuffer") ? "backbuffer" : "";
    }
    /// Returns the variable of the picture that a channel reads.
    std::string pictureOf(const Channel& channel, const Pass& pass)
    {
        if (channel.glslType != "sampler2D" || (channel.kind != "buffer" && channel.kind != "texture"))
            refuse(message("ISF has no channel of the kind “{1}”, which “{2}” is; export Shadertoy's JSON.",
                           channel.kind, channel.name));
        if (channel.kind == "buffer") {
            if (channel.filter == "nearest" || channel.wrap == "repeat")
                files_.notes.push_back(message("ISF filters all buffers and does not repeat them: “{1}” of “{2}” may "
                                               "look different.",
                                               channel.name, pass.name));
            return channel.source == "self" ? targetOf(pass) : targetName(channel.source);
        }
        if (channel.source.empty() || channel.source.starts_with('/'))
            refuse(message("“{1}” of “{2}” names no file; name a picture beside the shader in a line #{1} "
                           "\"file://name.png\".",
                           channel.name, pass.name));
        for (std::size_t i = 0; i < imports_.size(); ++i)
            if (imports_[i].path == channel.source) return imports_[i].name;
        imports_.push_back({"picture" + std::to_string(imports_.size() + 1), channel.source});
        return imports_.back().name;
    }

    /// Words of the visitor that have another meaning in ISF.
    static Renaming reservedNames()
    {
        Renaming renaming;
        for (const char* word : {"TIME", "TIMEDELTA", "RENDERSIZE", "DATE", "FRAMEINDEX", "PASSINDEX", "IMG_PIXEL",
                                 "IMG_NORM_PIXEL", "IMG_THIS_PIXEL", "IMG_THIS_NORM_PIXEL", "IMG_SIZE"})
            renaming[word] = std::string(word) + '_';
        return renaming;
    }
    /// Returns whether all passes have the same variable of this name: an input, or one that the program fills.
    [[nodiscard]] bool isShared(const std::string& name, const Pass& pass) const
    {
        const auto isNamed = [&](const auto& each) { return each.name == name; };
        const std::vector<Varying> varyings = varyingsOf(pass.code);
        return shader_.inputNamed(name) != nullptr ||
               std::any_of(shader_.builtIns.begin(), shader_.builtIns.end(), isNamed) ||
               std::any_of(varyings.begin(), varyings.end(), isNamed);
    }
    Renaming renamingOf(const Pass& pass, std::size_t index) const
    {
        Renaming renaming = reservedNames();
        const bool several = shader_.passes.size() > 1;
        const std::string ending = several ? "_" + std::to_string(index + 1) : "";
        if (several)
            for (const std::string& name : globalNames(pass.code))
                if (!isShared(name, pass)) renaming[name] = name + ending;
        renaming[shader_.form == Form::shadertoy ? "mainImage" : "main"] = exportedMain + ending;
        freeExportedNames(globalNames(pass.code), renaming, ending);
        renaming["gl_FragColor"] = exportedColor;
        renaming["gl_FragData"] = std::string(exportedColor) + 's';
        return renaming;
    }

    /// Output that a plain shader declares itself; empty: gl_FragColor.
    [[nodiscard]] std::string outputOf(const Pass& pass) const
    {
        return shader_.form == Form::plain ? outputName(pass.code) : "";
    }
    std::string otherBody()
    {
        bridgeInputs();
        std::vector<BridgedVariable> variables;
        std::string sections, calls;
        for (std::size_t i = 0; i < shader_.passes.size(); ++i) {
            const Pass& pass = shader_.passes[i];
            for (BridgedVariable& each : bridgedVariables(exported_, pass, words_)) {
                usesMouse_ = usesMouse_ || each.value.find(words_.pointer) != std::string::npos;
                const auto same = [&](const BridgedVariable& other) { return other.name == each.name; };
                if (std::none_of(variables.begin(), variables.end(), same)) variables.push_back(std::move(each));
            }
            sections += section(pass, i);
            calls += call(pass, i);
        }
        std::string text = "// Variables of the form in which the shader was written.\n" +
                           declarationsOf(inputVariables_) + declarationsOf(variables);
        text += "vec4 " + std::string(exportedColor) + ";\n";
        if (sections.find(std::string(exportedColor) + "s[") != std::string::npos)
            text += "vec4 " + std::string(exportedColor) + "s[1];\n";
        text += '\n' + sections + "\nvoid main()\n{\n" + assignmentsOf(inputVariables_, "    ") +
                assignmentsOf(variables, "    ");
        return text + "    " + exportedColor + " = vec4(0.0);\n" + calls + "    gl_FragColor = " + exportedColor +
               ";\n}\n";
    }
    std::string section(const Pass& pass, std::size_t index)
    {
        std::string text, after;
        const auto define = [&](const std::string& name, const std::string& value) {
            text += "#define " + name + (value.empty() ? "" : ' ' + value) + '\n';
            after += "#undef " + name + '\n';
        };
        if (shader_.passes.size() > 1) text += "// ---- " + pass.name + '\n';
        for (const std::string& name : pass.defines) define(name, "");
        for (const Channel& channel : pass.channels) define(channel.name, pictureOf(channel, pass));
        return text + rewritten(shader_, pass.code, renamingOf(pass, index)) + after;
    }
    std::string call(const Pass& pass, std::size_t index)
    {
        const bool several = shader_.passes.size() > 1;
        const std::string function = exportedMain + (several ? "_" + std::to_string(index + 1) : "");
        const std::string indent = several ? "        " : "    ";
        std::string text;
        for (const Channel& channel : pass.channels)
            if (usesWord(pass.code, "iChannelResolution"))
                text += indent + "iChannelResolution[" + channel.name.back() + "] = vec3(IMG_SIZE(" +
                        pictureOf(channel, pass) + "), 1.0);\n";
        text +=
            indent + function +
            (shader_.form == Form::shadertoy ? '(' + std::string(exportedColor) + ", gl_FragCoord.xy);\n" : "();\n");
        if (const std::string own = outputOf(pass); !own.empty())
            text += indent + exportedColor + " = " + own + (several ? "_" + std::to_string(index + 1) : "") + ";\n";
        if (usesWord(pass.code, "gl_FragData")) text += indent + exportedColor + " = " + exportedColor + "s[0];\n";
        return several ? "    if (PASSINDEX == " + std::to_string(index) + ") {\n" + text + "    }\n" : text;
    }

    // Passes and imports

    Json passesJson() const
    {
        Json passes = Json::array();
        for (const Pass& pass : shader_.passes) {
            Json json = Json::object();
            if (const std::string target = shader_.form == Form::isf ? pass.target : targetOf(pass); !target.empty())
                json["TARGET"] = target;
            if (pass.isPersistent) json["PERSISTENT"] = true;
            if (pass.isFloat) json["FLOAT"] = true;
            if (!pass.width.empty()) json["WIDTH"] = pass.width;
            if (!pass.height.empty()) json["HEIGHT"] = pass.height;
            passes.push_back(std::move(json));
        }
        return passes.size() == 1 && passes[0].empty() ? Json::array() : passes;
    }
    Json importedJson()
    {
        Json imported = Json::object();
        const std::vector<Import>& all = shader_.form == Form::isf ? shader_.imports : imports_;
        for (const Import& import : all)
            imported[import.name] = Json{{"PATH", besideOutput(exported_.path, import.path, out_, files_)}};
        return imported;
    }

    const ExportedShader& exported_;
    const Shader& shader_;
    const std::filesystem::path out_;
    FormWords words_;
    Json inputs_ = Json::array();
    std::vector<BridgedVariable> inputVariables_;
    std::vector<Import> imports_;
    bool usesMouse_ = false;
    ExportedFiles files_;
};

}  // namespace

ExportedFiles isfFiles(const ExportedShader& exported, const std::filesystem::path& out)
{
    return IsfWriter(exported, out).write();
}

}  // namespace vitrine::guest
