// How wrong the filters of the hall's shadows are, and what they cost: every filter, over the size of the map or the
// number of comparisons, against an area light, the mean over many suns spread over the sun's disk, each with a hard
// shadow. Prints Markdown.
//   bench_shadow_filters [--suns 128]

#include "exhibits/exhibits.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/measure/statistics.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

const HallTable table;
int suns = 128;

struct View {
    const char* name;
    render::Camera camera;
};
// What makes these shadows hangs or stands 8 to 14 m away: the window's frame and bars, the banner and the mobile.
const View views[] = {{"the window's light on the floor", {{0.9, 3.2, -0.6}, {0.5, 0, -2.4}, 0.7}},
                      {"the banner's and the mobile's shadows", {{-1.6, 2.6, 3.4}, {0.3, 0, 0.6}, 0.8}}};
const double disks[] = {0.00925, 0.05};

struct Bench {
    render::gl::HeadlessContext context{false};
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    SceneState sceneState = museum.initialSceneState();
    FrameRequest frame;

    Bench()
    {
        frame.raster.size = {160, 90};
        frame.averageIn = AverageIn::radiance;
        hall().set(table.reflectionProbe, false);
        hall().set(table.bakedLight, false);
        // The floor and what falls on it: nothing in the air.
        const std::size_t rays = *museum.find("crepuscular_rays");
        sceneState.values[rays].setRow(*sceneState.values[rays].table().find("technique"), 0.0);
    }
    ParameterValues& hall() { return sceneState.hall(); }
    render::Image draw()
    {
        PictureMaker maker(museum, renderer, sceneState, {.frame = frame});
        while (maker.step()) {
        }
        return maker.picture();
    }
    /// Milliseconds of a frame whose shadow maps are up to date, median of seven.
    double time()
    {
        std::vector<double> times;
        for (int run = 0; run < 7; ++run)
            times.push_back(
                renderer.draw(test::planned(museum, sceneState, frame, renderer.persistentState())).milliseconds);
        std::sort(times.begin(), times.end());
        return times[3];
    }
    render::Image areaLight(double width)
    {
        const ParameterValues before = hall();
        hall().set(table.shadowFilter, ShadowFilter::hard);
        hall().set(table.shadowMapSize, 4096);
        render::Image mean;
        for (int i = 0; i < suns; ++i) {
            const double radius = 0.5 * width * std::sqrt((i + 0.5) / suns);
            const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
            const double elevation = before[table.sunElevation];
            hall().set(table.sunElevation, elevation + radius * std::sin(angle));
            hall().set(table.sunAzimuth, before[table.sunAzimuth] + radius * std::cos(angle) / std::cos(elevation));
            const render::Image one = draw();
            if (i == 0) mean = render::Image(one.width, one.height, one.channels);
            for (std::size_t p = 0; p < mean.pixels.size(); ++p)
                mean.pixels[p] += one.pixels[p] / static_cast<float>(suns);
        }
        hall() = before;
        return mean;
    }
};

/// Of 1 for the light of the whole sun: root mean square over the picture.
double errorOf(const render::Image& picture, const render::Image& truth, double sunlight)
{
    double sum = 0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x)
            sum += std::pow(static_cast<double>(picture.at(x, y, 1)) - static_cast<double>(truth.at(x, y, 1)), 2);
    return std::sqrt(sum / (static_cast<double>(truth.width) * truth.height)) / sunlight;
}

double brightest(const render::Image& picture)
{
    std::vector<double> values;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) values.push_back(static_cast<double>(picture.at(x, y, 1)));
    std::sort(values.begin(), values.end());
    return values[values.size() * 98 / 100];
}

const char* const filters[] = {"hard", "tent 3x3", "tent 5x5", "sun's disk"};

void study(Bench& bench, const render::Image& truth)
{
    const double sunlight = brightest(truth);
    const ParameterValues before = bench.hall();
    std::printf("| filter | map | comparisons | error | ms |\n|---|---|---|---|---|\n");
    const auto line = [&](ShadowFilter filter, int size, int comparisons) {
        bench.hall().set(table.shadowFilter, filter);
        bench.hall().set(table.shadowMapSize, size);
        bench.hall().set(table.diskSamples, comparisons);
        const double error = errorOf(bench.draw(), truth, sunlight);
        std::printf("| %s | %d | %d | %.4f | %.1f |\n", filters[static_cast<int>(filter)], size, comparisons, error,
                    bench.time());
        std::fflush(stdout);
        return error;
    };
    for (const int size : {512, 1024, 2048, 4096}) line(ShadowFilter::hard, size, 1);
    for (const int size : {512, 1024, 2048, 4096}) line(ShadowFilter::tent3, size, 4);
    for (const int size : {256, 512, 1024, 2048, 4096}) line(ShadowFilter::tent5, size, 9);
    for (const int size : {1024, 4096}) line(ShadowFilter::disk, size, 24);
    std::vector<double> errors;
    std::vector<double> comparisons;
    for (const int n : {2, 4, 8, 16, 24, 32, 64, 128, 256}) {
        errors.push_back(line(ShadowFilter::disk, 2048, n));
        comparisons.push_back(n);
    }
    // What no number of comparisons mends (one layer of depth, one mean distance, the map's texels) is not theirs.
    const double rest = errors.back();
    errors.resize(errors.size() - 2);
    comparisons.resize(errors.size());
    for (double& error : errors) error = std::sqrt(std::max(error * error - rest * rest, 0.0));
    const render::PowerLaw law = render::fitPowerLaw(errors, comparisons);
    if (law.points >= 3)
        std::printf("\nWith the sun's disk, halving what too few comparisons are wrong by costs %.2f times the "
                    "comparisons (%.2f to %.2f with 95 %% confidence); %.4f stay however many there are.\n",
                    std::pow(2, -law.slope), std::pow(2, -law.slopeInterval.high), std::pow(2, -law.slopeInterval.low),
                    rest);
    bench.hall() = before;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], "--suns") == 0) suns = std::max(std::atoi(argv[2]), 1);
    Bench bench;
    std::printf("%d × %d. The error is the root mean square, of the light of the whole sun, against the mean of %d "
                "hard shadows of\n"
                "suns spread over the disk; the map's size is in texels along a side (8192 would be exact), the "
                "comparisons are those over the disk or the tent. "
                "Time is that of a frame of floor and walls, median of seven.\n",
                bench.frame.raster.size.x, bench.frame.raster.size.y, suns);
    for (const View& view : views) {
        for (const double disk : disks) {
            bench.frame.camera = view.camera;
            bench.hall().set(table.sunDisk, disk);
            std::printf("\n## %s, a sun of %.2f°\n\n", view.name, disk * 180 / std::numbers::pi);
            study(bench, bench.areaLight(disk));
        }
    }
    return 0;
}
