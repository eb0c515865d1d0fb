#pragma once

#include "render/gl/object.h"
#include "render/glsl/shader_source.h"
#include "render/plan/frame_plan.h"

#include <string>
#include <vector>

namespace vitrine::render::gl {

/// Result of building a program.
struct BuiltProgram {
    ProgramName program;             ///< Empty when it failed.
    std::vector<std::string> files;  ///< Every shader file that it includes, for hot reload.
    ShaderMessage problem;           ///< Set if the build failed.
    bool fromCache = false;
    double seconds = 0;  ///< Time that the calling thread needed, or waited for the driver.
};

/// Compiles and links the program, or loads the linked binary from the user's cache folder if driver and source are the
/// same as last time. Never throws for a broken shader; see `problem`.
[[nodiscard]] BuiltProgram buildProgram(const ShaderSource&, const ShaderKey&);

/// The same in two steps, for drivers that compile in the background (GL_KHR_parallel_shader_compile).
class PendingProgram {
public:
    /// Hands the sources to the driver.
    PendingProgram(const ShaderSource&, const ShaderKey&);
    /// Returns true if `take` will not block.
    [[nodiscard]] bool done() const;
    [[nodiscard]] BuiltProgram take();
    void abandon();

private:
    void hand(const ShaderSource&, const ShaderKey&);
    void finish();

    struct Stage {
        ShaderName shader;
        ShaderText source;
    };
    BuiltProgram built_;
    std::string everything_;  ///< All sources; the cached binary is found by their hash.
    ProgramName program_;     ///< Set while it is being built.
    std::vector<Stage> stages_;
};

/// Returns whether the driver of the current context compiles several programs in the background.
[[nodiscard]] bool buildsInParallel();

/// Lets the driver of the current context use as many threads as it wants for that.
void allowBuildThreads();

/// Returns a readable name: "kit/sdf/march.frag [GLASS]".
[[nodiscard]] std::string describe(const ShaderKey&);

}  // namespace vitrine::render::gl
