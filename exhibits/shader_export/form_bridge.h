#pragma once

#include "exhibits/shader_export/exported_shader.h"

#include <string>
#include <vector>

namespace vitrine::guest {

/// Variable of the old form that a shader reads, and its value in words of the new form.
struct BridgedVariable {
    std::string type, name, value;
    int count = 0;  ///< Length of an array, whose elements are equal; 0: no array.
};

/// Expressions that give the built-in values in the new form, such as "RENDERSIZE"; empty: it has none.
struct FormWords {
    std::string size;  ///< vec2, pixels.
    std::string time, delta, frame, date;
    std::string normalized;  ///< vec2, 0 to 1.
    std::string pass;        ///< int.
    std::string pointer;     ///< vec2, 0 to 1.
    std::string pressed;     ///< bool.
    bool dateFrom0 = false;  ///< Whether months count from 0.
};

[[nodiscard]] const FormWords& isfWords();
[[nodiscard]] const FormWords& shadertoyWords();

/// Returns the variables that the code of a pass reads.
[[nodiscard]] std::vector<BridgedVariable> bridgedVariables(const ExportedShader&, const Pass&, const FormWords&);

/// Returns declarations of the variables: "float iTime;".
[[nodiscard]] std::string declarationsOf(const std::vector<BridgedVariable>&);
/// Returns assignments, each with four blanks before it: "    iTime = TIME;".
[[nodiscard]] std::string assignmentsOf(const std::vector<BridgedVariable>&, const std::string& indent);

}  // namespace vitrine::guest
