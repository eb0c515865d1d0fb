#pragma once

#include "exhibits/your_shader/compiler/protocol.h"
#include "render/text/message.h"

#include <sys/types.h>

#include <chrono>

namespace vitrine::guest {

/// Compiler of visitors' shaders in a process of its own, vitrine_shader_compiler. The process is started with the
/// first request and kept for further ones. If it ends or takes too long, the request gets a sentence, and the next
/// request starts it again. Not for several threads at a time.
class ShaderCompiler {
public:
    ShaderCompiler() = default;
    ~ShaderCompiler() { stop(); }
    ShaderCompiler(const ShaderCompiler&) = delete;
    ShaderCompiler& operator=(const ShaderCompiler&) = delete;

    /// Answer of the compiler, or the reason why there is none: a sentence.
    struct Result {
        CompilerAnswer answer;
        Message problem;
    };
    /// Time for all passes of one shader, waiting included. The compiler ends itself after 2 s of processor time for a
    /// pass, of which 19 of 20 shaders of the public ISF collection take less than 4 ms. A busy machine needs longer.
    static constexpr std::chrono::seconds mostTime{30};
    /// Translates one pass. If there is no answer before `end`, the process is ended.
    [[nodiscard]] Result compile(const CompilerRequest&,
                                 std::chrono::steady_clock::time_point end = std::chrono::steady_clock::now() +
                                                                             mostTime);

private:
    void start();
    void stop();
    /// Waits for the end of the process and says why it ended.
    [[nodiscard]] Message endOfProcess();

    pid_t process_ = -1;
    int socket_ = -1;
};

}  // namespace vitrine::guest
