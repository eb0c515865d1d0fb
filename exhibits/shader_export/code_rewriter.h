#pragma once

#include "exhibits/your_shader/guest_shader.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// Code of a visitor, taken over into another form with its comments.
namespace vitrine::guest {

using Renaming = std::map<std::string, std::string, std::less<>>;

/// Name of the color that a picture's `main` writes in the new form.
inline constexpr const char* exportedColor = "pictureColor";
/// Name of the visitor's `main` or `mainImage` in the new form.
inline constexpr const char* exportedMain = "pictureMain";

/// Gives global names of the code that are those two another name, which ends with `ending`.
inline void freeExportedNames(const std::set<std::string>& names, Renaming& renaming, const std::string& ending = {})
{
    for (const std::string name : {exportedColor, exportedMain})
        if (names.contains(name)) renaming[name] = name + "Before" + ending;
}

/// Returns the code without what the new form writes anew: the JSON head, declarations of inputs and outputs, and
/// preprocessor lines of the old form. Words are renamed, except members behind a dot.
[[nodiscard]] std::string rewritten(const Shader&, const Code&, const Renaming&);

/// Returns the names that the code defines outside of functions: functions, variables, structs and macros.
[[nodiscard]] std::set<std::string> globalNames(const Code&);

/// Returns whether a word stands in the code, outside of comments.
[[nodiscard]] bool usesWord(const Code&, std::string_view word);

/// Returns the name of the output that a plain shader declares: `out vec4 color;`. Empty if it declares none.
[[nodiscard]] std::string outputName(const Code&);

/// Returns the `#version` line that other hosts and our reader need for words that were reserved in old GLSL, such as
/// "uint"; empty if the text needs none.
[[nodiscard]] std::string versionLine(const std::string& text);

/// Returns a number as a GLSL float.
[[nodiscard]] std::string floatText(double);

}  // namespace vitrine::guest
