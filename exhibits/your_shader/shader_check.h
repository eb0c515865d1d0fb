#pragma once

#include "exhibits/your_shader/guest_reader.h"
#include "exhibits/your_shader/shader_compiler.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::guest {

/// Programs of a shader, one for each pass: GLSL 4.50 that every driver reads.
struct PassProgram {
    std::string vertex, fragment;
    ProgramCounts counts;
};

/// A shader that can be drawn, or the errors why it cannot.
struct CheckedShader {
    std::shared_ptr<const Shader> shader;  ///< Null if it could not be read.
    std::vector<PassProgram> programs;     ///< One for each pass; empty after an error.
    std::vector<Finding> errors;
    bool fileRead = true;

    [[nodiscard]] bool isGood() const { return errors.empty(); }
};

/// Translates a shader that was read: the passes become programs with a guard in every loop.
[[nodiscard]] CheckedShader translate(ReadShader, ShaderCompiler&);

/// Programs of a shader in GLSL ES 3.00, one for each pass, or the errors why there are none.
struct WebPrograms {
    std::vector<PassProgram> programs;
    std::vector<Finding> errors;
};
/// The same for WebGL 2.
[[nodiscard]] WebPrograms translateForWeb(std::shared_ptr<const Shader>, ShaderCompiler&);

/// Reads and translates a file, and looks for the pictures that it names. Its errors are those that keep it from being
/// drawn.
[[nodiscard]] CheckedShader checkShaderFile(const std::filesystem::path&, ShaderCompiler&);

}  // namespace vitrine::guest
