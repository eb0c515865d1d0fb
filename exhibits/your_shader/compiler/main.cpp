// vitrine_shader_compiler: translates visitors' shaders, one request after another from standard input to standard
// output. It is a process of its own because a text of 1 kB can make glslang take gigabytes or fall. Its memory and its
// processor time are limited, so that only this process ends.
//
// Translation by way of SPIR-V, and not by replacing text, was chosen because of safety and errors: SPIR-V can be
// counted before a driver sees the program, every driver gets the same simple dialect with all variables initialized,
// and errors are those of one compiler. It costs 1.4 ms more than passing the text on.

#include "exhibits/your_shader/compiler/protocol.h"
#include "exhibits/your_shader/compiler/spirv_counts.h"

#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>
#include <spirv_cross_c.h>

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <memory>
#include <new>
#include <span>
#include <string>

namespace {

using namespace vitrine::guest;

constexpr rlim_t mostMemory = rlim_t{512} << 20U;

void limitMemory()
{
#if !defined(VITRINE_SANITIZED)  // AddressSanitizer reserves terabytes of addresses.
    const rlimit memory{mostMemory, mostMemory};
    ::setrlimit(RLIMIT_AS, &memory);
#endif
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

/// Lets SIGPROF end the process, whatever the program that started it does with that signal.
void obeyTimer()
{
    ::signal(SIGPROF, SIG_DFL);
    sigset_t timer;
    ::sigemptyset(&timer);
    ::sigaddset(&timer, SIGPROF);
    ::sigprocmask(SIG_UNBLOCK, &timer, nullptr);
}

/// Starts the processor time of the next request. RLIMIT_CPU would count in whole seconds.
void limitTime()
{
    const itimerval time{.it_interval = {}, .it_value = {.tv_sec = mostProcessorSeconds, .tv_usec = 0}};
    ::setitimer(ITIMER_PROF, &time, nullptr);
}

bool readAll(void* to, std::size_t size)
{
    for (auto* at = static_cast<char*>(to); size > 0;) {
        const ssize_t got = ::read(STDIN_FILENO, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

bool writeAll(const std::string& bytes)
{
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t put = ::write(STDOUT_FILENO, bytes.data() + at, bytes.size() - at);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        at += static_cast<std::size_t>(put);
    }
    return true;
}

struct ShaderDelete {
    void operator()(glslang_shader_t* shader) const { glslang_shader_delete(shader); }
    void operator()(glslang_program_t* program) const { glslang_program_delete(program); }
};
using OwnedShader = std::unique_ptr<glslang_shader_t, ShaderDelete>;
using OwnedProgram = std::unique_ptr<glslang_program_t, ShaderDelete>;

glslang_input_t inputOf(const std::string& text, glslang_stage_t stage)
{
    glslang_input_t input{};
    input.language = GLSLANG_SOURCE_GLSL;
    input.stage = stage;
    input.client = GLSLANG_CLIENT_OPENGL;
    input.client_version = GLSLANG_TARGET_OPENGL_450;
    input.target_language = GLSLANG_TARGET_SPV;
    input.target_language_version = GLSLANG_TARGET_SPV_1_0;
    input.code = text.c_str();
    input.default_version = 450;
    input.default_profile = GLSLANG_CORE_PROFILE;
    input.messages = GLSLANG_MSG_SPV_RULES_BIT;
    input.resource = glslang_default_resource();
    return input;
}

/// Returns the parsed shader, or null after adding the errors to the log.
OwnedShader parsed(const std::string& text, glslang_stage_t stage, std::string& log)
{
    const glslang_input_t input = inputOf(text, stage);
    OwnedShader shader(glslang_shader_create(&input));
    glslang_shader_set_options(shader.get(), GLSLANG_SHADER_AUTO_MAP_BINDINGS | GLSLANG_SHADER_AUTO_MAP_LOCATIONS);
    if (glslang_shader_preprocess(shader.get(), &input) != 0 && glslang_shader_parse(shader.get(), &input) != 0)
        return shader;
    log += glslang_shader_get_info_log(shader.get());
    return nullptr;
}

/// Sets the dialect that SPIRV-Cross writes.
bool setDialect(spvc_compiler_options options, bool forWeb)
{
    const auto set = [&](spvc_compiler_option option) {
        return spvc_compiler_options_set_bool(options, option, SPVC_TRUE) == SPVC_SUCCESS;
    };
    const unsigned version = forWeb ? 300 : 450;
    return spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION, version) == SPVC_SUCCESS &&
           set(SPVC_COMPILER_OPTION_FORCE_ZERO_INITIALIZED_VARIABLES) &&
           (!forWeb ||
            (set(SPVC_COMPILER_OPTION_GLSL_ES) && set(SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_FLOAT_PRECISION_HIGHP) &&
             set(SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_INT_PRECISION_HIGHP)));
}

/// Returns the GLSL that SPIRV-Cross makes, or an empty text and the reason.
std::string crossed(std::span<const std::uint32_t> words, bool forWeb, std::string& problem)
{
    spvc_context context = nullptr;
    if (spvc_context_create(&context) != SPVC_SUCCESS) throw std::bad_alloc();
    spvc_parsed_ir ir = nullptr;
    spvc_compiler compiler = nullptr;
    spvc_compiler_options options = nullptr;
    const char* text = nullptr;
    const bool good = spvc_context_parse_spirv(context, words.data(), words.size(), &ir) == SPVC_SUCCESS &&
                      spvc_context_create_compiler(context, SPVC_BACKEND_GLSL, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                                   &compiler) == SPVC_SUCCESS &&
                      spvc_compiler_create_compiler_options(compiler, &options) == SPVC_SUCCESS &&
                      setDialect(options, forWeb) &&
                      spvc_compiler_install_compiler_options(compiler, options) == SPVC_SUCCESS &&
                      spvc_compiler_compile(compiler, &text) == SPVC_SUCCESS;
    std::string result = good ? text : "";
    if (!good) problem = spvc_context_get_last_error_string(context);
    spvc_context_destroy(context);
    return result;
}

/// Returns the SPIR-V of one stage. glslang 12 keeps what it made of the stage before, at the front.
std::span<const std::uint32_t> spirvOf(glslang_program_t* program, glslang_stage_t stage)
{
    constexpr std::uint32_t magic = 0x07230203;
    const std::size_t before = glslang_program_SPIRV_get_size(program);
    glslang_program_SPIRV_generate(program, stage);
    const std::span<const std::uint32_t> words(glslang_program_SPIRV_get_ptr(program),
                                               glslang_program_SPIRV_get_size(program));
    return before < words.size() && words[before] == magic ? words.subspan(before) : words;
}

std::string translated(glslang_program_t* program, glslang_stage_t stage, bool forWeb, CompilerAnswer& answer)
{
    const std::span<const std::uint32_t> words = spirvOf(program, stage);
    const ProgramCounts counts = spirvCounts(words);
    answer.counts.instructions += counts.instructions;
    answer.counts.localBytes += counts.localBytes;
    answer.counts.samplers = std::max(answer.counts.samplers, counts.samplers);
    answer.counts.recursive = answer.counts.recursive || counts.recursive;
    // A program that is refused for its size would take as long here as in a driver.
    if (answer.counts.areTooLarge()) return "";
    return crossed(words, forWeb, answer.problem);
}

CompilerAnswer answerTo(const CompilerRequest& request)
{
    CompilerAnswer answer;
    const OwnedShader vertex = parsed(request.vertex, GLSLANG_STAGE_VERTEX, answer.log);
    const OwnedShader fragment = parsed(request.fragment, GLSLANG_STAGE_FRAGMENT, answer.log);
    if (!vertex || !fragment) return answer;
    // Both stages in one program, so that the locations of what they share agree.
    const OwnedProgram program(glslang_program_create());
    glslang_program_add_shader(program.get(), vertex.get());
    glslang_program_add_shader(program.get(), fragment.get());
    if (glslang_program_link(program.get(), GLSLANG_MSG_SPV_RULES_BIT) == 0 ||
        glslang_program_map_io(program.get()) == 0) {
        answer.log += glslang_program_get_info_log(program.get());
        return answer;
    }
    answer.vertex = translated(program.get(), GLSLANG_STAGE_VERTEX, request.forWeb, answer);
    answer.fragment = translated(program.get(), GLSLANG_STAGE_FRAGMENT, request.forWeb, answer);
    return answer;
}

/// Answers one request. Returns false at the end of the input.
bool serveOne()
{
    std::uint32_t size = 0;
    if (!readAll(&size, sizeof size) || size > mostMessageBytes) return false;
    std::string bytes(size, '\0');
    if (!readAll(bytes.data(), size)) return false;
    const auto request = unpackedRequest(bytes);
    if (!request) return false;
    limitTime();
    const std::string answer = packed(answerTo(*request));
    const auto length = static_cast<std::uint32_t>(answer.size());
    return writeAll(std::string(reinterpret_cast<const char*>(&length), sizeof length) + answer);
}

}  // namespace

int main()
{
    limitMemory();
    obeyTimer();
    try {
        if (glslang_initialize_process() == 0) return 1;
        while (serveOne()) {
        }
    } catch (const std::bad_alloc&) {
        ::_exit(outOfMemoryCode);
    }
    glslang_finalize_process();
    return 0;
}
