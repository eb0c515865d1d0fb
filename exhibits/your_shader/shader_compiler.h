#pragma once

#include "exhibits/your_shader/compiler/protocol.h"
#include "render/text/message.h"

#include <sys/types.h>

#include <chrono>

namespace vitrine::guest {

/// Compiler of visitors' shaders in a process of its own, vitrine_shader_compiler. The process is started with the
/// first request and kept for further ones. If it ends or hangs, the request gets a sentence, and the next request
/// starts it again. Not for several threads at a time.
///
/// Its limit is processor time (mostProcessorSeconds), which does not depend on the machine's load: 19 of 20 shaders of
/// the public ISF collection take less than 4 ms. A wall clock only looks for a process that hangs.
class ShaderCompiler {
public:
    struct Limits {
        /// Time without an answer in which the process uses no processor time; after it, the process hangs.
        std::chrono::milliseconds longestStall{30'000};
        double secondsOfAllPasses = 10;  ///< Processor time for all passes of a shader together.
    };
    ShaderCompiler() : ShaderCompiler(Limits()) {}
    explicit ShaderCompiler(const Limits& limits) : limits_(limits) {}
    ~ShaderCompiler() { stop(); }
    ShaderCompiler(const ShaderCompiler&) = delete;
    ShaderCompiler& operator=(const ShaderCompiler&) = delete;

    [[nodiscard]] const Limits& limits() const { return limits_; }

    /// Answer of the compiler, or the reason why there is none: a sentence.
    struct Result {
        CompilerAnswer answer;
        Message problem;
        double processorSeconds = 0;  ///< Processor time of the request, if there is an answer.
    };
    /// Translates one pass. A request whose process hangs or is killed by another program is sent a second time.
    [[nodiscard]] Result compile(const CompilerRequest&);

private:
    enum class End { answered, ended, hung };

    void start();
    void stop();
    /// Returns how a request ended. `result` has an answer after `answered`; after `ended`, a sentence unless another
    /// program killed the process.
    [[nodiscard]] End tryOnce(const CompilerRequest&, Result& result);
    /// Sends or receives all bytes. Returns `answered` when that is done.
    [[nodiscard]] End send(const std::string& bytes);
    [[nodiscard]] End receive(void* to, std::size_t size);
    /// Waits for an event of the socket (POLLIN, POLLOUT). Returns false if the process hangs.
    [[nodiscard]] bool waitFor(short event);
    /// Returns the processor time of the process, in seconds.
    [[nodiscard]] double processorSeconds() const;
    /// Waits for the end of the process and says why it ended; empty if another program killed it.
    [[nodiscard]] Message endOfProcess();

    Limits limits_;
    pid_t process_ = -1;
    int socket_ = -1;
};

}  // namespace vitrine::guest
