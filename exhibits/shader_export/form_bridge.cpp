#include "exhibits/shader_export/form_bridge.h"

#include "exhibits/shader_export/code_rewriter.h"
#include "exhibits/your_shader/guest_glsl.h"

#include <map>

namespace vitrine::guest {
namespace {

/// Returns the value of a variable that no dialect fills: the size of a picture.
std::string sizeValue(const std::string& name, const std::string& type)
{
    constexpr std::string_view ending = "Resolution";
    if (!name.ends_with(ending)) return "";
    const std::string picture = name.substr(0, name.size() - ending.size());
    return type == "vec2" ? "vec2(textureSize(" + picture + ", 0))" : "";
}

/// Returns the value of each variable of the dialects, of the widest type that it has.
std::map<std::string, std::string> valuesOf(const ExportStart& start, const FormWords& w)
{
    const std::string at = w.pointer + " * " + w.size;
    const std::string date =
        w.dateFrom0 ? w.date : "vec4(" + w.date + ".x, " + w.date + ".y - 1.0, " + w.date + ".z, " + w.date + ".w)";
    const std::string dateFrom1 =
        w.dateFrom0 ? "vec4(" + w.date + ".x, " + w.date + ".y + 1.0, " + w.date + ".z, " + w.date + ".w)" : w.date;
    const std::string mouse = w.pressed == "false" ? "iMouse"
                                                   : w.pressed + " ? vec4(" + at + ", " + w.pointer + ".x * " + w.size +
                                                         ".x, -" + w.pointer + ".y * " + w.size + ".y) : vec4(0.0)";
    return {{"TIME", w.time},
            {"TIMEDELTA", w.delta},
            {"FRAMEINDEX", w.frame},
            {"DATE", dateFrom1},
            {"PASSINDEX", w.pass},
            {"RENDERSIZE", w.size},
            {"isf_FragNormCoord", w.normalized},
            {"vv_FragNormCoord", w.normalized},
            {"iResolution", "vec3(" + w.size + ", 1.0)"},
            {"iTime", w.time},
            {"iTimeDelta", w.delta},
            {"iFrameRate", floatText(start.rate)},
            {"iFrame", w.frame},
            {"iMouse", mouse},
            {"iDate", date},
            {"iSampleRate", "44100.0"},
            {"iChannelTime", w.time},
            {"u_time", w.time},
            {"u_delta", w.delta},
            {"u_resolution", w.size},
            {"u_mouse", at},
            {"u_frame", w.frame},
            {"u_date", date},
            {"time", w.time},
            {"mouse", w.pointer},
            {"resolution", w.size},
            {"surfaceSize", "vec2(" + w.size + ".x / " + w.size + ".y, 1.0)"}};
}

/// Returns the value converted to the type with which the visitor declared it.
std::string converted(const std::string& value, const std::string& name, const std::string& type)
{
    static const std::map<std::string, std::string> usual{
        {"u_resolution", "vec2"}, {"u_mouse", "vec2"},     {"u_time", "float"}, {"u_delta", "float"},
        {"u_frame", "int"},       {"u_date", "vec4"},      {"time", "float"},   {"mouse", "vec2"},
        {"resolution", "vec2"},   {"surfaceSize", "vec2"}, {"iTime", "float"},  {"iResolution", "vec3"},
        {"iMouse", "vec4"}};
    const auto found = usual.find(name);
    if (found == usual.end() || found->second == type) return value;
    const std::string narrow = type == "vec2" ? ".xy" : type == "vec3" ? ".xyz" : "";
    if (found->second == "vec2" && type == "vec3")
        return "vec3(" + value + (name.find("mouse") == std::string::npos ? ", 1.0)" : ", 0.0)");
    if (found->second == "vec2" && type == "vec4")
        return "vec4(" + value + (name.find("mouse") == std::string::npos ? ", 1.0, 0.0)" : ", 0.0, 0.0)");
    if (narrow.empty()) return type + '(' + value + ')';
    return '(' + value + ')' + narrow;
}

}  // namespace

const FormWords& isfWords()
{
    static const FormWords words{"RENDERSIZE",        "TIME",      "TIMEDELTA", "FRAMEINDEX", "DATE",
                                 "isf_FragNormCoord", "PASSINDEX", "pointer",   "pressed",    false};
    return words;
}

const FormWords& shadertoyWords()
{
    static const FormWords words{"iResolution.xy",
                                 "iTime",
                                 "iTimeDelta",
                                 "iFrame",
                                 "iDate",
                                 "(gl_FragCoord.xy / iResolution.xy)",
                                 "0",
                                 "(iMouse.z > 0.0 ? iMouse.xy / iResolution.xy : vec2(0.5))",
                                 "false",
                                 true};
    return words;
}

std::vector<BridgedVariable> bridgedVariables(const ExportedShader& exported, const Pass& pass, const FormWords& words)
{
    const Shader& shader = exported.shader;
    const auto values = valuesOf(exported.start, words);
    std::vector<BridgedVariable> variables;
    for (const BuiltIn& builtIn : shader.builtIns) {
        if (!usesWord(pass.code, builtIn.name)) continue;
        BridgedVariable variable{builtIn.glslType, builtIn.name, "", static_cast<int>(builtIn.count)};
        if (const auto found = values.find(builtIn.name); found != values.end())
            variable.value = converted(found->second, builtIn.name, builtIn.glslType);
        else
            variable.value = sizeValue(builtIn.name, builtIn.glslType);
        variables.push_back(std::move(variable));
    }
    if (shader.form == Form::plain)
        for (const Varying& varying : varyingsOf(pass.code)) {
            const std::string& n = words.normalized;
            const std::string value = varying.type == "float"  ? n + ".x"
                                      : varying.type == "vec2" ? n
                                      : varying.type == "vec3" ? "vec3(" + n + ", 0.0)"
                                                               : "vec4(" + n + ", 0.0, 1.0)";
            variables.push_back({varying.type, varying.name, value});
        }
    if (shader.form == Form::isf)
        for (const char* name : {"isf_FragNormCoord", "vv_FragNormCoord"})
            if (usesWord(pass.code, name)) variables.push_back({"vec2", name, words.normalized});
    return variables;
}

std::string declarationsOf(const std::vector<BridgedVariable>& variables)
{
    std::string text;
    for (const BridgedVariable& each : variables) {
        text += each.type + ' ' + each.name;
        if (each.count > 0) text += '[' + std::to_string(each.count) + ']';
        text += ";\n";
    }
    return text;
}

std::string assignmentsOf(const std::vector<BridgedVariable>& variables, const std::string& indent)
{
    std::string text;
    for (const BridgedVariable& each : variables) {
        if (each.value.empty()) continue;
        if (each.count == 0) text += indent + each.name + " = " + each.value + ";\n";
        for (int i = 0; i < each.count; ++i)
            text += indent + each.name + '[' + std::to_string(i) + "] = " + each.value + ";\n";
    }
    return text;
}

}  // namespace vitrine::guest
