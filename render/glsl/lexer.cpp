#include "render/glsl/lexer.h"

#include "render/files/byte_order_mark.h"
#include "render/text/trimmed.h"

#include <algorithm>

namespace vitrine::render {
namespace {

bool isWordStart(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}
bool isWord(char c)
{
    return isWordStart(c) || isDigit(c);
}

/// Cuts a text into tokens.
class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> run()
    {
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const
    {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    void step()
    {
        const char c = peek();
        if (c == '\n') {
            newline();
        } else if (c == '\\' && peek(1) == '\n') {
            at_ += 2;
            ++line_;
        } else if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
            ++at_;
        } else if (c == '/' && peek(1) == '/') {
            lineComment();
        } else if (c == '/' && peek(1) == '*') {
            blockComment();
        } else {
            token(c);
        }
    }
    void newline()
    {
        ++at_;
        ++line_;
        directive_ = 0;
        lineBegins_ = true;
    }
    void lineComment()
    {
        while (at_ < text_.size() && peek() != '\n') {
            const bool goesOn = peek() == '\\' && peek(1) == '\n';
            if (goesOn) ++line_;
            at_ += goesOn ? 2 : 1;
        }
    }
    void blockComment()
    {
        const std::size_t close = text_.find("*/", at_ + 2);
        const std::size_t end = close == std::string_view::npos ? text_.size() : close + 2;
        line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                             text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        at_ = end;
    }
    void token(char c)
    {
        if (c == '#' && lineBegins_) directive_ = ++directives_;
        lineBegins_ = false;
        const std::size_t begin = at_;
        Token::Kind kind = Token::Kind::symbol;
        if (isWordStart(c)) {
            kind = Token::Kind::word;
            while (isWord(peek())) ++at_;
        } else if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
            kind = Token::Kind::number;
            number();
        } else if (c == '"' && directive_ != 0) {
            kind = Token::Kind::text;
            const std::size_t close = text_.find_first_of("\"\n", at_ + 1);
            const bool closed = close != std::string_view::npos && text_[close] == '"';
            at_ = closed ? close + 1 : std::min(close, text_.size());
        } else {
            ++at_;
        }
        tokens_.push_back({.kind = kind,
                           .begin = static_cast<std::uint32_t>(begin),
                           .end = static_cast<std::uint32_t>(at_),
                           .line = line_,
                           .directive = directive_});
    }
    void number()
    {
        // "0x1F" and "1e-3" as well as "1.5f".
        const bool hex = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
        while (isWord(peek()) || (peek() == '.' && peek(1) != '.')) {
            const bool exponent = !hex && (peek() == 'e' || peek() == 'E') && (peek(1) == '-' || peek(1) == '+');
            at_ += exponent ? 2 : 1;
        }
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::uint32_t directive_ = 0, directives_ = 0;
    bool lineBegins_ = true;
};

}  // namespace

Tokens::Tokens(std::string_view text) : text_(text), tokens_(Lexer(text).run()) {}

std::string_view Tokens::commentBehind(std::size_t i) const
{
    if (i >= tokens_.size()) return {};
    const std::string_view rest = text_.substr(tokens_[i].end);
    const std::size_t begin = rest.find_first_not_of(" \t");
    if (begin == std::string_view::npos || rest.substr(begin, 2) != "//") return {};
    const std::string_view comment = rest.substr(begin + 2);
    return trimmed(comment.substr(0, comment.find('\n')), " \t");
}

std::size_t Tokens::lineEnd(std::size_t i) const
{
    std::size_t end = i;
    while (end < tokens_.size() && tokens_[end].directive == tokens_[i].directive) ++end;
    return end;
}

bool Tokens::contains(std::string_view word) const
{
    for (std::size_t i = 0; i < tokens_.size(); ++i)
        if (tokens_[i].kind == Token::Kind::word && text(i) == word) return true;
    return false;
}

int columnOf(std::string_view text, int line, std::string_view word)
{
    std::size_t begin = 0;
    for (int n = 1; n < line && begin != std::string_view::npos; ++n) {
        begin = text.find('\n', begin);
        if (begin != std::string_view::npos) ++begin;
    }
    if (begin == std::string_view::npos || begin > text.size()) return 1;
    const std::string_view rest = text.substr(begin);
    const std::string_view here = rest.substr(0, rest.find('\n'));
    const std::size_t first = here.find_first_not_of(" \t");
    const int fallback = first == std::string_view::npos ? 1 : static_cast<int>(first) + 1;
    if (word.empty()) return fallback;
    for (std::size_t at = here.find(word); at != std::string_view::npos; at = here.find(word, at + 1)) {
        const bool isName = isWordStart(word.front());
        const bool startsInside = isName && at > 0 && isWord(here[at - 1]);
        const bool endsInside = isName && at + word.size() < here.size() && isWord(here[at + word.size()]);
        if (!startsInside && !endsInside) return static_cast<int>(at) + 1;
    }
    return fallback;
}

std::string withPlainLineEnds(std::string text)
{
    text = withoutByteOrderMark(std::move(text));
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r') {
            plain += text[i];
        } else if (i + 1 == text.size() || text[i + 1] != '\n') {
            plain += '\n';
        }
    }
    return plain;
}

}  // namespace vitrine::render
