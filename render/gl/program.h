#pragma once

#include "render/gl/object.h"
#include "render/glsl/shader_source.h"
#include "render/plan/frame_plan.h"

#include <string>
#include <vector>

namespace vitrine::render::gl {

/// What building a program came to.
struct BuiltProgram {
    ProgramName program;             ///< Empty when it failed.
    std::vector<std::string> files;  ///< Every shader file it is made of, for hot reload.
    ShaderMessage problem;           ///< When it failed.
    bool fromCache = false;
};

/// Compiles and links, or takes the linked binary from the user's cache folder when driver and source
/// are the same as last time. Never throws for a broken shader; see `problem`.
[[nodiscard]] BuiltProgram buildProgram(const ShaderSource&, const ShaderKey&);

/// "sdf_morph/march.frag [GLASS 1]".
[[nodiscard]] std::string describe(const ShaderKey&);

}  // namespace vitrine::render::gl
