#include "exhibits/your_shader/guest_glsl.h"

#include "render/glsl/lexer.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <set>

namespace vitrine::guest {
namespace {

constexpr std::string_view prefix = "guest_";

constexpr int usedByNoVersion = 1000;

/// Words that GLSL 4.50 reserves, with the version that reserved them first. A text of an older version may use them as
/// names. `usedByNoVersion`: words that are names everywhere.
const std::map<std::string_view, int>& reservedSince()
{
    static const std::map<std::string_view, int> words = [] {
        std::map<std::string_view, int> all{
            {"smooth", 130},   {"flat", 130},        {"noperspective", 130}, {"uint", 130},     {"uvec2", 130},
            {"uvec3", 130},    {"uvec4", 130},       {"layout", 140},        {"sample", 400},   {"patch", 400},
            {"precise", 400},  {"subroutine", 400},  {"double", 400},        {"dvec2", 400},    {"dvec3", 400},
            {"dvec4", 400},    {"coherent", 420},    {"restrict", 420},      {"readonly", 420}, {"writeonly", 420},
            {"volatile", 420}, {"atomic_uint", 420}, {"buffer", 430},        {"shared", 430}};
        for (const char* word :
             {"common",   "partition", "active",    "asm",   "class",     "union",    "enum",   "typedef",
              "template", "this",      "resource",  "goto",  "inline",    "noinline", "public", "static",
              "extern",   "external",  "interface", "long",  "short",     "half",     "fixed",  "unsigned",
              "superp",   "input",     "output",    "hvec2", "hvec3",     "hvec4",    "fvec2",  "fvec3",
              "fvec4",    "filter",    "sizeof",    "cast",  "namespace", "using"})
            all.emplace(word, usedByNoVersion);
        return all;
    }();
    return words;
}

/// Names of old GLSL and of OpenGL ES, and what they are called today.
const std::map<std::string_view, std::string_view>& renamed()
{
    static const std::map<std::string_view, std::string_view> names{{"gl_FragColor", "guest_FragColor"},
                                                                    {"gl_FragData", "guest_FragData"},
                                                                    {"texture2D", "texture"},
                                                                    {"textureCube", "texture"},
                                                                    {"texture3D", "texture"},
                                                                    {"texture2DLod", "textureLod"},
                                                                    {"texture2DLodEXT", "textureLod"},
                                                                    {"textureCubeLod", "textureLod"},
                                                                    {"textureCubeLodEXT", "textureLod"},
                                                                    {"texture2DProj", "textureProj"},
                                                                    {"texture2DGrad", "textureGrad"},
                                                                    {"texture2DGradEXT", "textureGrad"},
                                                                    {"vv_FragNormCoord", "isf_FragNormCoord"},
                                                                    {"vv_vertShaderInit", "isf_vertShaderInit"}};
    return names;
}

/// Version of GLSL that a text was written for: that of its `#version`, else that of its form.
int versionOf(const render::Tokens& tokens, Form form)
{
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (tokens[i].directive == 0 || tokens.text(i) != "#" || tokens.text(i + 1) != "version") continue;
        const std::string_view number = tokens.text(i + 2);
        int version = 0;
        std::from_chars(number.data(), number.data() + number.size(), version);
        return tokens.text(i + 3) == "es" ? 330 : version;
    }
    return form == Form::shadertoy ? 330 : 120;
}

/// Preprocessor lines that the program replaces.
bool isBlanked(std::string_view word)
{
    return word == "version" || word == "extension" || word == "line" || word == "pragma" || word == "include" ||
           word == "iUniform" || word.starts_with("iChannel");
}

/// Returns the reserved words that a text uses as types or qualifiers, whatever its version: those before another word,
/// as in `uvec2 size`. No name stands there.
std::set<std::string_view> keywordsOf(const render::Tokens& tokens)
{
    std::set<std::string_view> keywords;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        const auto reserved = reservedSince().find(tokens.text(i));
        if (reserved == reservedSince().end() || reserved->second >= usedByNoVersion) continue;
        if (tokens[i].directive == 0 && tokens[i + 1].kind == render::Token::Kind::word)
            keywords.insert(reserved->first);
    }
    return keywords;
}

/// Translates one piece of the visitor's code. The number of lines stays the same.
class Translator {
public:
    Translator(const Shader& shader, const CodePiece& piece, bool isVertex)
        : shader_(shader), text_(piece.text), tokens_(piece.text), isVertex_(isVertex),
          version_(versionOf(render::Tokens(shader.files[piece.file].text), shader.form)),
          keywords_(keywordsOf(render::Tokens(shader.files[piece.file].text)))
    {
    }

    std::string run()
    {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (const std::size_t end = blankedUntil(i); end > i) {
                gap(tokens_[i].begin);
                at_ = tokens_[end - 1].end;
                newlines(tokens_[i].begin, at_);
                i = end - 1;
                continue;
            }
            gap(tokens_[i].begin);
            out_ += tokens_[i].kind == render::Token::Kind::word ? word(i) : std::string(tokens_.text(i));
            newlines(tokens_[i].begin, tokens_[i].end);
            at_ = tokens_[i].end;
            const std::string_view text = tokens_.text(i);
            if (tokens_[i].directive == 0) depth_ += (text == "{") - (text == "}");
        }
        gap(text_.size());
        if (out_.empty() || out_.back() != '\n') out_ += '\n';
        return std::move(out_);
    }

private:
    void newlines(std::size_t begin, std::size_t end)
    {
        out_.append(static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(begin),
                                                        text_.begin() + static_cast<std::ptrdiff_t>(end), '\n')),
                    '\n');
    }
    /// Copies blanks and continued lines up to a byte. Comments become blanks, because they may hold any bytes.
    void gap(std::size_t end)
    {
        bool blank = false;
        for (; at_ < end; ++at_) {
            const char c = text_[at_];
            if (c == '\\' && at_ + 1 < end && text_[at_ + 1] == '\n' && inDirective_) out_ += c;
            if (c == '\n') out_ += c;
            if (c == ' ' || c == '\t') out_ += c;
            blank = blank || c == '/';
        }
        if (blank) out_ += ' ';
    }
    /// Returns the end of the tokens to leave out from here: preprocessor lines, and declarations of inputs.
    std::size_t blankedUntil(std::size_t i)
    {
        const render::Token& token = tokens_[i];
        inDirective_ = token.directive != 0;
        const bool begins =
            token.directive != 0 && tokens_.text(i) == "#" && (i == 0 || tokens_[i - 1].directive != token.directive);
        if (begins && isBlanked(tokens_.text(i + 1))) return tokens_.lineEnd(i);
        if (shader_.form != Form::plain) return i;
        if (begins && tokens_.text(i + 1) == "define" && shader_.inputNamed(std::string(tokens_.text(i + 2))))
            return tokens_.lineEnd(i);
        const bool isUniform = token.directive == 0 && depth_ == 0 && tokens_.text(i) == "uniform";
        const bool isConstant = token.directive == 0 && depth_ == 0 && tokens_.text(i) == "const" &&
                                shader_.inputNamed(std::string(tokens_.text(i + 2)));
        if (!isUniform && !isConstant) return i;
        std::size_t end = i;
        while (end < tokens_.size() && tokens_.text(end) != ";") ++end;
        return std::min(end + 1, tokens_.size());
    }
    [[nodiscard]] std::string word(std::size_t i) const
    {
        const std::string_view text = tokens_.text(i);
        if (tokens_[i].directive != 0 && i > 0 && tokens_.text(i - 1) == "#") return std::string(text);
        if (text == "varying") return isVertex_ ? "out" : "in";
        if (text == "attribute") return "in";
        if (const auto found = renamed().find(text); found != renamed().end()) return std::string(found->second);
        if (text == "texture" && tokens_.text(i + 1) != "(" && (version_ < 130 || shader_.inputNamed("texture")))
            return std::string(prefix) + "texture";
        const auto reserved = reservedSince().find(text);
        if (reserved != reservedSince().end() && reserved->second > version_ && !keywords_.contains(text))
            return programName(text);
        return std::string(text);
    }

    const Shader& shader_;
    const std::string_view text_;
    const render::Tokens tokens_;
    const bool isVertex_;
    const int version_;
    const std::set<std::string_view> keywords_;
    std::string out_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool inDirective_ = false;
};

std::string lineDirective(int line, std::uint32_t source)
{
    return "#line " + std::to_string(line) + ' ' + std::to_string(source) + '\n';
}

std::string visitorsCode(const Shader& shader, const Code& code, bool isVertex)
{
    std::string text;
    for (const CodePiece& piece : code) {
        text += lineDirective(piece.line, piece.file);
        text += Translator(shader, piece, isVertex).run();
    }
    return text;
}

std::string inputBlock(const Shader& shader)
{
    std::string members;
    for (const Input& input : shader.inputs) {
        const std::string name = programName(input.name);
        if (!isPicture(input)) {
            members += input.glslType + ' ' + name + "; ";
            continue;
        }
        if (shader.form == Form::isf)
            members +=
                "vec4 _" + input.name + "_imgRect; vec2 _" + input.name + "_imgSize; bool _" + input.name + "_flip; ";
    }
    if (!members.empty())
        members = "layout(std140, binding = " + std::to_string(BLOCK_PARAMETERS) + ") uniform GuestInputs { " +
                  members + "};\n";
    return members;
}

std::string frameBlock(const Shader& shader)
{
    std::string members;
    for (const BuiltIn& builtIn : shader.builtIns) {
        members += builtIn.glslType + ' ' + programName(builtIn.name);
        if (builtIn.count > 0) members += '[' + std::to_string(builtIn.count) + ']';
        members += "; ";
    }
    if (members.empty()) return "";
    return "layout(std140, binding = " + std::to_string(BLOCK_EXHIBIT) + ") uniform GuestFrame { " + members + "};\n";
}

/// Declares the pictures of inputs, passes and imports. Both stages get the same numbers.
std::string samplers(const Shader& shader, const Pass& pass)
{
    std::string text;
    int unit = 0;
    for (const PictureUse& use : picturesOf(shader, pass))
        text += "layout(binding = " + std::to_string(unit++) + ") uniform " + use.glslType + ' ' +
                programName(use.name) + ";\n";
    return text;
}

constexpr const char* isfMacros = R"(#define IMG_NORM_PIXEL(image, at) texture(image, at)
#define IMG_PIXEL(image, at) texture(image, (at) / vec2(textureSize(image, 0)))
#define IMG_THIS_NORM_PIXEL(image) texture(image, isf_FragNormCoord)
#define IMG_THIS_PIXEL(image) texture(image, isf_FragNormCoord)
#define IMG_SIZE(image) vec2(textureSize(image, 0))
)";

/// Position of the triangle that covers the picture, and the normalized coordinate there.
constexpr const char* triangle = R"(vec2 guest_corner() { return vec2((gl_VertexID & 1) * 2, gl_VertexID & 2); }
)";

/// The same for two triangles, which are two instances. Vertex shaders of visitors expect corners from 0 to 1.
constexpr const char* twoTriangles = R"(vec2 guest_corner()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    return gl_InstanceID == 0 ? corner : vec2(1.0) - corner;
}
)";

std::string vertexText(const Shader& shader, const Pass& pass, const std::string& blocks)
{
    std::string text = "#version 450\n" + lineDirective(1, PassText::ownSource) +
                       (trianglesOf(shader) == 2 ? twoTriangles : triangle) + blocks;
    if (shader.form == Form::isf) {
        text += "out vec2 isf_FragNormCoord;\nvoid isf_vertShaderInit() { isf_FragNormCoord = guest_corner(); "
                "gl_Position = vec4(guest_corner() * 2.0 - 1.0, 0.0, 1.0); }\n";
        if (!shader.vertexCode.empty()) return text + isfMacros + visitorsCode(shader, shader.vertexCode, true);
        return text + "void main() { isf_vertShaderInit(); }\n";
    }
    std::string body;
    if (shader.form == Form::plain) {
        for (const Varying& varying : varyingsOf(pass.code)) {
            static const std::map<std::string, std::string> values{{"float", "guest_corner().x"},
                                                                   {"vec2", "guest_corner()"},
                                                                   {"vec3", "vec3(guest_corner(), 0.0)"},
                                                                   {"vec4", "vec4(guest_corner(), 0.0, 1.0)"}};
            const auto value = values.find(varying.type);
            if (value == values.end()) continue;
            text += "out " + varying.type + ' ' + programName(varying.name) + ";\n";
            body += programName(varying.name) + " = " + value->second + "; ";
        }
    }
    return text + "void main() { " + body + "gl_Position = vec4(guest_corner() * 2.0 - 1.0, 0.0, 1.0); }\n";
}

bool uses(const Code& code, std::string_view word)
{
    return std::any_of(code.begin(), code.end(),
                       [&](const CodePiece& piece) { return render::Tokens(piece.text).contains(word); });
}

/// Main function of a pass that draws a face of a cube map. Directions are those with which it is read.
constexpr const char* cubeMain = R"(void main()
{
    vec2 p = 2.0 * gl_FragCoord.xy / iResolution.xy - 1.0;
    vec3 way = guest_cube_face == 0   ? vec3(1.0, -p.y, -p.x)
               : guest_cube_face == 1 ? vec3(-1.0, -p.y, p.x)
               : guest_cube_face == 2 ? vec3(p.x, 1.0, p.y)
               : guest_cube_face == 3 ? vec3(p.x, -1.0, -p.y)
               : guest_cube_face == 4 ? vec3(p.x, -p.y, 1.0)
                                      : vec3(-p.x, -p.y, -1.0);
    guest_FragColor = vec4(0.0);
    mainCubemap(guest_FragColor, gl_FragCoord.xy, vec3(0.0), normalize(way));
}
)";

std::string fragmentText(const Shader& shader, const Pass& pass, const std::string& blocks)
{
    std::string text = "#version 450\n" + lineDirective(1, PassText::ownSource) + blocks;
    for (const std::string& define : pass.defines) text += "#define " + define + '\n';
    if (shader.form == Form::isf) text += "in vec2 isf_FragNormCoord;\n" + std::string(isfMacros);
    if (shader.form == Form::shadertoy) text += "out vec4 guest_FragColor;\n";
    // The color is declared where it is used: a plain shader may have an output of its own.
    else if (uses(pass.code, "gl_FragData"))
        text += "out vec4 guest_FragData[1];\n";
    else if (shader.form == Form::isf || uses(pass.code, "gl_FragColor"))
        text += "out vec4 guest_FragColor;\n";
    text += visitorsCode(shader, pass.code, false);
    if (shader.form != Form::shadertoy) return text;
    text += lineDirective(1, PassText::ownSource);
    if (pass.isCube) return text + cubeMain;
    return text + "void main() { guest_FragColor = vec4(0.0); mainImage(guest_FragColor, gl_FragCoord.xy); }\n";
}

/// Parses "0:12: rest" behind "ERROR: ". Returns whether the line has this form.
bool readPlace(std::string_view& line, std::uint32_t& source, int& number)
{
    const auto cut = [&](auto& value) {
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        if (error != std::errc() || end == line.data() + line.size() || *end != ':') return false;
        line.remove_prefix(static_cast<std::size_t>(end - line.data()) + 1);
        return true;
    };
    return cut(source) && cut(number);
}

/// Returns a message of glslang with the visitor's names: "guest_sample" is "sample".
std::string inVisitorsWords(std::string_view text)
{
    std::string out(text);
    for (std::size_t at = 0; (at = out.find(prefix, at)) != std::string::npos;) {
        std::size_t end = at;
        while (end < out.size() && (std::isalnum(static_cast<unsigned char>(out[end])) || out[end] == '_')) ++end;
        const std::string word(visitorsName(std::string_view(out).substr(at, end - at)));
        out.replace(at, end - at, word);
        at += word.size();
    }
    return out;
}

}  // namespace

std::vector<Varying> varyingsOf(const Code& code)
{
    std::vector<Varying> found;
    std::set<std::string> names;
    for (const CodePiece& piece : code) {
        const render::Tokens tokens(piece.text);
        int depth = 0;
        for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
            const std::string_view word = tokens.text(i);
            if (tokens[i].directive != 0) continue;
            depth += (word == "{") - (word == "}") + (word == "(") - (word == ")");
            if (depth != 0 || (word != "in" && word != "varying")) continue;
            std::size_t at = i + 1;
            while (render::isPrecision(tokens.text(at))) ++at;
            const std::string name(tokens.text(at + 1));
            if (tokens.text(at + 2) == ";" && names.insert(name).second)
                found.push_back({std::string(tokens.text(at)), name});
        }
    }
    return found;
}

bool isPicture(const Input& input)
{
    return input.glslType.starts_with("sampler");
}

int trianglesOf(const Shader& shader)
{
    return shader.form == Form::isf && !shader.vertexCode.empty() ? 2 : 1;
}

std::vector<PictureUse> picturesOf(const Shader& shader, const Pass& pass)
{
    using Source = PictureUse::Source;
    std::vector<PictureUse> uses;
    std::set<std::string> declared;
    const auto declare = [&](Source source, std::size_t index, const std::string& name, const std::string& type) {
        if (!name.empty() && declared.insert(name).second) uses.push_back({source, index, name, type});
    };
    for (std::size_t i = 0; i < shader.inputs.size(); ++i)
        if (isPicture(shader.inputs[i])) declare(Source::input, i, shader.inputs[i].name, shader.inputs[i].glslType);
    if (shader.form == Form::isf) {
        for (std::size_t i = 0; i < shader.passes.size(); ++i)
            declare(Source::target, i, shader.passes[i].target, "sampler2D");
        for (std::size_t i = 0; i < shader.imports.size(); ++i)
            declare(Source::import, i, shader.imports[i].name, "sampler2D");
    }
    for (std::size_t i = 0; i < pass.channels.size(); ++i)
        declare(Source::channel, i, pass.channels[i].name, pass.channels[i].glslType);
    return uses;
}

std::string programName(std::string_view name)
{
    return reservedSince().contains(name) || name == "texture" ? std::string(prefix) + std::string(name)
                                                               : std::string(name);
}

std::string_view visitorsName(std::string_view name)
{
    for (const auto& [old, now] : renamed())
        if (name == now && now.starts_with(prefix)) return old;
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
    return name;
}

PassText passText(const Shader& shader, const Pass& pass)
{
    const std::string blocks = inputBlock(shader) + frameBlock(shader) + samplers(shader, pass);
    return {vertexText(shader, pass, blocks), fragmentText(shader, pass, blocks)};
}

std::vector<Finding> findingsOf(const Shader& shader, std::string_view log)
{
    std::vector<Finding> findings;
    while (!log.empty() && findings.size() < Limits::findings) {
        const std::size_t newline = log.find('\n');
        std::string_view line = log.substr(0, newline);
        log.remove_prefix(newline == std::string_view::npos ? log.size() : newline + 1);
        if (!line.starts_with("ERROR: ")) continue;
        line.remove_prefix(7);
        std::uint32_t source = 0;
        int number = 0;
        if (!readPlace(line, source, number)) continue;
        std::string text =
            inVisitorsWords(line.substr(std::min<std::size_t>(line.find_first_not_of(' '), line.size())));
        std::string token;
        if (text.starts_with('\'')) token = text.substr(1, std::max<std::size_t>(text.find('\'', 1), 1) - 1);
        if (text.starts_with("'' : ")) text.erase(0, text.find_first_not_of(" ':"));
        while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
        if (text == "compilation terminated" && !findings.empty()) continue;
        const bool visitors = source < shader.files.size();
        const SourceFile& file = shader.files[visitors ? source : 0];
        findings.push_back({.file = file.name,
                            .line = visitors ? number : 1,
                            .column = visitors ? render::columnOf(file.text, number, token) : 1,
                            .sentence = message("The GLSL compiler says: {1}.", text)});
    }
    return findings;
}

std::string withLoopGuard(const std::string& glsl)
{
    std::string out;
    bool expectsBrace = false;
    std::string_view rest = glsl;
    bool declared = false;
    while (!rest.empty()) {
        const std::size_t newline = rest.find('\n');
        const std::string_view line = rest.substr(0, newline);
        rest.remove_prefix(newline == std::string_view::npos ? rest.size() : newline + 1);
        const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
        const std::string_view code = line.substr(first);
        if (expectsBrace && code != "{") return "";
        out += line;
        out += '\n';
        if (expectsBrace) out += "if (++guest_rounds > GUEST_ROUNDS) break;\n";
        expectsBrace = code.starts_with("for (") || code.starts_with("while (") || code == "do";
        // "} while (...);" ends a loop whose head was seen.
        if (code.starts_with("while (") && code.ends_with(";")) expectsBrace = false;
        if (!declared && code.starts_with("#version")) {
            out += "uint guest_rounds = 0u;\n";
            declared = true;
        }
    }
    return expectsBrace ? "" : out;
}

}  // namespace vitrine::guest
