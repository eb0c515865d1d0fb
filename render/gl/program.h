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

/// The same in two steps, for drivers that build while the program goes on (GL_KHR_parallel_shader_compile).
class PendingProgram {
public:
    /// Hands the sources to the driver.
    PendingProgram(const ShaderSource&, const ShaderKey&);
    /// Whether `take` would not wait.
    [[nodiscard]] bool done() const;
    [[nodiscard]] BuiltProgram take();
    void abandon();

private:
    struct Stage {
        ShaderName shader;
        ShaderText source;
    };
    BuiltProgram built_;
    std::string everything_;  ///< The sources: what the binary is kept by.
    ProgramName program_;     ///< While it is being built.
    std::vector<Stage> stages_;
};

/// Whether the driver of the current context builds several programs at once while others draw.
[[nodiscard]] bool buildsInParallel();

/// "kit/sdf/march.frag [GLASS]".
[[nodiscard]] std::string describe(const ShaderKey&);

}  // namespace vitrine::render::gl
