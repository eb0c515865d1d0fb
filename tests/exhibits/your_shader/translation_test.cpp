// Programs that are made of visitors' shaders: old GLSL, errors in the visitor's numbering, and attacks.

#include "exhibits/your_shader/guest_glsl.h"
#include "render/failure.h"
#include "tests/exhibits/your_shader/shaders.h"

#include <gtest/gtest.h>

#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

namespace vitrine {
namespace {

using test::checked;
using test::errorsOf;
using test::isf;

TEST(OldGlsl, IsRead)
{
    // Reserved words as names, old functions, overloaded built-ins, numbers of both kinds, CRLF, a BOM, and Latin-1.
    EXPECT_EQ(
        errorsOf(checked("\xEF\xBB\xBF/*{\"INPUTS\": [{\"NAME\": \"buffer\", \"TYPE\": \"image\"}, {\"NAME\": "
                         "\"filter\", \"TYPE\": \"float\"}]}*/\r\n"
                         "#version 120\r\n#extension GL_ARB_texture_rectangle : enable\r\n// caf\xE9 \\\r\n"
                         "float round(float x) { return floor(x + 0.5); }\r\n"
                         "float smooth(float sample) { return sample * 2.0; }\r\n"
                         "const vec4 patch = vec4(1);\r\n"
                         "void main()\r\n{\r\n    float common = smooth(round(filter));\r\n    int active = 3;\r\n"
                         "    vec4 input = texture2D(buffer, gl_FragCoord.xy / RENDERSIZE);\r\n"
                         "    gl_FragColor = input * patch * common / active;\r\n    gl_FragColor.a = 1;\r\n}\r\n")),
        "");
    EXPECT_EQ(errorsOf(checked(
                  "uniform sampler2D texture;\nvoid main() { gl_FragData[0] = texture2D(texture, vec2(0.5)); }")),
              "");
    // Words of today's GLSL keep their meaning where the text says so, or where they stand as types.
    EXPECT_EQ(
        errorsOf(checked("/*{}*/\nuvec2 size = uvec2(8, 16);\nconst uvec4 font[2] = uvec4[2](uvec4(1), uvec4(2));\n"
                         "void main() { gl_FragColor = vec4(mod(gl_FragCoord.xy, size), font[1].xy); }")),
        "");
    EXPECT_EQ(errorsOf(checked("/*{}*/\nvoid main() { float uint = 0.5; gl_FragColor = vec4(uint); }")), "");
    EXPECT_EQ(
        errorsOf(checked(
            "#version 430\nflat in int id;\nout vec4 color;\nvoid main() { uint x = 3u; color = vec4(float(x)); }")),
        "");
}

TEST(ShaderErrors, StandInTheVisitorsNumbering)
{
    EXPECT_EQ(errorsOf(checked(isf("\n\n\"ISFVSN\": \"2\"", "    gl_FragColor = vec4(radius);"))),
              "own.fs:5:25: The GLSL compiler says: 'radius' : undeclared identifier.\n");
    // A name that the program renames is shown as the visitor wrote it.
    EXPECT_EQ(errorsOf(checked(isf("", "    float x = 1.0; x = sample;"))),
              "own.fs:3:24: The GLSL compiler says: 'sample' : undeclared identifier.\n");
    EXPECT_EQ(errorsOf(checked("void mainImage(out vec4 c, in vec2 p)\n{\n\n  c = vec3(1.0);\n}\n")).substr(0, 9),
              "own.fs:4:");
    // The visitor's own #line and #version do not move it.
    EXPECT_EQ(errorsOf(checked("#version 120\n#line 500\nvoid main() {\n  gl_FragColor = here;\n}\n")).substr(0, 12),
              "own.fs:4:18:");
    EXPECT_EQ(errorsOf(checked("void main() {\n  gl_FragColor = vec4(1.0)\n}\n")).substr(0, 9), "own.fs:3:");
}

TEST(TranslatedPrograms, HaveTheNamesOfTheirBlocks)
{
    const guest::CheckedShader read = checked(
        isf("\"INPUTS\": [{\"NAME\": \"size\", \"TYPE\": \"float\"}, {\"NAME\": \"inputImage\", \"TYPE\": \"image\"}]",
            "gl_FragColor = size * TIME * IMG_THIS_PIXEL(inputImage);"));
    ASSERT_EQ(errorsOf(read), "");
    const std::string& fragment = read.programs[0].fragment;
    EXPECT_EQ(fragment.rfind("#version 450", 0), 0U);
    EXPECT_NE(fragment.find("layout(binding = 1, std140) uniform GuestInputs"), std::string::npos) << fragment;
    EXPECT_NE(fragment.find("layout(binding = 6, std140) uniform GuestFrame"), std::string::npos) << fragment;
    EXPECT_NE(fragment.find("binding = 0) uniform sampler2D inputImage"), std::string::npos) << fragment;
    EXPECT_GT(read.programs[0].counts.instructions, 5U);
    EXPECT_EQ(read.programs[0].counts.samplers, 1U);
}

/// Number of times that a text occurs in another.
std::size_t occurrences(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

TEST(LoopGuard, StandsInEveryLoop)
{
    const guest::CheckedShader read =
        checked("void main() { float x = 0.0; for (;;) { x += 1.0; if (x < 0.0) break; }\n"
                "while (x > 0.0) x += 1.0; do { x -= 1.0; } while (x < 1.0); gl_FragColor = vec4(x); }");
    ASSERT_EQ(errorsOf(read), "");
    EXPECT_EQ(occurrences(read.programs[0].fragment, "if (++guest_rounds > GUEST_ROUNDS) break;"), 3U);
    EXPECT_EQ(guest::withLoopGuard("#version 450\nvoid main()\n{\n    for (;;)\n        x();\n}\n"), "");
    EXPECT_EQ(guest::withLoopGuard("#version 450\nvoid main()\n{\n    do\n    {\n    } while (true);\n}\n"),
              "#version 450\nuint guest_rounds = 0u;\nvoid main()\n{\n    do\n    {\nif (++guest_rounds > "
              "GUEST_ROUNDS) break;\n "
              "   } while "
              "(true);\n}\n");
}

std::string callBomb(int functions)
{
    std::string text = "float f0(float x) { return sin(x); }\n";
    for (int i = 1; i < functions; ++i) {
        const std::string below = 'f' + std::to_string(i - 1);
        text += "float f" + std::to_string(i) + "(float x) { return " + below + "(x) + " + below + "(x + 1.0); }\n";
    }
    return text + "void main() { gl_FragColor = vec4(f" + std::to_string(functions - 1) + "(gl_FragCoord.x)); }\n";
}

std::string macroBomb()
{
    std::string macros = "#define A0 1.0+\n";
    for (int i = 1; i < 24; ++i) {
        const std::string below = " A" + std::to_string(i - 1);
        macros += "#define A" + std::to_string(i) + below + below + '\n';
    }
    return macros + "void main() { gl_FragColor = vec4(A23 1.0); }\n";
}

std::string manySamplers()
{
    std::string samplers = "\"INPUTS\": [";
    std::string sum = "gl_FragColor = vec4(0.0)";
    for (int i = 0; i < 17; ++i) {
        samplers += std::string(i > 0 ? ", " : "") + "{\"NAME\": \"i" + std::to_string(i) + "\", \"TYPE\": \"image\"}";
        sum += " + IMG_THIS_PIXEL(i" + std::to_string(i) + ")";
    }
    return isf(samplers + ']', sum + ';');
}

/// Returns the seconds of processor time of this process and of its children that have ended.
double processorSeconds()
{
    double seconds = 0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used{};
        ::getrusage(who, &used);
        for (const timeval& time : {used.ru_utime, used.ru_stime})
            seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    return seconds;
}

/// A shader that would crash or block a driver or a compiler, and a part of the sentence that refuses it.
struct Attack {
    std::string name, text, sentence;
};

class HostileShaders : public testing::TestWithParam<Attack> {};

TEST_P(HostileShaders, EndWithASentenceWithin6Seconds)
{
    const double before = processorSeconds();
    std::string errors;
    {
        // A compiler of its own, whose time counts when it ends.
        guest::ShaderCompiler compiler;
        const guest::FileBeside none = [](const std::string& path) -> std::string {
            throw Failure(ErrorKind::file, message("There is no file {1}.", path));
        };
        errors = errorsOf(guest::translate(guest::readShader(GetParam().text, "own.fs", none), compiler));
    }
    EXPECT_NE(errors.find(GetParam().sentence), std::string::npos) << errors;
    // Processor time does not depend on the machine's load. On an idle machine, no attack takes longer than that.
    EXPECT_LT(processorSeconds() - before, 6);
}

INSTANTIATE_TEST_SUITE_P(
    All, HostileShaders,
    testing::Values(
        Attack{"CallsOf18Functions", callBomb(18), "instructions when every call is replaced by its function"},
        Attack{"CallsOf26Functions", callBomb(26), "instructions when every call is replaced by its function"},
        Attack{"MacrosThatDouble", macroBomb(),
               "own.fs:17:9: The macro “A16” expands to more than 100000 words; write a function or a "
               "loop.\n"},
        Attack{"AHugeArray",
               "void main() { float a[20000000]; a[int(gl_FragCoord.x)] = 1.0; gl_FragColor = "
               "vec4(a[int(gl_FragCoord.y)]); }",
               "own.fs:1:1: The variables of the shader need 80000000 bytes for each pixel, more than "
               "65536; make the arrays smaller.\n"},
        Attack{"DeepParentheses",
               "void main() { gl_FragColor = vec4(" + std::string(100'000, '(') + "1.0" + std::string(100'000, ')') +
                   "); }",
               "own.fs:"},
        Attack{"ManySamplers", manySamplers(),
               "own.fs:1:1: A pass reads 17 pictures, more than the 16 that OpenGL has; use fewer.\n"}),
    [](const auto& attack) { return attack.param.name; });

/// Returns a request whose translation takes some tenths of a second of processor time, and a good answer.
guest::CompilerRequest longRequest()
{
    std::string sum;
    for (int i = 0; i < 20'000; ++i) sum += "x += sin(x);\n";
    return {"#version 450\nvoid main() { gl_Position = vec4(0.0); }\n",
            "#version 450\nout vec4 c;\nvoid main() { float x = 1.0;\n" + sum + "c = vec4(x); }\n"};
}

const guest::CompilerRequest shortRequest{"#version 450\nvoid main() { gl_Position = vec4(0.0); }\n",
                                          "#version 450\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n"};

TEST(ShaderCompiler, GoesOnAfterItsProcessEnded)
{
    guest::ShaderCompiler compiler;
    // Macros that are given macros are not counted before: the process runs into its limit.
    std::string bomb = "#version 450\n#define D(x) x x\n#define E(x) D(D(D(D(D(D(x))))))\nvoid main() { float a = "
                       "E(E(E(E(E(1.0 +)))))";
    const auto ofCompilers = [] {
        rusage used{};
        ::getrusage(RUSAGE_CHILDREN, &used);
        return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
               1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    };
    EXPECT_TRUE(compiler.compile(longRequest()).problem.empty());  // Its time does not count for the next one.
    const double before = ofCompilers();
    const auto ended = compiler.compile({"#version 450\nvoid main() {}\n", bomb + " 1.0; }\n"});
    const bool isOfTime = ended.problem.english().find("more than 2 s of processor time for it") != std::string::npos;
    const bool isOfMemory = ended.problem.english().find("more than 512 MB for it") != std::string::npos;
    EXPECT_TRUE(isOfTime || isOfMemory) << ended.problem;
    EXPECT_LE(ofCompilers() - before, 4) << "seconds of processor time, which do not depend on the machine's load";
    EXPECT_TRUE(isOfMemory || ofCompilers() - before >= 2) << ofCompilers() - before;
    const auto next = compiler.compile(shortRequest);
    EXPECT_TRUE(next.problem.empty()) << next.problem;
    EXPECT_FALSE(next.answer.fragment.empty());
}

/// Sends a signal to the compilers that this process has started. Returns how many there are.
int signalCompilers(int signal)
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "stat");
        std::string id, name, state;
        pid_t parent = 0;
        if (!(file >> id >> name >> state >> parent) || parent != ::getpid() || !name.starts_with("(vitrine_shader"))
            continue;
        ::kill(std::stoi(id), signal);
        ++count;
    }
    return count;
}

/// Load on one processor, on which the calling thread and the processes that it starts run, too.
class BusyProcessor {
public:
    BusyProcessor()
    {
        ::sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(::sched_getcpu(), &one);
        ::sched_setaffinity(0, sizeof one, &one);
        for (pid_t& each : busy_) {
            each = ::fork();
            if (each == 0)
                for (volatile unsigned turns = 0;;) turns = turns + 1;
        }
    }
    ~BusyProcessor()
    {
        for (const pid_t each : busy_) {
            ::kill(each, SIGKILL);
            ::waitpid(each, nullptr, 0);
        }
        ::sched_setaffinity(0, sizeof before_, &before_);
    }
    BusyProcessor(const BusyProcessor&) = delete;
    BusyProcessor& operator=(const BusyProcessor&) = delete;

private:
    cpu_set_t before_{};
    std::array<pid_t, 3> busy_{};
};

TEST(LongShaderCompiler, IsNotLateOnABusyMachine)
{
    using Seconds = std::chrono::duration<double>;
    const guest::ShaderCompiler::Limits limits{.longestStall = std::chrono::milliseconds(150)};
    guest::ShaderCompiler compiler(limits);
    const BusyProcessor busy;
    const auto begun = std::chrono::steady_clock::now();
    const auto result = compiler.compile(longRequest());
    const double wall = Seconds(std::chrono::steady_clock::now() - begun).count();
    EXPECT_TRUE(result.problem.empty()) << result.problem;
    EXPECT_GT(result.answer.counts.instructions, 20'000U);
    // A limit of wall time would have ended it.
    EXPECT_GT(wall, 2 * Seconds(limits.longestStall).count());
    EXPECT_GT(wall, 2 * result.processorSeconds);
}

TEST(ShaderCompiler, StartsAProcessAgainThatHangsOrWasKilled)
{
    for (const int signal : {SIGSTOP, SIGKILL}) {
        guest::ShaderCompiler compiler({.longestStall = std::chrono::milliseconds(150)});
        EXPECT_TRUE(compiler.compile(shortRequest).problem.empty());
        EXPECT_GE(signalCompilers(signal), 1);
        const auto next = compiler.compile(shortRequest);
        EXPECT_TRUE(next.problem.empty()) << next.problem;
        EXPECT_FALSE(next.answer.fragment.empty());
    }
}

TEST(ShaderCompiler, SaysWhatEndedItsProcessTwoTimes)
{
    for (const auto& [signal, sentence] : {std::pair(SIGSTOP, "it did nothing for 0.15 s, two times"),
                                           std::pair(SIGKILL, "ended the GLSL compiler two times")}) {
        guest::ShaderCompiler compiler({.longestStall = std::chrono::milliseconds(150)});
        std::atomic<bool> goesOn = true;
        std::thread thread([&, signal = signal] {
            while (goesOn) signalCompilers(signal);
        });
        const auto result = compiler.compile(longRequest());
        goesOn = false;
        thread.join();
        EXPECT_NE(result.problem.english().find(sentence), std::string::npos) << result.problem;
        EXPECT_TRUE(compiler.compile(shortRequest).problem.empty());
    }
}

TEST(ShaderCompiler, LimitsTheTimeOfAllPassesTogether)
{
    std::string sum;
    for (int i = 0; i < 2'000; ++i) sum += "x += sin(x);\n";
    const std::string text = isf(R"("PASSES": [{"TARGET": "a"}, {"TARGET": "b"}, {}])",
                                 "float x = TIME;\n" + sum + "gl_FragColor = vec4(x);");
    const guest::FileBeside none = [](const std::string& path) -> std::string {
        throw Failure(ErrorKind::file, message("There is no file {1}.", path));
    };
    guest::ShaderCompiler patient, hasty({.secondsOfAllPasses = 1e-3});
    EXPECT_EQ(errorsOf(guest::translate(guest::readShader(text, "own.fs", none), patient)), "");
    EXPECT_NE(errorsOf(guest::translate(guest::readShader(text, "own.fs", none), hasty))
                  .find("more than 0.001 s of processor time for its passes together"),
              std::string::npos);
}

}  // namespace
}  // namespace vitrine
