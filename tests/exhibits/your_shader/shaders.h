#pragma once

#include "exhibits/your_shader/shader_check.h"

#include <map>
#include <string>

// Sources and helpers that the tests of visitors' shaders use.
namespace vitrine::test {

/// Files beside a shader, by name.
using Beside = std::map<std::string, std::string>;

/// Reads and translates a text as if it stood in a file "own.fs".
[[nodiscard]] guest::CheckedShader checked(const std::string& text, const Beside& beside = {});

/// Returns the errors as "file:line:column: sentence", each with a newline.
[[nodiscard]] std::string errorsOf(const guest::CheckedShader&);

/// Returns an ISF shader with this JSON head and this body of `main`.
[[nodiscard]] std::string isf(const std::string& head, const std::string& body = "gl_FragColor = vec4(1.0);");

}  // namespace vitrine::test
