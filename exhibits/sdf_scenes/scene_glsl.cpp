#include "exhibits/sdf_scenes/scene_glsl.h"

#include "exhibits/sdf_scenes/glsl_expression.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

namespace vitrine::scenes {
namespace {

/// Writes one function after another. Numbers are read from the block, or folded as constants.
class GlslWriter {
public:
    /// `steady`: marks the numbers that are folded, although the block contains all of them. Empty: none.
    GlslWriter(const SceneProgram& program, const SceneConstants& folded, const std::vector<char>& steady,
               const FurtherMember& further)
        : program_(program), folded_(folded), steady_(steady), further_(further)
    {
    }

    std::string write()
    {
        std::string all = head();
        all += "\nfloat fieldDistance(vec3 p)\n{\n" + body(false) + "}\n";
        all += "\nSceneSurface sceneSurface(vec3 p)\n{\n" + body(true) + "}\n";
        return all;
    }

private:
    [[nodiscard]] std::string head() const;
    [[nodiscard]] bool hasOneMaterial() const;
    std::string body(bool withMaterials);
    void writeStep(const Step&, bool withMaterials);
    void writeEnter(std::uint32_t index, bool withMaterials);
    void writeAgain(const Step&, bool withMaterials);
    void line(const std::string& text) { text_ += std::string(4 * depth_, ' ') + text + '\n'; }

    [[nodiscard]] bool isFolded(std::uint32_t word) const { return !steady_.empty() && steady_[word] != 0; }
    [[nodiscard]] std::string word(std::uint32_t at) const;
    [[nodiscard]] std::string vector(std::uint32_t at) const;
    [[nodiscard]] std::string material(std::uint32_t index) const;
    [[nodiscard]] std::string call(std::string_view expression, const ProgramNode&, const ExpressionNames& names) const;
    [[nodiscard]] std::string number(const ProgramNode&, std::uint32_t i) const;

    static std::string named(char letter, std::uint32_t node) { return letter + std::to_string(node); }
    /// Returns the name of the point at which the children of a node are evaluated.
    [[nodiscard]] std::string askedAt(std::uint32_t node) const
    {
        const NodeKind& kind = program_.kind(program_.nodes()[node]);
        return named(kind.place || kind.copy ? 'q' : 'p', node);
    }

    const SceneProgram& program_;
    const SceneConstants& folded_;
    const std::vector<char>& steady_;
    const FurtherMember& further_;
    std::string text_;
    std::size_t depth_ = 1;
};

std::string GlslWriter::head() const
{
    bool shapes = false;
    bool noise = false;
    for (const ProgramNode& node : program_.nodes()) {
        const NodeKind& kind = program_.kind(node);
        noise = noise || isNoise(kind);
        shapes = shapes || (!isNoise(kind) && kind.distance.glsl.starts_with("scene"));
    }
    std::string text = "// Made from a scene file.\n#include \"lib/bindings.glsl\"\n#include \"lib/numerics.glsl\"\n"
                       "#include \"lib/sdf.glsl\"\n#include \"lib/sdf_operators.glsl\"\n"
                       "#include \"sdf_scenes/operators.glsl\"\n#include \"sdf_scenes/material.glsl\"\n"
                       "#include \"sdf_scenes/primitive_evaluations.glsl\"\n";
    if (shapes) text += "#include \"sdf_scenes/shapes.glsl\"\n";
    if (noise) text += "#include \"sdf_scenes/noise.glsl\"\n";
    if (!further_.file.empty()) text += "#include \"" + further_.file + "\"\n";
    std::string members;
    if (isInBuffer(program_))
        text += "\nlayout(std430, binding = STORAGE_EXHIBIT_A) readonly buffer SceneValues {\n    vec4 "
                "sceneValues[];\n};\n";
    else if (program_.wordCount() > 0)
        members = "    vec4 sceneValues[" + std::to_string((program_.wordCount() + 3) / 4) + "];\n";
    if (!further_.declaration.empty()) members += "    " + further_.declaration + ";\n";
    if (members.empty()) return text;
    return text + "\nlayout(std140, binding = BLOCK_EXHIBIT) uniform Scene {\n" + members + "};\n";
}

std::string GlslWriter::word(std::uint32_t at) const
{
    if (isFolded(at)) return floatLiteral(folded_.words[at]);
    return "sceneValues[" + std::to_string(at / 4) + "]." + "xyzw"[at % 4];
}

std::string GlslWriter::vector(std::uint32_t at) const
{
    return "vec3(" + word(at) + ", " + word(at + 1) + ", " + word(at + 2) + ')';
}

std::string GlslWriter::material(std::uint32_t index) const
{
    const std::uint32_t first = program_.materialWord(index);
    std::string text = "sceneMaterial(";
    for (std::uint32_t i = 0; i < wordsOfMaterial; i += 4) {
        const std::uint32_t at = first + i;
        text += i > 0 ? ", " : "";
        if (isFolded(at))
            text += "vec4(" + word(at) + ", " + word(at + 1) + ", " + word(at + 2) + ", " + word(at + 3) + ')';
        else
            text += "sceneValues[" + std::to_string(at / 4) + ']';
    }
    return text + ')';
}

/// Returns the text of a node's number. A choice is always a constant, because it selects code.
std::string GlslWriter::number(const ProgramNode& node, std::uint32_t i) const
{
    const Node& of = program_.scene().nodes[node.node];
    std::uint32_t at = 0;
    for (const Field& field : of.kind->fields) {
        if (at == i && field.type == FieldType::choice)
            return floatLiteral(program_.scene().numbers[of.numbers + i].value);
        at += static_cast<std::uint32_t>(numbersOf(field.type));
    }
    return word(node.numbers + i);
}

/// Returns an expression of a node kind with its names and numbers replaced.
std::string GlslWriter::call(std::string_view expression, const ProgramNode& node, const ExpressionNames& names) const
{
    return writtenOut(expression, names, [&](std::uint32_t i) { return number(node, i); });
}

bool GlslWriter::hasOneMaterial() const
{
    std::uint32_t first = noIndex;
    for (const ProgramNode& node : program_.nodes()) {
        if (program_.kind(node).form != Form::shape) continue;
        if (first != noIndex && node.material != first) return false;
        first = node.material;
    }
    return true;
}

std::string GlslWriter::body(bool withMaterials)
{
    text_.clear();
    depth_ = 1;
    if (program_.nodes().empty()) {
        line(withMaterials ? "return SceneSurface(1.0e9, sceneMaterial(vec4(0.0), vec4(0.0), vec4(1.0), vec4(0.0)));"
                           : "return 1.0e9;");
        return text_;
    }
    if (withMaterials && hasOneMaterial()) {
        const auto shape = std::find_if(program_.nodes().begin(), program_.nodes().end(), [&](const ProgramNode& node) {
            return program_.kind(node).form == Form::shape;
        });
        line("return SceneSurface(fieldDistance(p), " + material(shape->material) + ");");
        return text_;
    }
    for (const Step& step : program_.steps()) writeStep(step, withMaterials);
    line(withMaterials ? "return SceneSurface(d0, m0);" : "return d0;");
    return text_;
}

void GlslWriter::writeEnter(std::uint32_t index, bool withMaterials)
{
    const ProgramNode& node = program_.nodes()[index];
    const NodeKind& kind = program_.kind(node);
    const std::string own = named('p', index);
    std::string from = node.parent == noIndex ? "p" : askedAt(node.parent);
    if (node.translate != noIndex) from = '(' + from + " - " + vector(node.translate) + ')';
    if (node.rotate != noIndex)
        from = "sceneTurned(" + from + ", " + vector(node.rotate) + ", " + vector(node.rotate + 3) + ", " +
               vector(node.rotate + 6) + ')';
    if (node.scale != noIndex) from += " * " + vector(node.scale);
    line("vec3 " + own + " = " + from + ';');
    if (kind.place) line("vec3 " + named('q', index) + " = " + call(kind.place.glsl, node, {{"p", own}}) + ';');
    if (kind.form != Form::repeater) return;
    const std::uint32_t times = node.numbers + static_cast<std::uint32_t>(kind.numbers()) + 3;
    const std::string i = named('i', index);
    line("float " + named('d', index) + " = 1.0e9;");
    if (withMaterials)
        line("SceneMaterial " + named('m', index) + " = sceneMaterial(vec4(0.0), vec4(0.0), vec4(1.0), vec4(0.0));");
    line("for (int " + i + " = 0; " + i + " < int(" + word(times) + ") * int(" + word(times + 1) + ") * int(" +
         word(times + 2) + "); ++" + i + ") {");
    ++depth_;
    line("vec3 " + named('q', index) + " = " + call(kind.copy.glsl, node, {{"p", own}, {"i", i}}) + ';');
}

void GlslWriter::writeAgain(const Step& step, bool withMaterials)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const std::uint32_t cap = node.numbers + static_cast<std::uint32_t>(program_.kind(node).numbers()) + 6;
    const std::string d = named('d', step.node);
    const std::string c = named('c', step.node);
    line("float " + c + " = sceneCapped(" + named('d', step.child) + ", " + named('q', step.node) + ", " + word(cap) +
         ", " + vector(cap + 1) + ", " + vector(cap + 4) + ");");
    if (withMaterials)
        line("if (" + c + " < " + d + " || " + named('i', step.node) + " == 0) " + named('m', step.node) + " = " +
             named('m', step.child) + ';');
    line(d + " = min(" + d + ", " + c + ");");
    --depth_;
    line("}");
    line(d + " = sceneBeyond(" + d + ", " + named('p', step.node) + ", " + word(cap) + ", " + vector(cap + 7) + ", " +
         vector(cap + 10) + ");");
}

void GlslWriter::writeStep(const Step& step, bool withMaterials)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = program_.kind(node);
    const std::string d = named('d', step.node);
    const std::string m = named('m', step.node);
    const std::string childD = named('d', step.child);
    const std::string childM = named('m', step.child);
    const auto inherit = [&] {
        if (withMaterials) line("SceneMaterial " + m + " = " + childM + ';');
    };
    switch (step.type) {
    case Step::Type::enter: writeEnter(step.node, withMaterials); break;
    case Step::Type::shape:
        line("float " + d + " = " + call(kind.distance.glsl, node, {{"p", named('p', step.node)}}) + ';');
        line("COUNT_EVALUATION(true)");
        if (withMaterials) line("SceneMaterial " + m + " = " + material(node.material) + ';');
        break;
    case Step::Type::first:
        line("float " + d + " = " + childD + ';');
        inherit();
        break;
    case Step::Type::combine: {
        const ExpressionNames names{{"a", d}, {"b", childD}};
        if (withMaterials)
            line(m + " = sceneBlend(" + m + ", " + childM + ", " + call(kind.share.glsl, node, names) + ");");
        line(d + " = " + call(kind.combine.glsl, node, names) + ';');
        break;
    }
    case Step::Type::modify:
        line("float " + d + " = " +
             (kind.after ? call(kind.after.glsl, node, {{"d", childD}, {"p", named('p', step.node)}}) : childD) + ';');
        inherit();
        break;
    case Step::Type::again: writeAgain(step, withMaterials); break;
    case Step::Type::leave:
        if (node.scale != noIndex) line(d + " = sdfScaled(" + d + ", " + word(node.scale + 3) + ");");
        break;
    }
}

}  // namespace

bool isNoise(const NodeKind& kind)
{
    return kind.distance.glsl.starts_with("sceneNoise") || kind.after.glsl.starts_with("sceneDisplaced");
}

bool isInBuffer(const SceneProgram& program)
{
    // A block of 64 KiB is supported by every driver; the stage needs some of it.
    constexpr std::size_t mostWords = 14'000;
    return program.wordCount() > mostWords;
}

std::string sceneGlsl(const SceneProgram& program, const FurtherMember& further)
{
    return GlslWriter(program, {}, {}, further).write();
}

std::string restingSceneGlsl(const SceneProgram& program, const SceneConstants& words, const std::vector<char>& steady,
                             const FurtherMember& further)
{
    return GlslWriter(program, words, steady, further).write();
}

std::shared_ptr<const render::ShaderSources> generatedSources(std::string glsl)
{
    return std::make_shared<const render::ShaderSources>(
        std::map<std::string, std::string>{{generatedField, std::move(glsl)}});
}

std::vector<std::byte> sceneBlock(const SceneConstants& words)
{
    std::vector<float> values((words.words.size() + 3) / 4 * 4, 0.0F);
    std::transform(words.words.begin(), words.words.end(), values.begin(),
                   [](double x) { return static_cast<float>(x); });
    std::vector<std::byte> bytes(values.size() * sizeof(float));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

}  // namespace vitrine::scenes
