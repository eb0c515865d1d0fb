#include "exhibits/sdf_scenes/list_glsl.h"

#include "exhibits/sdf_scenes/glsl_expression.h"

#include <algorithm>

namespace vitrine::scenes {
namespace {

std::string numbered(const char* letter, std::uint32_t i)
{
    return letter + std::to_string(i);
}

/// GLSL generator. Stack levels are registers that are shifted, not arrays: SIMD processors without a stack cannot
/// index arrays.
class ListGlsl {
public:
    explicit ListGlsl(const ListVocabulary& vocabulary) : v_(vocabulary) {}

    std::string walk(bool withMaterials)
    {
        text_.clear();
        materials_ = withMaterials;
        line(1, withMaterials ? "SceneSurface sceneListed(vec3 point, uint first, bool near)\n{"
                              : "float sceneListed(vec3 point, uint first, bool near)\n{");
        text_ = text_.substr(4);
        registers();
        line(1, "uint i = first;");
        line(1, "bool more = true;");
        line(1, "do {");
        line(2, "uvec4 code = sceneStep(i);");
        line(2, "uint operation = code.x & 255u;");
        line(2, "uint joint = code.x >> 8u & 255u;");
        line(2, "vec4 row0 = sceneRecord(code.y);");
        line(2, "vec4 row1 = sceneRecord(code.y + 1u);");
        line(2, "vec4 row2 = sceneRecord(code.y + 2u);");
        line(2, "vec4 n0 = sceneRecord(code.y + 3u);");
        line(2, "vec4 n1 = sceneRecord(code.y + 4u);");
        line(2, "vec3 p = vec3(dot(row0.xyz, q0) + row0.w, dot(row1.xyz, q0) + row1.w, dot(row2.xyz, q0) + row2.w);");
        line(2, "more = near && code.x >= " + std::to_string(moreSteps) + "u;");
        line(2, "i += 1u;");
        folds();
        shapes();
        levels();
        for (std::uint32_t k = 0; k < v_.spaces.size(); ++k) space(k);
        joints();
        line(1, "} while (more);");
        line(1, withMaterials ? "return SceneSurface(d0, m0);" : "return d0;");
        return text_ + "}\n";
    }

private:
    void line(int depth, const std::string& text)
    {
        text_ += std::string(4 * static_cast<std::size_t>(depth), ' ') + text + '\n';
    }
    [[nodiscard]] std::uint32_t shapeCount() const { return static_cast<std::uint32_t>(v_.shapes.size()); }
    [[nodiscard]] bool repeats() const
    {
        return std::any_of(v_.spaces.begin(), v_.spaces.end(), [](const NodeKind* k) { return bool(k->copy); });
    }
    [[nodiscard]] std::string ifOperation(ListOp operation, std::uint32_t more = 0) const
    {
        return "if (operation == " + std::to_string(shapeCount() + static_cast<std::uint32_t>(operation) + more) +
               "u) {";
    }
    /// Returns a number of the step's node: it follows the factor of its distances.
    static std::string number(std::uint32_t i)
    {
        const std::uint32_t at = i + 1;
        const std::string component = std::string(".") + "xyzw"[at % 4];
        if (at < 8) return numbered("n", at / 4) + component;
        return "sceneRecord(code.y + " + std::to_string(3 + at / 4) + "u)" + component;
    }
    static std::string vector(std::uint32_t i)
    {
        return "vec3(" + number(i) + ", " + number(i + 1) + ", " + number(i + 2) + ')';
    }

    void registers();
    void folds();
    void shapes();
    void levels();
    void pushResult();
    void popResult();
    void pushPlace();
    void popPlace();
    void space(std::uint32_t k);
    void again(const NodeKind& kind);
    void joints();

    const ListVocabulary& v_;
    std::string text_;
    bool materials_ = false;
};

void ListGlsl::registers()
{
    for (std::uint32_t k = 0; k <= v_.results; ++k) {
        line(1, "float " + numbered("d", k) + " = 1.0e9;");
        if (materials_)
            line(1,
                 "SceneMaterial " + numbered("m", k) + " = sceneMaterial(vec4(0.0), vec4(0.0), vec4(1.0), vec4(0.0));");
    }
    // For each level: the point where children are evaluated, the point in the space itself, the nearest copy so far
    // and its index.
    for (std::uint32_t k = 0; k <= v_.places; ++k) {
        line(1, "vec3 " + numbered("q", k) + " = point;");
        if (v_.places == 0) break;
        line(1, "vec3 " + numbered("o", k) + " = point;");
        if (!repeats()) continue;
        line(1, "float " + numbered("best", k) + " = 1.0e9;");
        line(1, "int " + numbered("copy", k) + " = 0;");
        if (materials_) line(1, "SceneMaterial " + numbered("kept", k) + " = m0;");
    }
}

/// Writes the folding of the point into the copy of a shape that is nearest.
void ListGlsl::folds()
{
    for (std::uint32_t k = 0; k < v_.folds.size(); ++k) {
        const NodeKind& kind = *v_.folds[k];
        const auto number = [before = foldedRecords(kind)](std::uint32_t i) {
            return "sceneRecord(code.y - " + std::to_string(before - i / 4) + "u)." + "xyzw"[i % 4];
        };
        line(2, "if ((code.x >> 16u & 15u) == " + std::to_string(k + 1) +
                    "u) p = " + writtenOut(kind.copy.glsl, {{"i", "0"}}, number) + ';');
    }
}

void ListGlsl::shapes()
{
    line(2, "float d = 0.0;");
    if (materials_) line(2, "SceneMaterial m = m0;");
    for (std::uint32_t k = 0; k < shapeCount(); ++k)
        line(2, (k > 0 ? "else if (operation == " : "if (operation == ") + std::to_string(k) +
                    "u) d = " + writtenOut(v_.shapes[k]->distance.glsl, {}, number) + ';');
    line(2, "d *= n0.x;");
    line(2, "COUNT_EVALUATION(near && operation < " + std::to_string(shapeCount()) + "u)");
    if (!materials_) return;
    line(2, "if (operation < " + std::to_string(shapeCount()) +
                "u) m = sceneMaterial(sceneRecord(code.w), sceneRecord(code.w + 1u), sceneRecord(code.w + 2u), "
                "sceneRecord(code.w + 3u));");
}

void ListGlsl::pushResult()
{
    for (std::uint32_t k = v_.results; k > 0; --k) {
        line(3, numbered("d", k) + " = " + numbered("d", k - 1) + ';');
        if (materials_) line(3, numbered("m", k) + " = " + numbered("m", k - 1) + ';');
    }
}

void ListGlsl::popResult()
{
    line(3, "d = d0;");
    if (materials_) line(3, "m = m0;");
    for (std::uint32_t k = 0; k < v_.results; ++k) {
        line(3, numbered("d", k) + " = " + numbered("d", k + 1) + ';');
        if (materials_) line(3, numbered("m", k) + " = " + numbered("m", k + 1) + ';');
    }
}

void ListGlsl::pushPlace()
{
    for (std::uint32_t k = v_.places; k > 0; --k)
        for (const char* letter : {"q", "o", "best", "copy", "kept"}) {
            const bool ofCopies = letter[0] == 'b' || letter[0] == 'c' || letter[0] == 'k';
            if ((ofCopies && !repeats()) || (letter[0] == 'k' && !materials_)) continue;
            line(3, numbered(letter, k) + " = " + numbered(letter, k - 1) + ';');
        }
}

void ListGlsl::popPlace()
{
    for (std::uint32_t k = 0; k < v_.places; ++k)
        for (const char* letter : {"q", "o", "best", "copy", "kept"}) {
            const bool ofCopies = letter[0] == 'b' || letter[0] == 'c' || letter[0] == 'k';
            if ((ofCopies && !repeats()) || (letter[0] == 'k' && !materials_)) continue;
            line(3, numbered(letter, k) + " = " + numbered(letter, k + 1) + ';');
        }
}

/// Writes the steps that open and close a level of results.
void ListGlsl::levels()
{
    if (v_.results == 0) return;
    line(2, ifOperation(ListOp::open));
    pushResult();
    line(2, "}");
    line(2, ifOperation(ListOp::close));
    popResult();
    line(2, "}");
    if (v_.places == 0) return;
    line(2, ifOperation(ListOp::leave));
    popResult();
    line(3, "d *= n0.x;");
    popPlace();
    line(2, "}");
}

void ListGlsl::space(std::uint32_t k)
{
    if (v_.places == 0) return;
    const NodeKind& kind = *v_.spaces[k];
    line(2, ifOperation(ListOp::enter, 3 * k));
    pushResult();
    pushPlace();
    line(3, "o0 = p;");
    if (kind.place)
        line(3, "q0 = " + writtenOut(kind.place.glsl, {}, number) + ';');
    else if (kind.copy)
        line(3, "q0 = " + writtenOut(kind.copy.glsl, {{"i", "0"}}, number) + ';');
    else
        line(3, "q0 = p;");
    if (kind.copy) {
        line(3, "best0 = 1.0e9;");
        line(3, "copy0 = 0;");
    }
    line(2, "}");
    if (kind.after) {
        line(2, ifOperation(ListOp::enter, 3 * k + 1));
        line(3, "d0 = " + writtenOut(kind.after.glsl, {{"d", "d0"}, {"p", "o0"}}, number) + ';');
        line(2, "}");
    }
    if (!kind.copy) return;
    line(2, ifOperation(ListOp::enter, 3 * k + 2));
    again(kind);
    line(2, "}");
}

void ListGlsl::again(const NodeKind& kind)
{
    const auto asked = static_cast<std::uint32_t>(kind.numbers());
    line(3, "float c = sceneCapped(d0, q0, " + number(asked + 6) + ", " + vector(asked + 7) + ", " +
                vector(asked + 10) + ");");
    if (materials_) line(3, "if (c < best0 || copy0 == 0) kept0 = m0;");
    line(3, "best0 = min(best0, c);");
    line(3, "copy0 += 1;");
    line(3, "if (copy0 < int(" + number(asked + 3) + ") * int(" + number(asked + 4) + ") * int(" + number(asked + 5) +
                ")) {");
    line(4, "q0 = " + writtenOut(kind.copy.glsl, {{"p", "o0"}, {"i", "copy0"}}, number) + ';');
    line(4, "i = first + code.w;");
    line(3, "} else {");
    line(4, "d0 = sceneBeyond(best0, o0, " + number(asked + 6) + ", " + vector(asked + 13) + ", " + vector(asked + 16) +
                ");");
    if (materials_) line(4, "m0 = kept0;");
    line(3, "}");
}

void ListGlsl::joints()
{
    if (!v_.joints.empty()) line(2, "vec4 k = sceneRecord(code.z + 3u);");
    for (std::uint32_t j = 0; j < v_.joints.size(); ++j) {
        const ListVocabulary::Joint& joint = v_.joints[j];
        const bool chooses = joint.kind->fields.front().type == FieldType::choice;
        const auto own = [&](std::uint32_t i) {
            return i == 0 && chooses ? floatLiteral(joint.choice) : std::string("k.") + "yzw"[i];
        };
        const ExpressionNames names{{"a", "d0"}, {"b", "d"}};
        line(2, "if (joint == " + std::to_string(j + 2) + "u) {");
        if (materials_) line(3, "m0 = sceneBlend(m0, m, " + writtenOut(joint.kind->share.glsl, names, own) + ");");
        line(3, "d0 = " + writtenOut(joint.kind->combine.glsl, names, own) + ';');
        line(2, "}");
    }
    line(2, "if (joint == 1u) {");
    line(3, "d0 = d;");
    if (materials_) line(3, "m0 = m;");
    line(2, "}");
}

std::string planesText(std::uint32_t planes, bool withMaterials)
{
    std::string text;
    for (std::uint32_t k = 0; k < planes; ++k) {
        const std::string at = numbered("scenePlane", k);
        const std::string distance = "dot(" + at + ".xyz, p) - " + at + ".w";
        if (!withMaterials) {
            text += "    d = min(d, " + distance + " + scenePlanesAway);\n";
            continue;
        }
        const std::string material = "scenePlaneMaterial(" + std::to_string(k) + ')';
        text += "    if (" + distance + " < s.distance) s = SceneSurface(" + distance + ", sceneMaterialAt(" +
                material + "));\n";
    }
    return text;
}

}  // namespace

std::string listGlsl(const ListVocabulary& vocabulary, std::uint32_t planes, const FurtherMember& further)
{
    std::string text = "// Walks lists of steps of the kinds of a scene file.\n#define SCENE_NEAR\n"
                       "#include \"lib/bindings.glsl\"\n#include \"lib/numerics.glsl\"\n#include \"lib/sdf.glsl\"\n"
                       "#include \"lib/sdf_operators.glsl\"\n#include \"sdf_scenes/operators.glsl\"\n"
                       "#include \"sdf_scenes/material.glsl\"\n#include \"sdf_scenes/shapes.glsl\"\n"
                       "#include \"sdf_scenes/noise.glsl\"\n#include \"sdf_scenes/primitive_evaluations.glsl\"\n"
                       "#include \"sdf_scenes/near.glsl\"\n";
    text += "#define SCENE_PLANES " + std::to_string(planes) + '\n';
    for (std::uint32_t k = 0; k < planes; ++k)
        text += "vec4 " + numbered("scenePlane", k) + " = scenePlane(" + std::to_string(k) + ");\n";
    if (!further.file.empty()) text += "#include \"" + further.file + "\"\n";
    if (!further.declaration.empty())
        text += "\nlayout(std140, binding = BLOCK_EXHIBIT) uniform Scene {\n    " + further.declaration + ";\n};\n";
    ListGlsl writer(vocabulary);
    text += '\n' + writer.walk(false) + '\n';
    text += writer.walk(true).replace(0, 24, "SceneSurface sceneListedSurface");
    text += "\nfloat fieldDistance(vec3 p)\n{\n    SceneCell cell = sceneCellAt(p);\n"
            "    float d = sceneListed(p, cell.first, cell.near);\n    if (!cell.near) d = cell.clearance;\n";
    text += planesText(planes, false);
    text += "    return d;\n}\n\nSceneSurface sceneSurface(vec3 p)\n{\n    SceneCell cell = sceneCellAt(p);\n"
            "    SceneSurface s = sceneListedSurface(p, cell.first, cell.near);\n"
            "    if (!cell.near) s.distance = cell.clearance;\n";
    return text + planesText(planes, true) + "    return s;\n}\n";
}

}  // namespace vitrine::scenes
