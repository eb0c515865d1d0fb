// What the works behind the noise frame cost, beside the source's ways: the march by halves of the value against the
// march by bounds, normals, the clouds' steps, baked noise against evaluated; and what a frame costs from near, from
// afar and out of view. Prints Markdown.
//   bench_noise_costs [--size 320x200] [--only field|"fractal sum"|sea|clouds|frames]

#include "exhibits/exhibits.h"
#include "exhibits/museum/picture.h"
#include "exhibits/noise/noise_table.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/bench/bench_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

const NoiseTable table;

struct Measured {
    render::Image picture;
    double evaluations = 0;  ///< A pixel, mean.
    /// Of the field, look-ups in place of evaluations; of the sea, evaluations of the march alone; none of clouds.
    std::optional<double> part;
    double milliseconds = 0;  ///< Of the exhibit's own passes, median of five.
};

struct Bench : bench::BenchFrame {
    Bench() : BenchFrame("noise", {320, 200}) {}

    std::optional<double> partOf(const FrameRequest& request)
    {
        const render::FramePlan made = plan(request);
        for (const render::Pass& pass : made.passes()) {
            const bool field = pass.name == "noise/field" || pass.name == "noise/fractal";
            if (!field && pass.name != "noise/sea") continue;
            // No frame of the program asks for this, so that no plan offers it.
            const_cast<render::Pass&>(pass).shader.defines.emplace_back(field ? "COUNT_LOOKUPS" : "COUNT_MARCH");
            renderer.draw(made);
            return meanEvaluations();
        }
        return std::nullopt;
    }

    Measured measure()
    {
        const FrameRequest request = alone();
        PictureMaker maker(museum, renderer, sceneState, {.frame = request});
        while (maker.step()) {
        }
        Measured result{maker.picture()};
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) result.evaluations += static_cast<double>(result.picture.at(x, y, 4));
        result.evaluations /= static_cast<double>(size.x) * size.y;
        result.part = partOf(request);
        result.milliseconds = medianMilliseconds(request, "noise/", 5, 1);
        return result;
    }
};

double errorOf(const render::Image& a, const render::Image& b)
{
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double d = static_cast<double>(a.at(x, y, c)) - static_cast<double>(b.at(x, y, c));
                sum += d * d / 3;
            }
    return std::sqrt(sum / (static_cast<double>(a.width) * a.height));
}

void row(const std::string& name, const Measured& m, const render::Image& truth)
{
    std::printf("| %s | %.1f |", name.c_str(), m.evaluations);
    if (m.part) std::printf(" %.1f |", *m.part);
    std::printf(" %.4f | %.0f |\n", errorOf(m.picture, truth), m.milliseconds);
    std::fflush(stdout);
}

/// Columns of a table; `part` says what Measured::part is, empty where there is none.
std::string head(const std::string& part)
{
    const std::string name = part.empty() ? "" : part + " | ";
    return "| way | evaluations per pixel | " + name + "RMSE | ms |\n|---|---|---|---|" +
           (part.empty() ? "\n" : "---|\n");
}

void field(Bench& bench, NoiseWork work, const char* title)
{
    std::printf(
        "\n## %s\n\nOctaves of noise for march and light together, against the bounds as proven with 1024 steps.\n\n%s",
        title, head("look-ups").c_str());
    ParameterValues& v = bench.values();
    const ParameterValues start = v = [&] {
        ParameterValues of{table};
        of.set(table.work, work);
        return of;
    }();
    v.set(table.boundShare, 1.0);
    v.set(table.stepLimit, 1024);
    v.set(table.hitTolerance, 0.05);
    v.set(table.fieldNoise, NoiseLookup::evaluated);
    const Measured truth = bench.measure();
    row("reference", truth, truth.picture);
    for (const int steps : {64, 160, 512}) {
        v = start;
        v.set(table.march, NoiseMarch::halved);
        v.set(table.stepLimit, steps);
        row("half the value a step, at most " + std::to_string(steps), bench.measure(), truth.picture);
    }
    for (const double share : {1.0, 0.7, 0.45, 0.3}) {
        v = start;
        v.set(table.boundShare, share);
        char name[64];
        std::snprintf(name, sizeof name, "bounded, %.2f of the bounds", share);
        row(name, bench.measure(), truth.picture);
    }
    v = start;
    v.set(table.fieldNoise, NoiseLookup::evaluated);
    row("bounded, nothing looked up", bench.measure(), truth.picture);
    v = start;
    v.set(table.normals, NoiseNormal::differences);
    row("bounded, normals by differences", bench.measure(), truth.picture);
}

void clouds(Bench& bench)
{
    std::printf("\n## Clouds\n\nLook-ups, or evaluations of two or three sums, against 512 steps; then against "
                "evaluated noise.\n\n%s",
                head("").c_str());
    ParameterValues& v = bench.values();
    const ParameterValues start = v = [&] {
        ParameterValues of{table};
        of.set(table.work, NoiseWork::clouds);
        of.set(table.jitter, false);
        return of;
    }();
    v.set(table.cloudSteps, 512);
    const Measured truth = bench.measure();
    row("reference", truth, truth.picture);
    for (const int steps : {64, 128, 256, 512}) {
        v = start;
        v.set(table.march, NoiseMarch::halved);
        v.set(table.cloudSteps, steps);
        row(std::to_string(steps) + " even steps, summed plainly", bench.measure(), truth.picture);
    }
    for (const int steps : {16, 32, 64, 128, 256}) {
        v = start;
        v.set(table.cloudSteps, steps);
        row(std::to_string(steps) + " steps", bench.measure(), truth.picture);
    }
    v = start;
    v.set(table.cloudNoise, NoiseLookup::evaluated);
    const Measured evaluated = bench.measure();
    row("64 steps, evaluated", evaluated, evaluated.picture);
    v.set(table.cloudNoise, NoiseLookup::baked);
    for (const int size : {32, 64, 96, 160}) {
        v.set(table.bakeSize, size);
        const double megabytes = 4.0 * size * size * size / 1e6;
        char name[64];
        std::snprintf(name, sizeof name, "64 steps, baked to %d (%.1f MB)", size, megabytes);
        row(name, bench.measure(), evaluated.picture);
    }
}

void sea(Bench& bench)
{
    std::printf(
        "\n## Sea\n\nHeights of the tall waves and of all, against 256 steps; a height is one evaluation.\n\n%s",
        head("of these, by the march").c_str());
    ParameterValues& v = bench.values();
    const ParameterValues start = v = ParameterValues(table);
    v.set(table.seaSteps, 256);
    v.set(table.hitTolerance, 0.01);
    const Measured truth = bench.measure();
    row("reference", truth, truth.picture);
    for (const NoiseMarch march : {NoiseMarch::halved, NoiseMarch::bounded})
        for (const double tolerance : {0.5, 0.1, 0.02}) {
            v = start;
            v.set(table.march, march);
            v.set(table.seaSteps, 256);
            v.set(table.hitTolerance, tolerance);
            char name[80];
            std::snprintf(name, sizeof name, "%s, as near as %.2f pixels",
                          march == NoiseMarch::halved ? "steps of the height above the water" : "bounded", tolerance);
            row(name, bench.measure(), truth.picture);
        }
    for (const int steps : {5, 10, 20, 40}) {
        v = start;
        v.set(table.seaSteps, steps);
        row("bounded, at most " + std::to_string(steps), bench.measure(), truth.picture);
    }
}

void frames(Bench& bench)
{
    std::printf("\n## A frame in the hall\n\n| work | from before it | from across the hall | out of view "
                "|\n|---|---|---|---|\n");
    constexpr const char* names[] = {"field", "fractal sum", "sea", "clouds"};
    for (int work = 0; work < 4; ++work) {
        bench.values() = ParameterValues(table);
        bench.values().set(table.work, static_cast<NoiseWork>(work));
        FrameRequest request = bench.alone();
        request.alone.reset();
        request.channels.evaluations = false;
        request.camera = bench.museum.bestView(bench.exhibit, bench.values());
        const double near = bench.medianMilliseconds(request, "noise/", 5, 1);
        request.camera.eye = {4.5, 1.65, 0};
        const double far = bench.medianMilliseconds(request, "noise/", 5, 1);
        request.camera.target = {9, 1.65, 0};
        std::printf("| %s | %.0f | %.0f | %.0f |\n", names[work], near, far,
                    bench.medianMilliseconds(request, "noise/", 5, 1));
    }
}

}  // namespace

int main(int argc, char** argv)
{
    Bench bench;
    std::string only;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &bench.size.x, &bench.size.y);
        if (std::strcmp(argv[i], "--only") == 0) only = argv[i + 1];
    }
    const auto chosen = [&](const char* part) { return only.empty() || only == part; };
    std::printf("Pictures of %d x %d, alone from the best view; time is that of the exhibit's own passes, median of "
                "five, by the process's CPU time around glFinish.\n",
                bench.size.x, bench.size.y);
    if (chosen("field")) field(bench, NoiseWork::field, "Field");
    if (chosen("fractal sum")) field(bench, NoiseWork::fractal, "Fractal sum");
    if (chosen("sea")) sea(bench);
    if (chosen("clouds")) clouds(bench);
    if (chosen("frames")) frames(bench);
    return 0;
}
