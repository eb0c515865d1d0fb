// Time from the start of the process to the window's first picture. The program is started on a display, prints the
// times of its first picture and of the one with all exhibits in view, and closes. Runs with and without cached
// programs (shaders) alternate.

#include "tests/bench/bench.h"
#include "tests/bench/child.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace vitrine::bench {
namespace {

std::string shownSize;

struct Start {
    double seconds = 0;     ///< Until the first picture.
    double allSeconds = 0;  ///< Until the picture with all exhibits.
    double cpuSeconds = 0;  ///< Processor time until the process has ended.
};

/// Starts the program with the caches in `cache`. Returns nullopt if there was no picture.
std::optional<Start> start(const std::string& cache, double longest)
{
    const test::TemporaryFolder home;
    const Run run = runProgram({},
                               {{"VITRINE_FIRST_PICTURE", "1"},
                                {"QT_QPA_PLATFORM", "xcb"},
                                {"XDG_CACHE_HOME", cache},
                                {"XDG_STATE_HOME", home / "state"},
                                {"XDG_CONFIG_HOME", home / "config"},
                                {"XDG_DATA_HOME", home / "data"}},
                               longest);
    double shown = 0, all = 0;
    char size[64] = "";
    if (run.code != 0 ||
        std::sscanf(run.out.c_str(), "first picture at %lf s, %63s all at %lf", &shown, size, &all) != 3)
        return std::nullopt;
    shownSize = size;
    return Start{shown - run.started, all - run.started, run.cpuSeconds};
}

/// Prints a line of the table, and returns the median of the seconds.
double row(const char* name, const std::vector<Start>& starts)
{
    std::vector<double> wall, all, cpu;
    for (const Start& start : starts) {
        all.push_back(start.allSeconds);
        wall.push_back(start.seconds);
        cpu.push_back(start.cpuSeconds);
    }
    const auto [low, high] = std::minmax_element(wall.begin(), wall.end());
    std::printf("| %s | %.0f | %.0f to %.0f | %.0f | %.0f | %zu |\n", name, 1e3 * median(wall), 1e3 * *low, 1e3 * *high,
                1e3 * median(all), 1e3 * median(cpu), starts.size());
    return median(wall);
}

}  // namespace

bool windowStart(const Options& options, double longest)
{
    const int runs = options.runsOr(5);
    const test::TemporaryFolder caches;
    std::vector<Start> warm, cold;
    // Fills the cache, and loads the program's files into memory.
    if (!start(caches / "warm", longest)) return false;
    for (int run = 0; run < runs; ++run) {
        const std::optional<Start> first = start(caches / ("cold-" + std::to_string(run)), longest);
        const std::optional<Start> again = start(caches / "warm", longest);
        if (!first || !again) {
            std::fprintf(stderr, "benchmarks: no picture was shown; is there a display?\n");
            return false;
        }
        cold.push_back(*first);
        warm.push_back(*again);
    }
    std::printf("From just before the process is started until the window's first picture of %s pixels is on the "
                "screen; wall clock, medians.\n\n",
                shownSize.c_str());
    std::printf("| programs | ms | lowest to highest | ms to all exhibits in view | ms of CPU until it has closed | "
                "runs |\n|---|---|---|---|---|---|\n");
    const double cached = row("cached", warm);
    const double compiled = row("compiled, as after installation or a change of driver", cold);
    std::printf("\nFrom the start of the process to the window's first picture: %.1f s with the programs cached (goal: "
                "1.0 s), %.1f s when they are compiled.\n",
                cached, compiled);
    return true;
}

}  // namespace vitrine::bench
