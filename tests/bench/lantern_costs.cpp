// What rays among the lanterns of the lake cost, by the source's ways to repeat them and by ours: evaluations of the
// field per pixel and the pixels that each way misses, counted at float32 against every lantern by itself at float64;
// then pictures: mirror images, lanterns in number, steps of the water, what is left out. Prints Markdown.
//   bench_lantern_costs [--size 320x180] [--only counts|pictures]

#include "exhibits/exhibits.h"
#include "exhibits/museum/picture.h"
#include "exhibits/paper_lanterns/paper_lanterns_cpu.h"
#include "exhibits/paper_lanterns/paper_lanterns_cpu32.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/exhibits/paper_lanterns/lake_at_float64.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

const PaperLanternsTable& table = test::lanternsTable();

/// Rays of a picture from the best view, in the lake's world.
std::vector<glsl::Lake::LanternRay> raysOf(const ParameterValues& values, glm::ivec2 size)
{
    const Portal portal = lakePortal(table, values);
    const render::Camera camera = portalView(portal);
    const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
    const double tall = std::tan(0.5 * camera.fovY), wide = tall * size.x / size.y;
    std::vector<glsl::Lake::LanternRay> rays;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec3 d =
                ahead + glm::dvec3(wide * (2 * (x + 0.5) / size.x - 1), tall * (1 - 2 * (y + 0.5) / size.y), 0);
            glsl::Lake::LanternRay ray{};
            ray.origin = glm::dvec3(portal.workFromExhibit * glm::dvec4(camera.eye, 1));
            ray.direction = glm::normalize(glm::dmat3(portal.workFromExhibit) * d);
            ray.to = 300;
            ray.spread = glm::dvec2(2 * tall / size.y);
            rays.push_back(ray);
        }
    return rays;
}

glsl32::Lake::LanternRay at32(const glsl::Lake::LanternRay& ray)
{
    glsl32::Lake::LanternRay single{};
    single.origin = glm::vec3(ray.origin);
    single.direction = glm::vec3(ray.direction);
    single.from = static_cast<float>(ray.from);
    single.to = static_cast<float>(ray.to);
    single.spread = glm::vec2(ray.spread);
    return single;
}

void counts(glm::ivec2 size)
{
    ParameterValues values = test::sourceLake();
    values.set(table.lanterns, 2500);
    values.set(table.spacing, 6.0);
    const LakeBlock block = lakeBlock(table, values, 3);
    glsl::Lake exact = test::lakeAtFloat64(values, 3);
    const auto all = test::everyLantern(exact);
    glsl32::Lake lake;
    copyLake(lake.lake, block);
    lake.lake.pointWidth = 1e9F;
    lake.lake.meanWidth = 1e9F;
    lake.blueNoise = exact.blueNoise;
    const auto rays = raysOf(values, size);
    std::vector<double> truth;
    for (const auto& ray : rays) truth.push_back(test::nearestOfAll(exact, all, ray));
    std::printf(
        "\n## Where a ray looks for lanterns\n\n%d x %d pixels from the best view, 2500 lanterns 6 m apart that fill "
        "their cells, up to 300 m; none is drawn as a point. Missed: the ray goes on behind the lantern by more "
        "than a pixel and a centimeter. Too early: it ends on an edge that it passes within the tolerance of a tenth "
        "of a pixel, where the source's ways end whatever comes as near, and ours goes on until it touches.\n\n| way | "
        "evaluations per pixel | missed pixels | too early "
        "|\n|---|---|---|---|\n",
        size.x, size.y);
    const auto count = [&](const char* name, int repetition) {
        lake.evaluations = 0;
        int missed = 0, early = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto ray = at32(rays[i]);
            const auto walk =
                repetition == REPEAT_CELL_WALL ? lake.walkLanterns(ray) : lake.walkNeighbors(ray, repetition, 1024);
            const double found = walk.part == PART_NONE ? rays[i].to : static_cast<double>(walk.distance);
            const double margin = 0.01 + 2 * rays[i].spread.x * truth[i];
            missed += found > truth[i] + margin;
            early += found < truth[i] - std::max(margin, 0.05 * truth[i]);
        }
        std::printf("| %s | %.2f | %d | %d |\n", name, lake.evaluations / static_cast<double>(rays.size()), missed,
                    early);
        std::fflush(stdout);
    };
    count("own cell", REPEAT_OWN_CELL);
    count("2 x 2 cells, as in the source", REPEAT_2X2);
    count("3 x 3 cells", REPEAT_3X3);
    count("row by row, within each lantern's bounds (ours)", REPEAT_CELL_WALL);
}

struct Pictures {
    render::gl::HeadlessContext context{false};
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    SceneState sceneState = museum.initialSceneState();
    std::size_t exhibit = *museum.find("paper_lanterns");
    glm::ivec2 size{320, 180};
    render::Image reference;

    ParameterValues& values() { return sceneState.values[exhibit]; }

    FrameRequest frame()
    {
        FrameRequest request;
        request.alone = exhibit;
        request.camera = museum.subject(exhibit).bestView(values());
        request.raster.size = size;
        request.averageIn = AverageIn::radiance;
        request.channels.evaluations = true;
        return request;
    }

    double milliseconds(const FrameRequest& request)
    {
        renderer.timeSteps(true);
        std::vector<double> times;
        for (int run = 0; run < 6; ++run) {
            double sum = 0;
            for (const render::StepReport& step :
                 renderer.draw(test::planned(museum, sceneState, request, renderer.persistentState())).ran)
                if (step.name.rfind("paper_lanterns/", 0) == 0) sum += step.milliseconds;
            if (run > 0) times.push_back(sum);
        }
        renderer.timeSteps(false);
        std::sort(times.begin(), times.end());
        return times[2];
    }

    /// One row; returns its time.
    double row(const char* name, double against)
    {
        const FrameRequest request = frame();
        PictureMaker maker(museum, renderer, sceneState, {.frame = request});
        while (maker.step()) {
        }
        const render::Image picture = maker.picture();
        double evaluations = 0, squares = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                evaluations += static_cast<double>(picture.at(x, y, 4));
                for (int c = 0; c < 3 && !reference.pixels.empty(); ++c) {
                    const double d =
                        static_cast<double>(picture.at(x, y, c)) - static_cast<double>(reference.at(x, y, c));
                    squares += d * d / 3;
                }
            }
        const double pixels = static_cast<double>(size.x) * size.y;
        const double ms = milliseconds(request);
        std::printf("| %s | %.2f | %.0f | %.2f | %.4f |\n", name, evaluations / pixels, ms,
                    against > 0 ? ms / against : 1.0, std::sqrt(squares / pixels));
        std::fflush(stdout);
        if (reference.pixels.empty()) reference = picture;
        return ms;
    }

    void head(const char* title)
    {
        std::printf("\n## %s\n\n| setting | evaluations per pixel | ms | over the first | RMSE to the first "
                    "|\n|---|---|---|---|---|\n",
                    title);
        reference = {};
        values() = ParameterValues(table);
    }
};

void pictures(glm::ivec2 size)
{
    Pictures bench;
    bench.size = size;
    ParameterValues& v = bench.values();
    bench.head("Mirror images");
    v.set(table.bounces, 0);
    const double none = bench.row("none: the sky alone", 0);
    for (const int bounces : {1, 2, 3}) {
        v.set(table.bounces, bounces);
        bench.row((std::to_string(bounces) + " at most").c_str(), none);
    }
    bench.head("Lanterns on the lake");
    v.set(table.lanterns, 100);
    const double few = bench.row("100", 0);
    for (const int count : {1, 1000, 10000, 100000, 1000000}) {
        v.set(table.lanterns, count);
        bench.row(std::to_string(count).c_str(), few);
    }
    bench.head("Ways to repeat, alike otherwise, one mirror image");
    const double ours = bench.row("to the cell's wall", 0);
    v.set(table.stepLimit, 256);
    v.set(table.repetition, LakeRepetition::twoByTwo);
    bench.row("2 x 2 cells", ours);
    v.set(table.repetition, LakeRepetition::threeByThree);
    bench.row("3 x 3 cells", ours);
    bench.head("Steps of the water");
    v.set(table.waterSteps, 256);
    const double many = bench.row("256", 0);
    for (const int steps : {40, 20, 10, 5}) {
        v.set(table.waterSteps, steps);
        bench.row(std::to_string(steps).c_str(), many);
    }
    bench.head("What is left out");
    const double whole = bench.row("as it opens", 0);
    v.set(table.moon, 0.0);
    bench.row("no moon", whole);
    v.set(table.waveHeight, 0.0);
    bench.row("and no waves", whole);
    v.set(table.bounces, 0);
    bench.row("and no mirror images", whole);
    v.set(table.crowding, 0.0);
    bench.row("and no lanterns", whole);
}

}  // namespace

int main(int argc, char** argv)
{
    glm::ivec2 size{320, 180};
    std::string only;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &size.x, &size.y);
        if (std::strcmp(argv[i], "--only") == 0) only = argv[i + 1];
    }
    if (only.empty() || only == "counts") counts(size);
    if (only.empty() || only == "pictures") pictures(size);
    return 0;
}
