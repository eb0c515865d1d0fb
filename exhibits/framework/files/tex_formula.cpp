#include "exhibits/framework/files/tex_formula.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace vitrine {
namespace {

constexpr int deepestGroup = 16;

struct TexSign {
    std::string_view name, text;
};

// Identifiers: "<mi>".
constexpr std::array<TexSign, 40> texLetters{
    {{"alpha", "α"},    {"beta", "β"},   {"gamma", "γ"},      {"delta", "δ"}, {"epsilon", "ε"}, {"zeta", "ζ"},
     {"eta", "η"},      {"theta", "θ"},  {"iota", "ι"},       {"kappa", "κ"}, {"lambda", "λ"},  {"mu", "μ"},
     {"nu", "ν"},       {"xi", "ξ"},     {"pi", "π"},         {"rho", "ρ"},   {"sigma", "σ"},   {"tau", "τ"},
     {"upsilon", "υ"},  {"phi", "φ"},    {"chi", "χ"},        {"psi", "ψ"},   {"omega", "ω"},   {"Gamma", "Γ"},
     {"Delta", "Δ"},    {"Theta", "Θ"},  {"Lambda", "Λ"},     {"Xi", "Ξ"},    {"Pi", "Π"},      {"Sigma", "Σ"},
     {"Phi", "Φ"},      {"Psi", "Ψ"},    {"Omega", "Ω"},      {"infty", "∞"}, {"ell", "ℓ"},     {"hbar", "ℏ"},
     {"emptyset", "∅"}, {"varphi", "ϕ"}, {"varepsilon", "ϵ"}, {"nabla", "∇"}}};
// Names of functions, upright: "<mi>".
constexpr std::array<std::string_view, 14> texFunctions{"sin", "cos", "tan", "exp",    "log",    "ln",     "min",
                                                        "max", "lim", "det", "arcsin", "arccos", "arctan", "sup"};
// Operators: "<mo>".
constexpr std::array<TexSign, 36> texOperators{
    {{"cdot", "·"},   {"times", "×"},  {"pm", "±"},      {"mp", "∓"},     {"le", "≤"},     {"leq", "≤"},
     {"ge", "≥"},     {"geq", "≥"},    {"ne", "≠"},      {"neq", "≠"},    {"approx", "≈"}, {"equiv", "≡"},
     {"sim", "∼"},    {"ll", "≪"},     {"gg", "≫"},      {"propto", "∝"}, {"to", "→"},     {"rightarrow", "→"},
     {"mapsto", "↦"}, {"in", "∈"},     {"notin", "∉"},   {"cup", "∪"},    {"cap", "∩"},    {"subset", "⊂"},
     {"forall", "∀"}, {"exists", "∃"}, {"partial", "∂"}, {"ldots", "…"},  {"cdots", "⋯"},  {"lfloor", "⌊"},
     {"rfloor", "⌋"}, {"lvert", "|"},  {"rvert", "|"},   {"lVert", "‖"},  {"rVert", "‖"},  {"prime", "′"}}};
// Operators whose limits stand below and above them where the formula has a line of its own.
constexpr std::array<TexSign, 3> texSums{{{"sum", "∑"}, {"prod", "∏"}, {"int", "∫"}}};

template <std::size_t count> std::string_view textIn(const std::array<TexSign, count>& signs, std::string_view name)
{
    const auto found =
        std::find_if(signs.begin(), signs.end(), [name](const TexSign& each) { return each.name == name; });
    return found == signs.end() ? std::string_view() : found->text;
}

std::string texElement(std::string_view name, std::string_view content)
{
    std::string text;
    ((((text += '<') += name) += '>') += content) += "</";
    return (text += name.substr(0, name.find(' '))) += '>';
}

std::string escapedSign(char sign)
{
    return sign == '<' ? "&lt;" : sign == '>' ? "&gt;" : sign == '&' ? "&amp;" : std::string(1, sign);
}

/// Writes a sign as an operator. Brackets keep the size of the text, as in TeX: MathML would stretch them over indices.
std::string texOperator(std::string_view sign)
{
    constexpr std::array<std::string_view, 10> brackets{"(", ")", "[", "]", "{", "}", "|", "⌊", "⌋", "‖"};
    const bool isBracket = std::find(brackets.begin(), brackets.end(), sign) != brackets.end();
    return texElement(isBracket ? "mo stretchy=\"false\"" : "mo", sign);
}

/// Reader of one formula. Reading stops at the first problem.
class TexReader {
public:
    TexReader(std::string_view tex, bool isDisplayed) : tex_(tex), isDisplayed_(isDisplayed) {}

    TexFormula read()
    {
        const std::string row = this->row(false);
        TexFormula formula{{}, problem_, problemAt_};
        if (!problem_.empty()) return formula;
        if (row.empty()) return {{}, message("the formula is empty; write it between the signs $"), 0};
        formula.mathMl = (isDisplayed_ ? "<math display=\"block\">" : "<math>") + row + "</math>";
        return formula;
    }

private:
    [[nodiscard]] bool atEnd() const { return at_ >= tex_.size() || !problem_.empty(); }

    void fail(std::size_t at, Message problem)
    {
        if (!problem_.empty()) return;
        problem_ = std::move(problem);
        problemAt_ = at;
    }

    void skipSpace()
    {
        while (at_ < tex_.size() && std::isspace(static_cast<unsigned char>(tex_[at_]))) ++at_;
    }

    /// Reads signs up to the end of the group, or of the formula.
    std::string row(bool isGroup)  // NOLINT(misc-no-recursion): At most `deepestGroup` deep.
    {
        const std::size_t begin = at_;
        std::string text;
        for (skipSpace(); !atEnd(); skipSpace()) {
            if (tex_[at_] == '}') {
                if (isGroup) break;
                fail(at_, message("there is a \"}\" without its \"{\"; remove it"));
                break;
            }
            text += withScripts();
        }
        if (isGroup && at_ >= tex_.size())
            fail(begin > 0 ? begin - 1 : 0, message("this \"{\" is not closed; write a \"}\""));
        return text;
    }

    /// Reads a group in braces, or one sign. `command`: what it belongs to, for messages.
    std::string argument(std::string_view command)  // NOLINT(misc-no-recursion)
    {
        skipSpace();
        if (atEnd() || tex_[at_] == '}') {
            fail(std::min(at_, tex_.size()), message("after {1} something is missing; write it in braces", command));
            return {};
        }
        if (tex_[at_] != '{') return sign();
        if (++depth_ > deepestGroup) {
            fail(at_, message("braces are nested more than {1} deep; make the formula simpler", deepestGroup));
            return {};
        }
        ++at_;
        std::string group = texElement("mrow", row(true));
        ++at_;
        --depth_;
        return group;
    }

    /// Reads a sign with what stands below and above it.
    std::string withScripts()  // NOLINT(misc-no-recursion)
    {
        const bool isSum = startsWithSum();
        const std::string base = tex_[at_] == '{' ? argument("{") : sign();
        std::string below, above;
        for (skipSpace(); !atEnd() && (tex_[at_] == '_' || tex_[at_] == '^'); skipSpace()) {
            const bool isBelow = tex_[at_] == '_';
            std::string& place = isBelow ? below : above;
            if (!place.empty()) {
                fail(at_,
                     message("there are two of {1} in a row; put the first part into braces", isBelow ? "_" : "^"));
                return {};
            }
            ++at_;
            place = argument(isBelow ? "_" : "^");
        }
        const bool isOver = isSum && isDisplayed_;
        if (below.empty() && above.empty()) return base;
        if (above.empty()) return texElement(isOver ? "munder" : "msub", base + below);
        if (below.empty()) return texElement(isOver ? "mover" : "msup", base + above);
        return texElement(isOver ? "munderover" : "msubsup", base + below + above);
    }

    [[nodiscard]] bool startsWithSum() const { return tex_[at_] == '\\' && !textIn(texSums, nameAt(at_ + 1)).empty(); }

    [[nodiscard]] std::string_view nameAt(std::size_t at) const
    {
        std::size_t end = at;
        while (end < tex_.size() && std::isalpha(static_cast<unsigned char>(tex_[end]))) ++end;
        return tex_.substr(at, end - at);
    }

    std::string sign()  // NOLINT(misc-no-recursion)
    {
        const char c = tex_[at_];
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\\') return command();
        if (std::isdigit(byte)) {
            const std::size_t begin = at_;
            while (at_ < tex_.size() && (std::isdigit(static_cast<unsigned char>(tex_[at_])) || isPoint(at_))) ++at_;
            return texElement("mn", tex_.substr(begin, at_ - begin));
        }
        if (std::isalpha(byte)) return texElement("mi", tex_.substr(at_++, 1));
        if (c == '-') return ++at_, texElement("mo", "−");
        if (c == '\'') return ++at_, texElement("mo", "′");
        if (std::string_view("+=<>/()[]|,.:;!*").find(c) != std::string_view::npos)
            return ++at_, texOperator(escapedSign(c));
        if (byte >= 0x80) return wholeSign();
        fail(at_,
             message("the sign {1} is not known in formulas; the manual lists those that are", Message::verbatim({c})));
        return {};
    }

    /// Returns whether a point in a number is there.
    [[nodiscard]] bool isPoint(std::size_t at) const
    {
        return tex_[at] == '.' && at + 1 < tex_.size() && std::isdigit(static_cast<unsigned char>(tex_[at + 1]));
    }

    /// Takes a sign of several bytes (UTF-8) as it is.
    std::string wholeSign()
    {
        const std::size_t begin = at_++;
        while (at_ < tex_.size() && (static_cast<unsigned char>(tex_[at_]) & 0xc0U) == 0x80U) ++at_;
        return texElement("mi", tex_.substr(begin, at_ - begin));
    }

    std::string command()  // NOLINT(misc-no-recursion)
    {
        const std::size_t begin = at_++;
        const std::string_view name = nameAt(at_);
        at_ += name.size();
        if (name.empty()) return escapedCommand(begin);
        if (name == "frac") {
            const std::string above = argument("\\frac");
            return texElement("mfrac", above + argument("\\frac"));
        }
        if (name == "sqrt") return texElement("msqrt", argument("\\sqrt"));
        if (name == "text") return texElement("mtext", words(begin));
        if (name == "mathrm") return texElement("mi mathvariant=\"normal\"", words(begin));
        if (name == "mathbf") return texElement("mi mathvariant=\"bold\"", words(begin));
        if (name == "quad") return "<mspace width=\"1em\"></mspace>";
        if (name == "left" || name == "right") return atEnd() ? std::string() : sign();
        for (const std::string_view text : {textIn(texSums, name), textIn(texOperators, name)})
            if (!text.empty()) return texOperator(text);
        if (const std::string_view letter = textIn(texLetters, name); !letter.empty()) return texElement("mi", letter);
        if (std::find(texFunctions.begin(), texFunctions.end(), name) != texFunctions.end())
            return texElement("mi mathvariant=\"normal\"", name);
        fail(begin, message("the command \\{1} is not known in formulas; the manual lists those that are", name));
        return {};
    }

    /// Reads a command of one sign: "\,", "\{" and the like.
    std::string escapedCommand(std::size_t begin)
    {
        const char c = at_ < tex_.size() ? tex_[at_] : '\0';
        if (c == ',' || c == ';' || c == ' ') return ++at_, "<mspace width=\"0.2em\"></mspace>";
        if (std::string_view("{}%#_$&").find(c) != std::string_view::npos && c != '\0')
            return ++at_, texOperator(escapedSign(c));
        fail(begin, message("this \\ begins no command; the manual lists those that are known"));
        return {};
    }

    /// Reads a text in braces as it is.
    std::string words(std::size_t begin)
    {
        const std::size_t end = tex_.find('}', at_);
        if (at_ >= tex_.size() || tex_[at_] != '{' || end == std::string_view::npos) {
            fail(begin, message("the text of this command is missing; write it in braces"));
            return {};
        }
        std::string text;
        for (const char c : tex_.substr(at_ + 1, end - at_ - 1)) text += escapedSign(c);
        at_ = end + 1;
        return text;
    }

    std::string_view tex_;
    bool isDisplayed_;
    std::size_t at_ = 0, problemAt_ = 0;
    int depth_ = 0;
    Message problem_;
};

}  // namespace

TexFormula mathMlOfTex(std::string_view tex, bool isDisplayed)
{
    return TexReader(tex, isDisplayed).read();
}

}  // namespace vitrine
