// What the sunbeams cost and how wrong they are: every method of the screen-space rays against the plain loop with
// 4096 samples, and the volume's steps against 1024. Prints Markdown.
//   bench_sunbeams [--size 640x360]    that size alone instead of two

#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/exhibits.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/bench/bench_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <vector>

namespace {

using namespace vitrine;

constexpr double goal = 0.002;  ///< RMSE at which the methods are held beside the loop.

const CrepuscularRaysTable table;
const HallTable hallTable;

struct Measured {
    render::Image picture;
    double fetchesPerPixel = 0;
    double stepsPerPixel = 0;
    double milliseconds = 0;  ///< Of the exhibit's own passes, median of five.
};

struct Bench : bench::BenchFrame {
    render::Camera camera;

    Bench() : BenchFrame("crepuscular_rays", {640, 360}) {}
    ParameterValues& rays() { return values(); }

    Measured measure(bool timed = true)
    {
        FrameRequest frame;
        frame.camera = camera;
        frame.raster.size = size;
        frame.averageIn = AverageIn::radiance;
        PictureMaker maker(museum, renderer, sceneState, {.frame = frame});
        while (maker.step()) {
        }
        Measured result{maker.picture()};
        const double pixels = static_cast<double>(size.x) * size.y;
        const auto& counters = maker.report().counters;
        if (const auto found = counters.find("fetches"); found != counters.end())
            result.fetchesPerPixel = static_cast<double>(found->second) / pixels;
        if (const auto found = counters.find("marchSteps"); found != counters.end())
            result.stepsPerPixel = static_cast<double>(found->second) / pixels;
        if (!timed) return result;
        result.milliseconds = medianMilliseconds(frame, "crepuscular_rays/", 5, 0);
        return result;
    }
};

struct Error {
    double rootMeanSquare = 0, largest = 0;
};

Error difference(const render::Image& a, const render::Image& b)
{
    Error error;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double d = std::abs(static_cast<double>(a.at(x, y, 0)) - static_cast<double>(b.at(x, y, 0)));
            error.rootMeanSquare += d * d;
            error.largest = std::max(error.largest, d);
        }
    }
    error.rootMeanSquare = std::sqrt(error.rootMeanSquare / (static_cast<double>(a.width) * a.height));
    return error;
}

const char* const methodNames[] = {"loop", "three passes", "polar sum"};

/// What a method takes for an error.
struct Point {
    double error = 0, looks = 0, milliseconds = 0;
};

/// The same between two neighbors of a curve of falling error, along a power law; nothing beyond its ends.
std::optional<Point> atError(const std::vector<Point>& curve, double error)
{
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const Point& a = curve[i - 1];
        const Point& b = curve[i];
        if (error > a.error || error < b.error) continue;
        const double t = std::log(error / a.error) / std::log(b.error / a.error);
        return Point{error, a.looks * std::pow(b.looks / a.looks, t),
                     a.milliseconds * std::pow(b.milliseconds / a.milliseconds, t)};
    }
    return std::nullopt;
}

void screenRays(Bench& bench)
{
    ParameterValues& rays = bench.rays();
    rays = ParameterValues(table);
    rays.set(table.technique, RayTechnique::screen);
    rays.set(table.view, RayView::light);
    rays.set(table.weight, 1.0);
    rays.set(table.tint, ColorValue{glm::dvec3(1)});
    rays.set(table.skyColor, false);
    rays.set(table.lightSize, 3.141593);
    rays.set(table.jitter, false);
    // White is 1.
    bench.sceneState.hall().set(hallTable.exposure, -std::log2(12.2));
    const auto run = [&](RayMethod method, int samples, RayResolution resolution, bool timed) {
        rays.set(table.method, method);
        rays.set(table.samples, samples);
        rays.set(table.resolution, resolution);
        return bench.measure(timed);
    };
    const Measured truth = run(RayMethod::loop, 4096, RayResolution::full, false);
    std::printf("| method | samples | resolution | looks per pixel | RMSE | largest error | ms | the loop at that "
                "RMSE: looks | ms | looks saved |\n|---|---|---|---|---|---|---|---|---|---|\n");
    std::vector<Point> loop;
    std::map<RayMethod, Point> withinGoal;
    const auto line = [&](RayMethod method, int samples, RayResolution resolution) {
        const Measured m = run(method, samples, resolution, true);
        const Error e = difference(m.picture, truth.picture);
        const char* names[] = {"full", "half", "quarter"};
        std::printf("| %s | %d | %s | %.1f | %.5f | %.4f | %.1f |", methodNames[static_cast<int>(method)], samples,
                    names[static_cast<int>(resolution)], m.fetchesPerPixel, e.rootMeanSquare, e.largest,
                    m.milliseconds);
        const Point point{e.rootMeanSquare, m.fetchesPerPixel, m.milliseconds};
        const bool plain = method == RayMethod::loop && resolution == RayResolution::full;
        if (plain) loop.push_back(point);
        const std::optional<Point> same = plain ? std::nullopt : atError(loop, e.rootMeanSquare);
        if (same)
            std::printf(" %.1f | %.1f | %.1f times |\n", same->looks, same->milliseconds, same->looks / point.looks);
        else
            std::printf("  |  |  |\n");
        if (resolution == RayResolution::full && point.error <= goal &&
            (!withinGoal.contains(method) || point.looks < withinGoal[method].looks))
            withinGoal[method] = point;
        std::fflush(stdout);
    };
    for (const int samples : {8, 16, 32, 64, 128, 216}) line(RayMethod::loop, samples, RayResolution::full);
    for (const int samples : {64, 216, 512}) line(RayMethod::threePasses, samples, RayResolution::full);
    for (const int samples : {64, 96, 128, 216, 384}) line(RayMethod::polar, samples, RayResolution::full);
    for (const int samples : {32, 128}) line(RayMethod::loop, samples, RayResolution::half);
    line(RayMethod::threePasses, 216, RayResolution::half);
    line(RayMethod::loop, 64, RayResolution::quarter);
    const std::optional<Point> needed = atError(loop, goal);
    if (!needed) return;
    std::printf("\nFor an RMSE of %.3f the loop needs %.0f looks per pixel.", goal, needed->looks);
    for (const auto& [method, point] : withinGoal)
        if (method != RayMethod::loop)
            std::printf(" With %s, %.1f looks are within it (%.5f): %.1f times fewer.",
                        methodNames[static_cast<int>(method)], point.looks, point.error, needed->looks / point.looks);
    std::printf("\n");
}

void volume(Bench& bench)
{
    ParameterValues& rays = bench.rays();
    rays = ParameterValues(table);
    rays.set(table.view, RayView::light);
    bench.sceneState.hall().set(hallTable.exposure, -std::log2(12.2));
    const auto run = [&](int steps, RayResolution resolution, bool jitter, bool timed) {
        rays.set(table.volumeSteps, steps);
        rays.set(table.resolution, resolution);
        rays.set(table.jitter, jitter);
        return bench.measure(timed);
    };
    const Measured truth = run(1024, RayResolution::full, false, false);
    double mean = 0;
    for (int y = 0; y < truth.picture.height; ++y)
        for (int x = 0; x < truth.picture.width; ++x) mean += static_cast<double>(truth.picture.at(x, y, 0));
    mean /= static_cast<double>(truth.picture.width) * truth.picture.height;
    std::printf("| steps | blue noise | resolution | steps per pixel, at most | RMSE over the mean | ms "
                "|\n|---|---|---|---|---|---|\n");
    for (const RayResolution resolution : {RayResolution::full, RayResolution::half, RayResolution::quarter}) {
        for (const bool jitter : {false, true}) {
            for (const int steps : {2, 4, 8, 16, 32, 64}) {
                if (resolution != RayResolution::full && steps != 8 && steps != 16) continue;
                if (bench.size.x > 640 && (resolution == RayResolution::quarter || steps < 8)) continue;
                const Measured m = run(steps, resolution, jitter, true);
                const char* names[] = {"full", "half", "quarter"};
                std::printf("| %d | %s | %s | %.1f | %.4f | %.1f |\n", steps, jitter ? "on" : "off",
                            names[static_cast<int>(resolution)], m.stepsPerPixel,
                            difference(m.picture, truth.picture).rootMeanSquare / mean, m.milliseconds);
                std::fflush(stdout);
            }
        }
    }
}

/// What the beams cost as they stand, seen from the entrance, step by step.
void entrance(Bench& bench)
{
    FrameRequest frame;
    frame.camera = bench.sceneState.camera;
    frame.raster.size = bench.size;
    bench.renderer.timeSteps(true);
    std::map<std::string, std::vector<double>> times;
    for (int run = 0; run < 7; ++run) {
        std::map<std::string, double> once;
        for (const render::StepReport& step : bench.renderer.draw(bench.plan(frame)).ran)
            once[step.name.rfind("crepuscular_rays/", 0) == 0 ? step.name : "everything else"] += step.milliseconds;
        if (run < 2) continue;  // Shadow maps, probe and programs are made once.
        for (const auto& [name, milliseconds] : once) times[name].push_back(milliseconds);
    }
    bench.renderer.timeSteps(false);
    std::printf("\n## The beams in the hall, from the entrance, %d × %d\n\n| step | ms |\n|---|---|\n", bench.size.x,
                bench.size.y);
    for (auto& [name, values] : times) {
        std::sort(values.begin(), values.end());
        std::printf("| %s | %.0f |\n", name.c_str(), values[values.size() / 2]);
    }
    std::fflush(stdout);
}

/// How much of the converged volume's light no gain of the rays in screen space can explain.
void modelError(Bench& bench)
{
    ParameterValues& rays = bench.rays();
    rays = ParameterValues(table);
    rays.set(table.view, RayView::light);
    rays.set(table.ambient, 0.0);
    rays.set(table.densityNoise, 0.0);
    rays.set(table.jitter, false);
    rays.set(table.resolution, RayResolution::full);
    rays.set(table.volumeSteps, 512);
    const render::Image truth = bench.measure(false).picture;
    rays.set(table.technique, RayTechnique::screen);
    for (const double decay : {0.98, 0.99, 0.994, 0.998, 1.0}) {
        rays.set(table.decay, decay);
        const render::Image picture = bench.measure(false).picture;
        double product = 0;
        double square = 0;
        double truthSquare = 0;
        for (std::size_t i = 0; i < truth.pixels.size(); i += 4) {
            const double a = static_cast<double>(picture.pixels[i]);
            const double b = static_cast<double>(truth.pixels[i]);
            product += a * b;
            square += a * a;
            truthSquare += b * b;
        }
        const double explained = square > 0 && truthSquare > 0 ? product * product / (square * truthSquare) : 0;
        std::printf(" %.0f %% |", 100 * std::sqrt(1 - explained));
    }
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    std::vector<glm::ivec2> sizes{{640, 360}, {1280, 720}};
    if (argc == 3 && std::strcmp(argv[1], "--size") == 0) {
        sizes.resize(1);
        std::sscanf(argv[2], "%dx%d", &sizes[0].x, &sizes[0].y);
    }
    Bench bench;
    std::printf(
        "Time is that of the exhibit's own passes, median of five, by the process's CPU time around glFinish.\n");
    bench.size = sizes.back();
    entrance(bench);
    const Exhibit& exhibit = bench.museum.exhibit(bench.exhibit);
    const auto look = [&](const StudyView& view) {
        bench.camera = view.camera.transformed(bench.museum.worldFromExhibit(bench.exhibit));
    };
    const std::vector<StudyView> views = exhibit.studyViews(exhibit.parameters().initial());
    std::printf("\n## Model: what of the converged volume's light the screen does not explain, with the best gain\n\n| "
                "view | decay 0.98 | 0.99 | 0.994 | 0.998 | 1 |\n|---|---|---|---|---|---|\n");
    bench.size = {320, 180};
    for (const StudyView& view : views) {
        look(view);
        std::printf("| %s |", view.name.c_str());
        modelError(bench);
    }
    for (const glm::ivec2 size : sizes) {
        bench.size = size;
        for (const StudyView& view : views) {
            if (view.name != "best view" && (view.name != "window ahead" || size.x > 640)) continue;
            look(view);
            std::printf(
                "\n## Screen space, %s, %d × %d\n\nAgainst the loop with 4096 samples; a white mask gives 1.\n\n",
                view.name.c_str(), size.x, size.y);
            screenRays(bench);
            if (view.name == "best view") {
                std::printf("\n## Volume, %s, %d × %d\n\nAgainst 1024 steps.\n\n", view.name.c_str(), size.x, size.y);
                volume(bench);
            }
        }
    }
    return 0;
}
