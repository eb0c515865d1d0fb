#pragma once

#include "exhibits/your_shader/guest_shader.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine::guest {

/// A shader, or the errors why there is none.
struct ReadShader {
    std::shared_ptr<const Shader> shader;  ///< Null if there is any error.
    std::vector<Finding> errors;
    bool fileRead = true;  ///< False if the file itself could not be read.
};

/// Returns the text of a file beside the shader, given its path relative to the shader's folder. Throws Failure.
using FileBeside = std::function<std::string(const std::string& path)>;

/// Reads a shader of any form. The content decides which form it is: JSON in the first comment is ISF, JSON alone or
/// `mainImage` is Shadertoy, and everything else is a plain fragment shader. `name` is the file's name for messages;
/// its vertex shader is the file beside it with the ending ".vs". Compiles nothing, and throws nothing for a bad text.
[[nodiscard]] ReadShader readShader(std::string text, const std::string& name, const FileBeside& beside);

/// The same for a file. Files beside it are read from its folder and the folders below, and never through a link.
[[nodiscard]] ReadShader readShaderFile(const std::filesystem::path&);

/// The same for a text that will take the place of the file.
[[nodiscard]] ReadShader readShaderText(std::string text, const std::filesystem::path&);

}  // namespace vitrine::guest
