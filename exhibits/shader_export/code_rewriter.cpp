#include "exhibits/shader_export/code_rewriter.h"

#include "render/files/number_text.h"
#include "render/glsl/lexer.h"

#include <algorithm>

namespace vitrine::guest {
namespace {

/// Preprocessor lines that belong to the old form.
bool belongsToForm(std::string_view word)
{
    return word == "version" || word == "extension" || word == "line" || word == "include" || word == "iUniform" ||
           word.starts_with("iChannel");
}

/// Qualifiers and types of GLSL, which are no names.
bool isTypeWord(std::string_view word)
{
    static const std::set<std::string_view> words{
        "void",  "bool",  "int",     "uint",      "float",  "vec2",      "vec3",        "vec4",      "ivec2",
        "ivec3", "ivec4", "bvec2",   "bvec3",     "bvec4",  "uvec2",     "uvec3",       "uvec4",     "mat2",
        "mat3",  "mat4",  "mat2x3",  "mat2x4",    "mat3x2", "mat3x4",    "mat4x2",      "mat4x3",    "sampler2D",
        "const", "in",    "out",     "inout",     "flat",   "smooth",    "uniform",     "varying",   "struct",
        "highp", "lowp",  "mediump", "precision", "return", "layout",    "precise",     "attribute", "centroid",
        "if",    "else",  "for",     "while",     "do",     "invariant", "samplerCube", "sampler3D"};
    return words.contains(word);
}

/// Copies one piece of code, with edits.
class PieceRewriter {
public:
    PieceRewriter(const Shader& shader, const CodePiece& piece, const Renaming& renaming)
        : shader_(shader), text_(piece.text), tokens_(text_), renaming_(renaming)
    {
    }

    std::string run()
    {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (const std::size_t end = leftOutUntil(i); end > i) {
                copyTo(tokens_[i].begin);
                at_ = tokens_[end - 1].end;
                leaveOutRestOfLine();
                i = end - 1;
                continue;
            }
            if (tokens_[i].directive == 0) depth_ += (tokens_.text(i) == "{") - (tokens_.text(i) == "}");
            const auto found = renaming_.find(tokens_.text(i));
            const bool isMember = i > 0 && tokens_.text(i - 1) == ".";
            if (tokens_[i].kind != render::Token::Kind::word || found == renaming_.end() || isMember) continue;
            copyTo(tokens_[i].begin);
            out_ += found->second;
            at_ = tokens_[i].end;
        }
        copyTo(static_cast<std::uint32_t>(text_.size()));
        return std::move(out_);
    }

private:
    void copyTo(std::uint32_t end)
    {
        if (end > at_) out_ += text_.substr(at_, end - at_);
        at_ = std::max(at_, end);
    }
    /// Leaves out a comment behind what was left out, and the line if nothing else stands in it.
    void leaveOutRestOfLine()
    {
        const std::size_t newline = std::min(text_.find('\n', at_), text_.size());
        const std::string_view rest = text_.substr(at_, newline - at_);
        const std::size_t first = rest.find_first_not_of(" \t");
        if (first != std::string_view::npos && rest.substr(first, 2) != "//") {
            at_ += static_cast<std::uint32_t>(first);
            return;
        }
        at_ = static_cast<std::uint32_t>(newline);
        const std::size_t lineBegin = out_.find_last_not_of(" \t");
        if (lineBegin == std::string::npos || out_[lineBegin] == '\n') {
            out_.erase(lineBegin == std::string::npos ? 0 : lineBegin + 1);
            at_ = std::min(at_ + 1, static_cast<std::uint32_t>(text_.size()));
        }
    }
    /// Returns the index behind the tokens to leave out from here; `i` if there are none.
    [[nodiscard]] std::size_t leftOutUntil(std::size_t i) const
    {
        const std::string_view word = tokens_.text(i);
        if (tokens_[i].directive != 0) {
            const bool begins = word == "#" && (i == 0 || tokens_[i - 1].directive != tokens_[i].directive);
            if (!begins) return i;
            const bool isInput = shader_.form == Form::plain && tokens_.text(i + 1) == "define" &&
                                 shader_.inputNamed(std::string(tokens_.text(i + 2)));
            return belongsToForm(tokens_.text(i + 1)) || isInput ? tokens_.lineEnd(i) : i;
        }
        if (shader_.form != Form::plain || depth_ != 0) return i;
        if (word == "layout" && tokens_.text(i + 1) == "(") {
            std::size_t end = i;
            while (end < tokens_.size() && tokens_.text(end) != ")") ++end;
            const bool isOut = tokens_.text(end + 1) == "out" || tokens_.text(end + 1) == "in";
            return isOut ? end + 1 : i;
        }
        const bool between = i == 0 || tokens_[i - 1].directive != 0 || tokens_.text(i - 1) == ";" ||
                             tokens_.text(i - 1) == "}" || tokens_.text(i - 1) == ")";
        // The output becomes a plain variable.
        if (word == "out" && between) return render::isPrecision(tokens_.text(i + 1)) ? i + 2 : i + 1;
        const bool isConstant = word == "const" && shader_.inputNamed(std::string(tokens_.text(i + 2)));
        if (word != "uniform" && !isConstant && !((word == "in" || word == "varying") && between)) return i;
        std::size_t end = i;
        while (end < tokens_.size() && tokens_.text(end) != ";") ++end;
        return std::min(end + 1, tokens_.size());
    }

    const Shader& shader_;
    const std::string_view text_;
    const render::Tokens tokens_;
    const Renaming& renaming_;
    std::string out_;
    std::uint32_t at_ = 0;
    int depth_ = 0;
};

/// Returns the piece without the comment that holds the JSON head.
CodePiece withoutHead(CodePiece piece)
{
    const std::size_t open = piece.text.find("/*"), close = piece.text.find("*/", open);
    if (open == std::string::npos || close == std::string::npos) return piece;
    piece.text.erase(open, close + 2 - open);
    piece.text.erase(0, std::min(piece.text.find_first_not_of(" \t\n"), piece.text.size()));
    return piece;
}

}  // namespace

std::string rewritten(const Shader& shader, const Code& code, const Renaming& renaming)
{
    std::string text;
    bool isFirst = shader.form == Form::isf;
    for (const CodePiece& piece : code) {
        const bool hasHead = isFirst && piece.file == 0;
        text += PieceRewriter(shader, hasHead ? withoutHead(piece) : piece, renaming).run();
        isFirst = isFirst && !hasHead;
        if (!text.empty() && text.back() != '\n') text += '\n';
    }
    return text;
}

std::set<std::string> globalNames(const Code& code)
{
    std::set<std::string> names;
    for (const CodePiece& piece : code) {
        const render::Tokens tokens(piece.text);
        int depth = 0, inBrackets = 0;
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const std::string_view word = tokens.text(i);
            if (tokens[i].directive != 0) {
                if (word == "define" && tokens.text(i - 1) == "#") names.emplace(tokens.text(i + 1));
                continue;
            }
            depth += (word == "{") - (word == "}");
            inBrackets += (word == "(") - (word == ")");
            if (depth != 0 || inBrackets != 0 || tokens[i].kind != render::Token::Kind::word || isTypeWord(word) ||
                i == 0)
                continue;
            const std::string_view before = tokens.text(i - 1);
            const bool isDeclared = tokens[i - 1].kind == render::Token::Kind::word || before == "]" || before == "," ||
                                    (before == "}" && (tokens.text(i + 1) == ";" || tokens.text(i + 1) == "["));
            if (isDeclared && tokens[i - 1].directive == 0) names.emplace(word);
        }
    }
    return names;
}

bool usesWord(const Code& code, std::string_view word)
{
    return std::any_of(code.begin(), code.end(),
                       [&](const CodePiece& piece) { return render::Tokens(piece.text).contains(word); });
}

std::string outputName(const Code& code)
{
    for (const CodePiece& piece : code) {
        const render::Tokens tokens(piece.text);
        int depth = 0;
        for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
            const std::string_view word = tokens.text(i);
            if (tokens[i].directive != 0) continue;
            depth += (word == "{") - (word == "}") + (word == "(") - (word == ")");
            const std::size_t type = i + (render::isPrecision(tokens.text(i + 1)) ? 2 : 1);
            if (depth == 0 && word == "out" && tokens.text(type + 2) == ";") return std::string(tokens.text(type + 1));
        }
    }
    return "";
}

std::string versionLine(const std::string& text)
{
    static const std::set<std::string_view> since450{"precise", "sample", "double", "dvec2", "dvec3", "dvec4"};
    static const std::set<std::string_view> since330{"uint", "uvec2", "uvec3", "uvec4", "flat", "layout", "smooth"};
    const render::Tokens tokens(text);
    int version = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        // As a name, the word stands behind a type or before an operator; as a type, before a name or a bracket.
        const bool isType = tokens[i + 1 < tokens.size() ? i + 1 : i].kind == render::Token::Kind::word ||
                            tokens.text(i + 1) == "(" || tokens.text(i + 1) == "[";
        const bool isMember = i > 0 && tokens.text(i - 1) == ".";
        if (!isType || isMember) continue;
        if (since450.contains(tokens.text(i)) && tokens[i + 1].kind == render::Token::Kind::word) version = 450;
        if (since330.contains(tokens.text(i))) version = std::max(version, 330);
    }
    return version == 0 ? "" : "#version " + std::to_string(version) + '\n';
}

std::string floatText(double x)
{
    std::string text = render::shortestNumber(x);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

}  // namespace vitrine::guest
