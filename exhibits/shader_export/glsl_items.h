#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// Text of an exhibit's shader, reduced to what one permutation of it needs.
namespace vitrine::guest {

/// Declaration or definition outside of functions, or a macro.
struct GlslItem {
    std::string text;               ///< With the comments before it and behind it.
    std::set<std::string> names;    ///< Names that it defines.
    std::set<std::string> words;    ///< All words in it.
    std::set<std::string> members;  ///< Words behind a dot.
    std::set<std::string> pairs;    ///< "parameters.radius": a word, a dot and the member.
    bool isMacro = false;
};

/// Macros without parameters, by name.
using GlslMacros = std::map<std::string, std::string, std::less<>>;

/// Returns the lines of a shader that `#if`, `#ifdef` and their like keep, without these lines, `#line` and `#version`.
/// Fills `macros`. Throws Failure (ErrorKind::shader) for a condition that it does not understand.
[[nodiscard]] std::string withoutConditions(std::string_view text, GlslMacros& macros);

/// Splits a text without conditions.
[[nodiscard]] std::vector<GlslItem> itemsOf(const std::string& text);

/// Returns the items that `roots` need, in their order.
[[nodiscard]] std::vector<GlslItem> neededItems(const std::vector<GlslItem>&, const std::set<std::string>& roots);

/// Returns a whole number that a macro or a text stands for. Throws Failure (ErrorKind::shader) if it is none.
[[nodiscard]] int wholeNumber(const GlslMacros&, const std::string& text);

}  // namespace vitrine::guest
