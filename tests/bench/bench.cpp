// Prints tables of measurements; passes or fails nothing.
//   benchmarks                       lists the cases
//   benchmarks CASE [--runs N] [--size 640x360] [--scale 0.1] [--program NAME=PATH]...
//   benchmarks machine               renderer, processor, load and speed of a copy of memory, for the head of a result

#include "tests/bench/bench.h"

#include "render/failure.h"
#include "render/gl/context.h"
#include "render/measure/clock.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <thread>

namespace vitrine::bench {

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

namespace {

const std::vector<Case>& cases()
{
    static const std::vector<Case> all{
        {"sdf_evaluations", "Field evaluations per pixel of each way to trace the mug, its shadows and its normals",
         false, sdfEvaluations},
        {"interlacing", "16 views interlaced into 4800 x 3200 pixels, beside a copy of the same bytes", false,
         interlacing},
        {"large_print", "Time and peak of memory of a print of 40,000 x 36,000 pixels", false, largePrint},
        {"hall_costs", "Frame time of the empty hall, beside the hall with its exhibits out of view and in view", true,
         hallCosts},
        {"window_start", "From the start of the process to the window's first picture", true,
         [](const Options& options) { return windowStart(options, 120); }},
        {"window_latency", "From a click, a key or a moved slider to its answer on the screen", true, windowLatency},
        {"your_shader",
         "From an edit to the picture, start and frames of the hall, with and without a visitor's shader", true,
         yourShader},
        {"portable", "Report of one machine: driver, hard cases, frames, start, studies, memory", true, portableReport},
    };
    return all;
}

/// Returns the text behind the colon of the first line of /proc/cpuinfo that begins with `key`.
std::string processorEntry(const std::string& key)
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.rfind(key, 0) == 0 && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
    return "unknown";
}

/// Bytes copied per second by one thread, in 1e9: median of 15 copies of more than the caches hold.
double memcpyGigabytes()
{
    constexpr std::size_t bytes = std::size_t{128} << 20;
    const std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    std::vector<double> rates;
    for (int run = 0; run < 15; ++run) {
        const double start = render::wallSeconds();
        std::memcpy(to.data(), from.data(), bytes);
        rates.push_back(static_cast<double>(bytes) / (render::wallSeconds() - start) / 1e9);
        if (to[static_cast<std::size_t>(run)] != 1) return 0;  // Uses the copy, so that it is not optimized away.
    }
    return median(rates);
}

/// Prints lines of a name, a tab and a value.
void printMachine()
{
    std::string load = "unknown";
    std::ifstream("/proc/loadavg") >> load;  // Mean of the last minute, before the measurement adds to it.
    const render::gl::HeadlessContext context;
    std::printf("renderer\t%s, %s\nprocessor\t%s, %u threads\nload\t%s\nmemcpy\t%.1f\n",
                context.info().renderer.c_str(), context.info().version.c_str(), processorEntry("model name").c_str(),
                std::thread::hardware_concurrency(), load.c_str(), memcpyGigabytes());
}

int run(int argc, char** argv)
{
    CLI::App app("Prints tables of measurements.");
    Options options;
    std::string name, size;
    std::vector<std::string> programs;
    app.add_option("case", name, "Case to measure, or machine; without it, the cases are listed");
    app.add_option("--runs", options.runs, "Repetitions of each measurement")->check(CLI::Range(1, 1000));
    app.add_option("--size", size, "Size of drawn pictures in pixels, as 640x360");
    app.add_option("--scale", options.scale, "Scale of the large print")->check(CLI::Range(0.01, 1.0));
    app.add_option("--minutes", options.minutes, "Longest time of the case portable")->check(CLI::Range(0.5, 60.0));
    app.add_option("--program", programs, "Further programs for window_latency, as NAME=PATH");
    CLI11_PARSE(app, argc, argv);
    if (!size.empty() && std::sscanf(size.c_str(), "%dx%d", &options.size.x, &options.size.y) != 2)
        throw Failure(ErrorKind::usage, message("--size {1}: give width and height, as 640x360", size));
    for (const std::string& program : programs)
        options.programs.emplace_back(program.substr(0, program.find('=')), program.substr(program.find('=') + 1));
    if (name.empty())
        for (const Case& each : cases())
            std::printf("%s\t%s\t%s\n", each.name.c_str(), each.draws ? "gl" : "cpu", each.question.c_str());
    if (name == "machine") printMachine();
    if (name.empty() || name == "machine") return 0;
    const auto found = std::ranges::find(cases(), name, &Case::name);
    if (found == cases().end())
        throw Failure(ErrorKind::usage,
                      message("There is no case {1}; without arguments, benchmarks lists them", name));
    return found->run(options) ? 0 : 1;
}

}  // namespace
}  // namespace vitrine::bench

int main(int argc, char** argv)
try {
    return vitrine::bench::run(argc, argv);
} catch (const vitrine::Failure& failure) {
    std::fprintf(stderr, "benchmarks: %s\n", failure.what());
    return failure.exitCode();
}
