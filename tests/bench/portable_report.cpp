// Report of one machine for people who send it: what its driver is, whether hard cases hold, and how long frames,
// shaders, the start and studies take. `run-benchmarks` of the portable folder prints it. The whole report ends within
// its time: a part that has none left is left out, and its line says so.

#include "tests/bench/bench.h"
#include "tests/bench/child.h"

#include "exhibits/exhibits.h"
#include "exhibits/museum/museum.h"
#include "render/gl/context.h"
#include "render/gl/frame_clock.h"
#include "render/gl/renderer.h"
#include "render/measure/clock.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace vitrine::bench {
namespace {

constexpr glm::ivec2 small{320, 180};
constexpr std::array<glm::ivec2, 3> sizes{glm::ivec2(1280, 720), glm::ivec2(1920, 1080), glm::ivec2(3840, 2160)};

enum class State { still, moving, refining };

/// Museum and renderer whose frames are measured.
struct Gallery {
    Museum museum{allExhibits()};
    SceneState sceneState = museum.initialSceneState();
    render::gl::Renderer renderer{};
    render::FrameReport report{};  ///< The latest frame's.
};

struct Frame {
    double wall = 0;   ///< Milliseconds to prepare, plan and draw.
    double clock = 0;  ///< Milliseconds of drawing, by the clock of the head.
};

/// Draws frame `n`, from 0, of a subject before its best view; the hall from the entrance. While moving, camera and
/// time change; while refining, each frame is a further sample of the same picture.
Frame draw(Gallery& gallery, std::size_t subject, glm::ivec2 size, State state, int n)
{
    FrameRequest request;
    request.raster.size = size;
    request.subject = subject;
    request.idle = state != State::moving;
    request.camera = subject == hallIndex ? gallery.sceneState.camera
                                          : gallery.museum.bestView(subject, gallery.sceneState.values[subject]);
    if (state == State::moving) {
        request.movingFrame = n + 1;
        request.time = n / 60.0;
        request.camera.eye.x += 0.01 * n;
    }
    if (state == State::refining) {
        request.samples = 16;
        request.sample = 1 + n % 15;
    }
    const double start = render::wallSeconds();
    gallery.report = gallery.renderer.draw(
        test::planned(gallery.museum, gallery.sceneState, request, gallery.renderer.persistentState()));
    return {1e3 * (render::wallSeconds() - start), gallery.report.milliseconds};
}

/// Returns the slowest passes of the latest frame as text, with their milliseconds by the clock of the head.
std::string slowestPasses(const Gallery& gallery)
{
    std::vector<render::StepReport> ran = gallery.report.ran;
    std::stable_sort(ran.begin(), ran.end(),
                     [](const auto& a, const auto& b) { return a.milliseconds > b.milliseconds; });
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(ran.size(), 4); ++i) {
        char pass[128];
        std::snprintf(pass, sizeof pass, "%s%s %.2f", i ? ", " : "", ran[i].name.c_str(), ran[i].milliseconds);
        text += pass;
    }
    return text;
}

/// Measures frames of one state for at most `seconds`, and returns a table's cell. `last` is the wall time of the
/// latest frame of this subject, by which the first frame of the next size is foreseen.
std::string cell(Gallery& gallery, std::size_t subject, glm::ivec2 size, State state, double seconds, Frame& last)
{
    const double until = render::wallSeconds() + seconds;
    if (2e-3 * last.wall > seconds) {
        char text[64];
        std::snprintf(text, sizeof text, "left out, about %.0f", last.wall);
        return text;
    }
    std::vector<double> wall, clock;
    for (int n = 0; n < 33 && (n < 2 || render::wallSeconds() + 1e-3 * last.wall < until); ++n) {
        last = draw(gallery, subject, size, state, n);
        if (n < 3 && 1e-3 * last.wall < seconds / 6) continue;  // Warms up, unless frames are slow.
        wall.push_back(last.wall);
        clock.push_back(last.clock);
    }
    if (wall.empty()) return "left out";
    last = {median(wall), median(clock)};
    char text[64];
    std::snprintf(text, sizeof text, "%.1f · %.1f", last.wall, last.clock);
    return text;
}

/// Prints the rest of a subject's line of the table of frames within `share` seconds. Returns its line of the table of
/// passes.
std::string printSubject(Gallery& gallery, std::size_t subject, double share)
{
    const double begin = render::wallSeconds();
    gallery.renderer.timeSteps(true);
    const double first = draw(gallery, subject, small, State::still, 0).wall;
    const std::string passes = slowestPasses(gallery) + " | ";
    gallery.renderer.timeSteps(false);
    Frame last = draw(gallery, subject, small, State::still, 0);
    std::printf(" %.0f | %.0f |", first, last.wall);
    // Frames that build specialized programs, or draw slices that are left, are slower.
    for (int n = 0; n < 8 && render::wallSeconds() < begin + share / 5; ++n)
        if (const Frame next = draw(gallery, subject, small, State::still, 0); next.wall < last.wall) last = next;
    glm::dvec2 drawn(small);
    int left = 9;
    for (const glm::ivec2 size : sizes) {
        last.wall *= size.x * size.y / (drawn.x * drawn.y);
        drawn = size;
        for (const State state : {State::still, State::moving, State::refining}) {
            const double each = (begin + share - render::wallSeconds()) / left--;
            std::printf(" %s |", cell(gallery, subject, size, state, each, last).c_str());
            std::fflush(stdout);
        }
    }
    std::printf("\n");
    if (last.wall > 1e3) return passes + "left out: too slow";
    gallery.renderer.timeSteps(true);
    for (int n = 0; n < 2; ++n) (void)draw(gallery, subject, sizes[0], State::still, 0);
    gallery.renderer.timeSteps(false);
    return passes + slowestPasses(gallery);
}

/// Prints the programs for which the frames waited longest.
void printBuilds(std::vector<render::gl::ProgramBuild> builds)
{
    double sum = 0;
    for (const auto& build : builds) sum += build.seconds;
    std::stable_sort(builds.begin(), builds.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
    std::printf("\n## Programs: %zu built, waited for in %.1f s together\n\n| waited for longest | s |\n|---|---|\n",
                builds.size(), sum);
    for (std::size_t i = 0; i < std::min<std::size_t>(builds.size(), 10); ++i)
        std::printf("| %s | %.2f |\n", builds[i].program.c_str(), builds[i].seconds);
}

/// Prints frame times and times of compilation. Nothing is read from a cache of programs.
void printFrames(double end)
{
    for (const char* name : {"VITRINE_NO_PROGRAM_CACHE", "MESA_SHADER_CACHE_DISABLE"}) ::setenv(name, "1", 1);
    ::setenv("__GL_SHADER_DISK_CACHE", "0", 1);
    const render::gl::HeadlessContext context;
    Gallery gallery;
    std::string passes;
    std::printf("\n## Frames, in milliseconds: wall clock · clock of the head\n\nHall: from the entrance. Exhibits: at "
                "their places, from their best views. First picture: 320 x 180, with programs to compile and textures "
                "to upload.\n\n"
                "| what | first picture, ms | second, ms |");
    for (const glm::ivec2 size : sizes)
        for (const char* state : {"still", "moving", "refining"}) std::printf(" %d x %d %s |", size.x, size.y, state);
    std::printf("\n|%s\n", "---|---|---|---|---|---|---|---|---|---|---|---|");
    const std::size_t count = gallery.museum.subjects().size();
    for (std::size_t subject = 0; subject < count; ++subject) {
        const std::string name(gallery.museum.subject(subject).name());
        const double share = (end - render::wallSeconds()) / static_cast<double>(count - subject);
        std::printf("| %s |", name.c_str());
        if (share < 1)
            std::printf(" left out: no time left | | | | | | | | | | |\n");
        else
            passes += "| " + name + " | " + printSubject(gallery, subject, share) + " |\n";
    }
    std::printf("\n## Slowest passes, in milliseconds by the clock of the head\n\nA timer query includes the time for "
                "which the GPU waits for a program to be built.\n\n"
                "| what | first picture | 1280 x 720 still |\n|---|---|---|\n%s",
                passes.c_str());
    printBuilds(gallery.renderer.builds());
    std::printf("\n## Memory of the renderer at the end\n\n| what | count | MB |\n|---|---|---|\n");
    for (const auto& stored : gallery.renderer.stored())
        std::printf("| %s | %lld | %.1f |\n", stored.what.c_str(), static_cast<long long>(stored.count),
                    static_cast<double>(stored.bytes) / 1e6);
}

/// Runs the program for at most `seconds` and prints a line of the table of runs; its output into `out` if not null.
void printRun(const std::string& name, const std::vector<std::string>& arguments, double seconds,
              std::string* out = nullptr)
{
    if (seconds < 5) {
        std::printf("| %s | left out: no time left | | |\n", name.c_str());
        return;
    }
    Run run = runProgram(arguments, {}, seconds);
    const std::string result = run.code == 128 + SIGALRM ? "out of time" : "exit code " + std::to_string(run.code);
    std::printf("| %s | %s | %.1f | %.0f |\n", name.c_str(), result.c_str(), run.wallSeconds, run.peakMegabytes);
    std::fflush(stdout);
    if (out) *out = std::move(run.out);
}

void printMachine()
{
    std::string version = runProgram({"--version"}).out;
    version = version.substr(0, version.find('\n'));
    const render::gl::HeadlessContext context;
    const render::ClockChoice& clock = render::gl::trustedClock(context.info().software);
    std::printf(
        "# %s\n\n| made with | |\n|---|---|\n| program | %s |\n| renderer | %s |\n| version | %s |\n| threads | "
        "%u |\n| clock | %s, %s |\n| its check | %s |\n",
        context.info().renderer.c_str(), version.c_str(), context.info().renderer.c_str(),
        context.info().version.c_str(), std::thread::hardware_concurrency(), clock.name.c_str(),
        clock.trusted ? "trusted" : "not trusted", clock.why.c_str());
}

}  // namespace

bool portableReport(const Options& options)
{
    const double end = render::wallSeconds() + 60 * options.minutes;
    const auto left = [end](double part) { return std::max(part * (end - render::wallSeconds()), 0.0); };
    printMachine();
    const test::TemporaryFolder folder;
    std::string doctor, stability;
    char minutes[32];
    std::printf("\n## Runs of the program\n\n| what | result | s | peak of memory, MB |\n|---|---|---|---|\n");
    printRun("doctor", {"doctor"}, left(0.2), &doctor);
    std::snprintf(minutes, sizeof minutes, "%.2f", left(0.12) / 60);
    printRun("hard cases", {"doctor", "--stability", "--minutes", minutes}, left(0.3), &stability);
    for (const auto& [exhibit, parameter] :
         {std::pair{"sdf_morph", "hitTolerance"}, std::pair{"fur", "shellCount"}, std::pair{"noise", "octaves"}})
        printRun(std::string("study ") + exhibit + ' ' + parameter,
                 {"study", exhibit, parameter, "--points", "4", "--views", "1", "--runs", "1", "--size", "160x90",
                  "--out", folder / exhibit},
                 left(0.1));
    std::printf("\n## Start of the window\n\n");
    std::fflush(stdout);
    Options starts = options;
    starts.runs = 1;
    if (!std::getenv("DISPLAY"))
        std::printf("Left out: there is no display.\n");
    else if (!windowStart(starts, left(0.12)))
        std::printf("Left out: no picture was shown within the time.\n");
    printFrames(end - 10);
    std::printf("\n## What doctor says\n\n```\n%s```\n\n## Hard cases\n\n```\n%s```\n", doctor.c_str(),
                stability.c_str());
    return true;
}

}  // namespace vitrine::bench
