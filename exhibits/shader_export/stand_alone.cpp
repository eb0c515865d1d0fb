#include "exhibits/shader_export/stand_alone.h"

#include "exhibits/framework/scene/stands_alone.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/kit/sky_view.h"
#include "exhibits/shader_export/block_layout.h"
#include "exhibits/shader_export/code_rewriter.h"
#include "exhibits/shader_export/glsl_items.h"
#include "exhibits/your_shader/guest_reader.h"
#include "exhibits/your_shader/guest_work.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/glsl/shader_source.h"
#include "render/image/srgb.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::guest {
namespace {

using render::Json;

constexpr const char* rootFile = "your_shader/exported shader";
constexpr const char* tonePass = "tone";

[[noreturn]] void refuseExhibit(Message sentence)
{
    throw Failure(ErrorKind::check, std::move(sentence));
}

/// An exhibit with the passes that draw it alone, from which the text of the ISF is generated.
struct AlonePicture {
    const Museum& museum;
    SceneState state;
    std::size_t subject = 0;
    render::FramePlan plan;
    const render::Pass* pass = nullptr;
    const render::Pass* tone = nullptr;
    StandAloneNumbers numbers = {};

    [[nodiscard]] const SceneObject& exhibit() const { return museum.subject(subject); }
    [[nodiscard]] const ParameterValues& values() const { return state.values[subject]; }
};
AlonePicture alonePicture(const Museum&, SceneState, std::size_t subject);

/// Returns the shader files that replace textures of a pass: tables of the sky become arrays.
std::map<std::string, std::string> textsForPictures(const render::Pass& pass)
{
    std::map<std::string, std::string> texts;
    for (const render::SampledTexture& input : pass.inputs)
        if (const auto* picture = std::get_if<std::shared_ptr<const render::Texture>>(&input.source))
            if (*picture && (*picture)->name == skyTableName) texts["lib/sky_view.glsl"] = skyArrayGlsl(**picture);
    return texts;
}

/// Returns a legal value other than the present one.
Value otherValue(const ParameterInfo& info, const Value& present)
{
    if (const auto* color = std::get_if<glm::dvec3>(&present)) return 0.5 * *color + 0.25;
    const double number = std::get<double>(present);
    if (info.kind == Kind::toggle) return number != 0 ? 0.0 : 1.0;
    if (info.kind == Kind::choice) return number > 0 ? number - 1 : number + 1;
    if (info.kind == Kind::count) return number < info.range.high ? number + 1 : number - 1;
    const double low = info.range.softLow, high = info.range.softHigh;
    return number < 0.5 * (low + high) ? number + 0.3 * (high - number) : number - 0.3 * (number - low);
}

FrameRequest requestOf(const Museum& museum, const SceneState& state, std::size_t subject)
{
    FrameRequest request;
    request.camera = museum.exhibit(subject).bestView(state.values[subject]);  // Alone, it stands at the origin.
    request.raster.size = {960, 540};
    request.alone = subject;
    request.finished = true;
    return request;
}

/// Returns the one pass that draws the exhibit. Throws Failure if there are several, or if it reads pictures or buffers
/// that the text cannot leave out.
const render::Pass& drawingPass(const render::FramePlan& plan, const SceneObject& exhibit)
{
    const std::string prefix = std::string(exhibit.name()) + '/';
    const render::Pass* found = nullptr;
    const Message title = Message::ofTable(exhibit.title());
    for (const render::Pass& pass : plan.passes()) {
        if (!pass.name.starts_with(prefix)) continue;
        if (found || pass.shader.fragment.empty())
            refuseExhibit(message(
                "{1} cannot stand alone: its picture is made by several passes that depend on each other.", title));
        found = &pass;
    }
    if (!found) refuseExhibit(message("{1} cannot stand alone: nothing of it is drawn with these settings.", title));
    const bool isPortal = found->shader.vertex == "kit/portal/portal.vert";
    if (!isPortal || found->draws.size() != 1)
        refuseExhibit(message(
            "{1} cannot stand alone: it is made of meshes, and a shader of your own draws one rectangle.", title));
    return *found;
}

/// Generates the text of the ISF.
class AloneWriter {
public:
    /// `isTrial`: only whether it can be written matters, so that parameters need not be tried one by one.
    AloneWriter(const AlonePicture& picture, std::vector<Message>& notes, bool isTrial = false)
        : picture_(picture), notes_(notes), isTrial_(isTrial)
    {
        load();
        readStructs();
    }

    std::string write()
    {
        std::string body;
        for (const GlslItem& item : items_) body += textOf(item);
        chooseNames();
        const std::string set = blockLines(*picture_.pass) + frameLines() + parameterLines() + numberLines();
        if (anyFixed_)
            notes_.push_back(message("Parameters from which further numbers are computed stay as they are now."));
        Json head{{"ISFVSN", "2"}};
        head["DESCRIPTION"] = std::string(picture_.exhibit().title()) + ", as Vitrine draws it.";
        head["CATEGORIES"] = {"Generator"};
        head["INPUTS"] = inputs_;
        std::string json = render::writeJson(head);
        while (json.back() == '\n') json.pop_back();
        const std::string main = "\nvoid setNumbers()\n{\n" + set + "}\n\nvoid main()\n{\n    setNumbers();\n    " +
                                 exportedMain + "();\n    gl_FragColor = vec4(exportedLight(radiance), 1.0);\n}\n";
        const std::string text = compact(body + picture_.numbers.functions + colorFunction() + main);
        return "/*" + json + "*/\n\n" + versionLine(text) + text;
    }

private:
    void load();
    void readStructs();
    [[nodiscard]] std::string textOf(const GlslItem&);
    [[nodiscard]] std::string blockText(const GlslItem&);
    void chooseNames();
    [[nodiscard]] std::string blockLines(const render::Pass&) const;
    [[nodiscard]] bool isRead(std::size_t row) const;
    [[nodiscard]] bool changesOthers(std::size_t row) const;
    [[nodiscard]] std::string frameLines();
    [[nodiscard]] std::string parameterLines();
    [[nodiscard]] std::string numberLines();
    [[nodiscard]] std::string rowInput(std::size_t row);
    Json& newInput(const std::string& name, const char* type, std::string_view label);
    void numberInput(const StandAloneNumbers::Input&);
    [[nodiscard]] std::string colorFunction() const;
    [[nodiscard]] static std::string compact(const std::string& text);
    [[nodiscard]] bool uses(const std::string& member) const { return members_.contains(member); }
    /// Returns a variable name that no item of the shader has: `name`, with underscores if necessary.
    [[nodiscard]] std::string freeName(std::string name) const
    {
        while (taken_.contains(name)) name += '_';
        return name;
    }

    const AlonePicture& picture_;
    std::vector<Message>& notes_;
    bool isTrial_;
    GlslMacros macros_;
    std::vector<GlslItem> items_;
    std::set<std::string> members_;     ///< Words behind a dot in the needed items.
    std::set<std::string> parameters_;  ///< Members of the parameter block that are read.
    std::set<std::string> taken_;
    BlockStructs structs_;
    /// Blocks by binding: prefix of their members, and these.
    struct Block {
        int binding = 0;
        std::string prefix;
        std::vector<BlockField> fields;
    };
    std::vector<Block> blocks_;
    Json inputs_ = Json::array();
    std::map<std::string, std::string> numberNames_;
    bool convertsColors_ = false;
    bool anyFixed_ = false;
};

void AloneWriter::load()
{
    static const render::ShaderSource source;
    const render::ShaderKey& key = picture_.pass->shader;
    std::map<std::string, std::string> texts;
    if (key.sources) texts = key.sources->textByPath();
    for (const auto& [path, text] : textsForPictures(*picture_.pass)) texts[path] = text;
    if (picture_.numbers.sources)
        for (const auto& [path, text] : picture_.numbers.sources->textByPath()) texts[path] = text;
    texts[rootFile] = "#include \"" + key.fragment + "\"\n#include \"your_shader/export.glsl\"\n";
    std::vector<std::string> defines = key.defines;
    for (const std::string& define : picture_.tone->shader.defines)
        if (define.starts_with("TONE_CURVE")) defines.push_back(define);
    const render::ShaderSources sources(std::move(texts));
    const render::ShaderText loaded = source.load(rootFile, defines, key.prelude, &sources);
    const std::string text = withoutConditions(loaded.text, macros_);
    items_ = neededItems(itemsOf(text), {"main", "exportedLight", "radiance"});
    for (const GlslItem& item : items_) {
        members_.insert(item.members.begin(), item.members.end());
        constexpr std::string_view prefix = "parameters.";
        for (const std::string& pair : item.pairs)
            if (pair.starts_with(prefix)) parameters_.insert(pair.substr(prefix.size()));
        if (!item.isMacro) taken_.insert(item.names.begin(), item.names.end());
    }
    taken_.insert({"TIME",   "RENDERSIZE", "DATE",   "setNumbers", "main",    "distance", "length", "mix",
                   "step",   "min",        "max",    "abs",        "sign",    "floor",    "fract",  "mod",
                   "clamp",  "dot",        "cross",  "normalize",  "reflect", "refract",  "pow",    "exp",
                   "log",    "sqrt",       "sin",    "cos",        "tan",     "texture",  "round",  "ceil",
                   "turned", "tilted",     "camera", "around",     "toSide",  "upwards",  "tangent"});
}

void AloneWriter::readStructs()
{
    std::map<std::string, std::string> fieldMacros;
    for (const GlslItem& item : items_) {
        if (item.isMacro && item.words.contains("FIELD")) fieldMacros[*item.names.begin()] = item.text;
        const bool isBlockStruct = !item.isMacro && item.words.contains("BLOCK_STRUCT");
        const std::string& name = item.names.empty() ? std::string() : *item.names.begin();
        if (isBlockStruct) {
            for (const auto& [macro, text] : fieldMacros)
                if (item.words.contains(macro)) structs_[name] = fieldsOfMacro(text, macros_);
        } else if (!item.isMacro && item.words.contains("struct")) {
            structs_.emplace(name, fieldsInBraces(item.text, macros_));
        }
    }
}

std::string AloneWriter::textOf(const GlslItem& item)
{
    if (item.isMacro) {
        const bool isBlockMacro = item.words.contains("FIELD") || item.words.contains("BLOCK_FIELD") ||
                                  item.names.contains("BLOCK_STRUCT") || item.names.contains("BLOCK_FIELD") ||
                                  item.names.contains("BLOCK_ARRAY");
        return isBlockMacro ? "" : item.text + '\n';
    }
    const Message title = Message::ofTable(picture_.exhibit().title());
    if (item.words.contains("BLOCK_STRUCT")) {
        const std::string& name = *item.names.begin();
        return structText(name, structs_[name], members_);
    }
    if (item.words.contains("uniform") || item.words.contains("buffer")) return blockText(item);
    if (item.words.contains("layout") && item.words.contains("in"))
        refuseExhibit(message("{1} cannot stand alone: it reads what its vertices hand over.", title));
    const bool isOutput = item.words.contains("layout") && item.words.contains("out");
    std::string code = item.text;
    if (isOutput) {
        constexpr std::string_view out = " out ";
        const std::size_t begin = code.find("layout"), end = code.find(out, begin);
        code.erase(begin, end + out.size() - begin);
    }
    const Code piece{{1, 1, code}};
    Shader shader;
    shader.form = Form::isf;  // Declarations of other forms are not looked for.
    return rewritten(shader, piece, {{"main", exportedMain}, {"gl_FragDepth", "depthOfPixel"}, {"precise", ""}});
}

/// Returns a block as variables. Throws Failure for pictures and buffers.
std::string AloneWriter::blockText(const GlslItem& item)
{
    const Message title = Message::ofTable(picture_.exhibit().title());
    if (item.words.contains("buffer"))
        refuseExhibit(message(
            "{1} cannot stand alone: it reads a buffer of numbers, which web pages and ISF do not have.", title));
    const std::size_t open = item.text.find('{'), close = item.text.rfind('}');
    if (open == std::string::npos)
        refuseExhibit(
            message("{1} cannot stand alone: it reads a picture that the program computes; choose settings without it.",
                    title));
    static const std::map<std::string, int> bindings{{"BLOCK_FRAME", BLOCK_FRAME},
                                                     {"BLOCK_PARAMETERS", BLOCK_PARAMETERS},
                                                     {"BLOCK_EXHIBIT", BLOCK_EXHIBIT},
                                                     {"BLOCK_OBJECT", BLOCK_OBJECT},
                                                     {"BLOCK_LIGHT", BLOCK_LIGHT}};
    Block block{-1, "", fieldsInBraces(item.text, macros_)};
    for (const auto& [word, binding] : bindings)
        if (item.words.contains(word) ||
            item.text.find("binding = " + std::to_string(binding) + ')') != std::string::npos)
            block.binding = binding;
    std::string instance;
    for (const char c : item.text.substr(close + 1)) {
        if (c == ';') break;
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') instance += c;
    }
    std::string text;
    const std::size_t line = item.text.rfind("layout", open);
    text += item.text.substr(0, line == std::string::npos ? 0 : line);  // Its comments.
    if (!instance.empty()) {
        block.prefix = instance + '.';
        const bool isTable = instance == "parameters";
        const std::string type = isTable ? "Parameters" : "Block_" + instance;
        text += structText(type, block.fields, isTable ? parameters_ : members_) + type + ' ' + instance + ";\n";
    } else {
        for (const BlockField& field : block.fields)
            text += field.type + ' ' + field.name +
                    (field.count > 0 ? '[' + std::to_string(field.count) + ']' : std::string()) + ";\n";
    }
    blocks_.push_back(std::move(block));
    return text;
}

void AloneWriter::chooseNames()
{
    for (const StandAloneNumbers::Input& input : picture_.numbers.inputs) {
        StandAloneNumbers::Input named = input;
        named.name = numberNames_[input.name] = freeName(input.name);
        taken_.insert(named.name);
        numberInput(named);
    }
}

std::string AloneWriter::blockLines(const render::Pass& pass) const
{
    std::set<std::string> used = members_;
    for (const Block& block : blocks_)
        if (block.prefix.empty())
            for (const BlockField& field : block.fields) used.insert(field.name);
    const BlockConstants constants(structs_, used);
    std::string lines;
    for (const Block& block : blocks_) {
        std::set<std::string> without = picture_.numbers.assigned;
        if (block.binding == BLOCK_FRAME || block.binding == BLOCK_PARAMETERS) continue;
        const render::Bytes* bytes = nullptr;
        if (block.binding == BLOCK_OBJECT)
            bytes = &pass.draws.front().object;
        else if (const auto found = pass.blocks.find(block.binding); found != pass.blocks.end())
            bytes = &found->second;
        if (bytes) lines += constants.lines(block.fields, *bytes, block.prefix, without);
    }
    return lines;
}

/// Returns the assignments of the camera and the picture, and adds the inputs of an orbit.
std::string AloneWriter::frameLines()
{
    const render::View& view = picture_.plan.view;
    const glm::dmat3 axes(glm::affineInverse(view.viewFromWorld));
    const auto vector = [](const glm::dvec3& v) {
        return "vec3(" + floatText(static_cast<float>(v.x)) + ", " + floatText(static_cast<float>(v.y)) + ", " +
               floatText(static_cast<float>(v.z)) + ')';
    };
    const std::string turn = freeName("orbit"), tilt = freeName("tilt"), away = freeName("nearness");
    const double pi = 3.14159265358979323846;
    numberInput({turn, "Orbit", Unit::degree, 0, -pi, pi});
    numberInput({tilt, "Tilt", Unit::degree, 0, -pi / 3, pi / 3});
    numberInput({away, "Distance", Unit::none, 1, 0.25, 3});
    const double pivot = picture_.numbers.pivotDistance.value_or(2.0);
    std::string text =
        "    // The camera, around a point " + floatText(static_cast<float>(pivot)) + " m in front of it.\n";
    text += "    float turned = radians(" + turn + "), tilted = radians(" + tilt + ");\n";
    text += "    mat3 camera = mat3(" + vector(axes[0]) + ", " + vector(axes[1]) + ", " + vector(axes[2]) + ");\n";
    text += "    vec3 around = " + vector(view.eye - axes[2] * pivot) + ";\n";
    text += "    mat3 toSide = mat3(cos(turned), 0.0, -sin(turned), 0.0, 1.0, 0.0, sin(turned), 0.0, cos(turned));\n";
    text += "    mat3 upwards = mat3(1.0, 0.0, 0.0, 0.0, cos(tilted), -sin(tilted), 0.0, sin(tilted), cos(tilted));\n";
    text += "    camera = toSide * camera * upwards;\n";
    text += "    float tangent = " + floatText(static_cast<float>(view.tanHalfFov.y)) + ";\n";
    const std::map<std::string, std::string> values{
        {"eye", "around + camera[2] * (" + floatText(static_cast<float>(pivot)) + " * " + away + ")"},
        {"worldFromView", "mat4(vec4(camera[0], 0.0), vec4(camera[1], 0.0), vec4(camera[2], 0.0), vec4(around, 1.0))"},
        {"nearPlane", floatText(static_cast<float>(view.nearPlane))},
        {"size", "RENDERSIZE"},
        {"inverseSize", "1.0 / RENDERSIZE"},
        {"tileOrigin", "vec2(0.0)"},
        {"tanHalfFov", "vec2(tangent * RENDERSIZE.x / RENDERSIZE.y, tangent)"},
        {"tanShift", "vec2(0.0)"},
        {"time", "TIME"},
        {"sampleIndex", "0"},
        {"seed", "1u"},
        {"pixelAngle", "2.0 * tangent / RENDERSIZE.y"}};
    const auto block = structs_.find("FrameBlock");
    if (block == structs_.end()) return text;
    for (const BlockField& field : block->second) {
        if (!uses(field.name)) continue;
        const auto value = values.find(field.name);
        if (value != values.end()) text += "    frame." + field.name + " = " + value->second + ";\n";
    }
    return text;
}

/// Returns whether the shader reads a parameter that has an effect.
bool AloneWriter::isRead(std::size_t row) const
{
    const ParameterInfo& info = picture_.values().rows()[row];
    if (!parameters_.contains(std::string(info.name)) || !acts(picture_.values(), row)) return false;
    return info.kind == Kind::real || info.kind == Kind::count || info.kind == Kind::toggle ||
           info.kind == Kind::color || info.kind == Kind::choice;
}

/// Returns whether numbers or pictures of the shader are computed from a parameter, so that it cannot be an input.
bool AloneWriter::changesOthers(std::size_t row) const
{
    SceneState state = picture_.state;
    ParameterValues& values = state.values[picture_.subject];
    values.setParameter(row, otherValue(values.rows()[row], values.row(row)));
    try {
        const AlonePicture other = alonePicture(picture_.museum, state, picture_.subject);
        return other.pass->shader.defines != picture_.pass->shader.defines ||
               other.numbers.assignments != picture_.numbers.assignments ||
               textsForPictures(*other.pass) != textsForPictures(*picture_.pass) ||
               blockLines(*other.pass) != blockLines(*picture_.pass);
    } catch (const Failure&) {
        return true;  // With another value it cannot stand alone.
    }
}

Json& AloneWriter::newInput(const std::string& name, const char* type, std::string_view label)
{
    inputs_.push_back(Json{{"NAME", name}, {"LABEL", std::string(label)}, {"TYPE", type}});
    return inputs_.back();
}

void AloneWriter::numberInput(const StandAloneNumbers::Input& input)
{
    const auto& [name, label, unit, initial, low, high, exact] = input;
    static const std::map<Unit, std::string> units{
        {Unit::degree, "deg"}, {Unit::second, "s"}, {Unit::meter, "m"}, {Unit::percent, "%"}};
    Json& json = newInput(name, "float", label);
    const auto known = units.find(unit);
    const auto inUnit = [&](double x) { return known == units.end() ? x : shown(x, input.unit); };
    json["MIN"] = inUnit(std::min(low, initial));
    json["MAX"] = inUnit(std::max(high, initial));
    json["DEFAULT"] = inUnit(initial);
    if (exact) json["EXACT"] = inUnit(*exact);
    if (known != units.end()) json["UNIT"] = known->second;
}

/// Returns the value of a unit in SI, as a factor behind a variable: " * 0.0174533".
std::string factorOf(Unit unit)
{
    const double perStored = info(unit).shownPerStored;
    const bool isKnown = unit == Unit::degree || unit == Unit::percent;
    return isKnown && perStored != 1 ? " * " + floatText(static_cast<float>(1 / perStored)) : "";
}

/// Adds the input of a parameter and returns its value in SI.
std::string AloneWriter::rowInput(std::size_t row)
{
    const ParameterInfo& info = picture_.values().rows()[row];
    const std::string name = freeName(std::string(info.name)), title = label(info);
    const double* number = std::get_if<double>(&picture_.values().row(row));
    switch (info.kind) {
    case Kind::toggle: newInput(name, "bool", title)["DEFAULT"] = *number != 0; return name;
    case Kind::color: {
        const glm::dvec3 linear = std::get<glm::dvec3>(picture_.values().row(row));
        Json& json = newInput(name, "color", title);
        for (int i = 0; i < 3; ++i) json["DEFAULT"].push_back(render::srgbFromLinear(linear[i]));
        json["DEFAULT"].push_back(1.0);
        convertsColors_ = true;
        return "exportedLinear(" + name + ".rgb)";
    }
    case Kind::choice: {
        Json& json = newInput(name, "long", title);
        for (std::size_t i = 0; i < info.choices.size(); ++i) {
            json["VALUES"].push_back(i);
            json["LABELS"].push_back(std::string(info.choices[i]));
        }
        json["DEFAULT"] = static_cast<int>(*number);
        return name;
    }
    case Kind::count: {
        Json& json = newInput(name, "long", title);
        json["MIN"] = static_cast<int>(std::min(info.range.softLow, *number));
        json["MAX"] = static_cast<int>(std::max(info.range.softHigh, *number));
        json["DEFAULT"] = static_cast<int>(*number);
        if (info.qualityReference) json["EXACT"] = static_cast<int>(*info.qualityReference);
        return name;
    }
    default: break;
    }
    numberInput(
        {name, std::string(title), info.unit, *number, info.range.softLow, info.range.softHigh, info.qualityReference});
    return name + factorOf(info.unit);
}

std::string AloneWriter::parameterLines()
{
    std::string text;
    for (const Block& block : blocks_) {
        if (block.binding != BLOCK_PARAMETERS) continue;
        const auto found = picture_.pass->blocks.find(BLOCK_PARAMETERS);
        std::set<std::string> inputs;
        std::string lines;
        for (std::size_t row = 0; row < picture_.values().rows().size(); ++row) {
            if (!isRead(row)) continue;
            if (!isTrial_ && changesOthers(row)) {
                anyFixed_ = true;
                continue;
            }
            const std::string member = block.prefix + std::string(picture_.values().rows()[row].name);
            inputs.insert(member);
            lines += "    " + member + " = " + rowInput(row) + ";\n";
        }
        const BlockConstants constants(structs_, parameters_);
        if (found != picture_.pass->blocks.end())
            text += constants.lines(block.fields, found->second, block.prefix, inputs);
        text += lines;
    }
    return text;
}

std::string AloneWriter::numberLines()
{
    std::string text = picture_.numbers.assignments;
    for (const StandAloneNumbers::Input& input : picture_.numbers.inputs) {
        const std::string marked = '@' + input.name + '@';
        const std::string factor = factorOf(input.unit);
        const std::string value =
            factor.empty() ? numberNames_[input.name] : '(' + numberNames_[input.name] + factor + ')';
        for (std::size_t at = 0; (at = text.find(marked, at)) != std::string::npos; at += value.size())
            text.replace(at, marked.size(), value);
    }
    return text;
}

std::string AloneWriter::colorFunction() const
{
    if (!convertsColors_) return "";
    return "\n// Colors of inputs are display values.\nvec3 exportedLinear(vec3 c)\n{\n    return mix(pow((c + 0.055) "
           "/ 1.055, "
           "vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));\n}\n";
}

/// Returns the text without more than one empty line in a row.
std::string AloneWriter::compact(const std::string& text)
{
    std::string out;
    std::size_t newlines = 2;
    for (const char c : text) {
        newlines = c == '\n' ? newlines + 1 : 0;
        if (newlines <= 2) out += c;
    }
    if (out.find("depthOfPixel") != std::string::npos) out.insert(0, "float depthOfPixel;\n");
    return out;
}

/// Returns the picture of an exhibit alone, with what can be computed elsewhere.
AlonePicture alonePicture(const Museum& museum, SceneState state, std::size_t subject)
{
    const SceneObject& exhibit = museum.subject(subject);
    if (subject == hallIndex) refuseExhibit(message("The hall is drawn by many passes; visit an exhibit first."));
    const auto* alone = capability<StandsAlone>(exhibit);
    if (alone) state.values[subject] = alone->standAloneValues(state.values[subject]);
    const FrameRequest request = requestOf(museum, state, subject);
    render::FramePlan plan = museum.plan(museum.prepare(state, request), request);
    AlonePicture picture{museum, std::move(state), subject, std::move(plan)};
    picture.pass = &drawingPass(picture.plan, exhibit);
    picture.tone = picture.plan.find(tonePass);
    if (!picture.tone)
        refuseExhibit(message("{1} cannot stand alone: its picture is not toned.", Message::ofTable(exhibit.title())));
    if (alone) picture.numbers = alone->standAloneNumbers(picture.values());
    for (const std::string& define : picture.tone->shader.defines)
        if (define == "GLARE") picture.numbers.notes.push_back(message("Halos around bright lights are left out."));
    return picture;
}

}  // namespace

std::string standAloneText(const Museum& museum, const SceneState& state, std::size_t subject,
                           std::vector<Message>& notes)
{
    const AlonePicture picture = alonePicture(museum, state, subject);
    notes.insert(notes.end(), picture.numbers.notes.begin(), picture.numbers.notes.end());
    return AloneWriter(picture, notes).write();
}

ExportedShader standAloneShader(const Museum& museum, const SceneState& state, std::size_t subject)
{
    std::vector<Message> notes;
    const std::string text = standAloneText(museum, state, subject, notes);
    const std::string name(museum.subject(subject).name());
    const ReadShader read = readShaderText(text, name + ".fs");
    if (!read.shader) {
        const Finding& first = read.errors.front();
        throw Failure(ErrorKind::shader,
                      message("{1}:{2}:{3}: {4}", first.file, first.line, first.column, first.sentence));
    }
    ExportedShader exported{.shader = *read.shader, .path = name + ".fs", .ofInputs = {}, .start = {}};
    exported.shader.title = museum.subject(subject).title();
    exported.ofInputs.resize(exported.shader.inputs.size());
    exported.notes = std::move(notes);
    return exported;
}

Message whyNotAlone(const Museum& museum, const SceneState& state, std::size_t subject)
{
    try {
        std::vector<Message> notes;
        static_cast<void>(AloneWriter(alonePicture(museum, state, subject), notes, true).write());
        return {};
    } catch (const Failure& failure) {
        return failure.message();
    }
}

}  // namespace vitrine::guest
