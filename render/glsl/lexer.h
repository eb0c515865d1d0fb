#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Token of a GLSL text. Comments and blanks are none.
struct Token {
    enum class Kind : std::uint8_t { word, number, symbol, text };
    Kind kind = Kind::symbol;
    std::uint32_t begin = 0, end = 0;  ///< Range of bytes.
    int line = 1;                      ///< From 1, in the text.
    std::uint32_t directive = 0;       ///< Number of its preprocessor line, from 1; 0 outside of them.
};

/// Tokens of a text, which must outlive them.
class Tokens {
public:
    explicit Tokens(std::string_view text);

    [[nodiscard]] std::size_t size() const { return tokens_.size(); }
    [[nodiscard]] const Token& operator[](std::size_t i) const { return tokens_[i]; }
    /// Returns the text of a token; empty beyond the end.
    [[nodiscard]] std::string_view text(std::size_t i) const
    {
        return i < tokens_.size() ? text_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin) : "";
    }
    [[nodiscard]] std::string_view whole() const { return text_; }
    /// Returns the `//` comment behind a token in the same line, without its slashes and blanks at the ends.
    [[nodiscard]] std::string_view commentBehind(std::size_t i) const;
    /// Returns the index behind the tokens of the same preprocessor line.
    [[nodiscard]] std::size_t lineEnd(std::size_t i) const;
    /// Returns whether a word occurs anywhere.
    [[nodiscard]] bool contains(std::string_view word) const;

private:
    std::string_view text_;
    std::vector<Token> tokens_;
};

/// Returns whether a word is a precision of GLSL ES, such as "highp".
[[nodiscard]] inline bool isPrecision(std::string_view word)
{
    return word == "highp" || word == "mediump" || word == "lowp";
}

/// Returns the column (from 1) where a word first stands in a line of the text; 1 if it does not.
[[nodiscard]] int columnOf(std::string_view text, int line, std::string_view word);

/// Returns the text with "\r\n" and "\r" replaced by "\n", and without a byte order mark.
[[nodiscard]] std::string withPlainLineEnds(std::string text);

}  // namespace vitrine::render
