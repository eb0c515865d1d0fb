// What normals from depth err by and cost, for every method, scene, resolution and depth buffer, in perspective, and at
// two resolutions in parallel projection; and what the whole look costs over the scene alone: over what it is drawn
// from (its sun's shadow map, its colors, normals and depth), and over the same scene lit, without lines and palette.
// Then, for thresholds of lines, how many texels have another line than by the drawn normals.
// Angles against the drawn normals. Prints Markdown.
//   bench_pixel_normals [--model FILE.glb] [--csv] [--look] [--small]
// --look: the whole look alone; --small: 240 x 135 alone.

#include "exhibits/pixel_art/method_table.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/scene/gltf.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

const PixelArtTable table;

struct Bench {
    render::gl::HeadlessContext context{false};
    render::gl::Renderer renderer;
    bool csv = false, small = false;

    NormalErrors measure(const ParameterValues& values, const std::vector<WorldPart>& parts,
                         const PaletteTextures* palette = nullptr, int runs = 5)
    {
        renderer.timeSteps(true);
        NormalErrors m = measureNormals(renderer, values, parts, palette, runs);
        renderer.timeSteps(false);
        return m;
    }
};

struct World {
    const char* name;
    std::vector<WorldPart> parts;
};

void printMethods(Bench& bench, const World& world, PixelResolution resolution, DepthBits bits,
                  PixelProjection projection = PixelProjection::perspective)
{
    const ParameterInfo& methods = table.rows()[table.method.row];
    const std::string size(table.rows()[table.resolution.row].choices[static_cast<std::size_t>(resolution)]);
    const std::string depth(table.rows()[table.depthBits.row].choices[static_cast<std::size_t>(bits)]);
    const std::string lens(table.rows()[table.projection.row].choices[static_cast<std::size_t>(projection)]);
    if (!bench.csv) {
        std::printf("\n## %s, %s, %s depth, %s\n\n", world.name, size.c_str(), depth.c_str(), lens.c_str());
        std::printf("| method | mean° | p99° | beyond 5°, %% | beyond 20°, %% | fetches | ms "
                    "|\n|---|---|---|---|---|---|---|\n");
    }
    // Large pictures take long, and their times hardly vary.
    const int runs = resolution == PixelResolution::r1920 ? 1 : resolution == PixelResolution::r960 ? 2 : 3;
    for (std::size_t i = 1; i < methods.choices.size(); ++i) {
        ParameterValues values = table.initial();
        values.set(table.resolution, resolution);
        values.set(table.depthBits, bits);
        values.set(table.projection, projection);
        values.set(table.method, static_cast<NormalsBy>(i));
        const NormalErrors m = bench.measure(values, world.parts, nullptr, runs);
        const std::string method(methods.choices[i]);
        const double ms = m.milliseconds.at("pixel_art/normals");
        const int fetches = fetchesOf(static_cast<NormalsBy>(i));
        if (bench.csv)
            std::printf("%s,%s,%s,%s,%s,%.4f,%.3f,%.4f,%.4f,%d,%.4f\n", world.name, size.c_str(), depth.c_str(),
                        lens.c_str(), method.c_str(), m.mean, m.p99, m.beyond5, m.beyond20, fetches, ms);
        else
            std::printf("| %s | %.3f | %.2f | %.3f | %.3f | %d | %.3f |\n", method.c_str(), m.mean, m.p99, m.beyond5,
                        m.beyond20, fetches, ms);
    }
}

/// Outlines, highlights and creases of every texel, as `view` shows them.
render::Image linesOf(Bench& bench, ParameterValues values, const std::vector<WorldPart>& parts)
{
    values.set(table.view, PixelView::edges);
    PixelShot shot{table, values, pixelCamera(table, values, {0, 0}), 0.5, parts};
    shot.seenSmaller = false;
    render::FramePlan plan;
    plan.view.raster.size = shot.camera.size;
    plan.allParts = true;
    planPixelPicture(shot, plan);
    plan.prune({pixelLitImage});
    bench.renderer.draw(plan);
    return bench.renderer.read(pixelLitImage);
}

/// How many texels have a line by these thresholds, and how many have another one than by the drawn normals, percent.
void printThreshold(Bench& bench, const World& world, Real row, const std::vector<double>& tried)
{
    const ParameterInfo& info = table.rows()[row.row];
    const double shownAs = info.unit == Unit::degree ? 180 / std::numbers::pi : 1;
    for (const double threshold : tried) {
        std::printf("| %s | %s %g |", world.name, std::string(info.name).c_str(), threshold);
        ParameterValues values = table.initial();
        values.set(row, threshold / shownAs);
        values.set(table.method, NormalsBy::trueNormals);
        const render::Image truth = linesOf(bench, values, world.parts);
        const std::size_t texels = truth.pixels.size() / 4;
        const auto differ = [&](std::size_t i, const render::Image& other) {
            return !std::equal(truth.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i),
                               truth.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i + 3),
                               other.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i));
        };
        const auto percent = [&](const render::Image& other) {
            std::size_t count = 0;
            for (std::size_t i = 0; i < texels; ++i) count += differ(i, other);
            return 100.0 * static_cast<double>(count) / static_cast<double>(texels);
        };
        render::Image none = truth;  // The color of a texel without a line.
        for (float& x : none.pixels) x = *std::min_element(truth.pixels.begin(), truth.pixels.end());
        std::printf(" %.2f |", percent(none));
        for (const NormalsBy method : {NormalsBy::tap5, NormalsBy::tap9Plus, NormalsBy::parabola, NormalsBy::vote}) {
            values.set(table.method, method);
            std::printf(" %.2f |", percent(linesOf(bench, values, world.parts)));
        }
        std::printf("\n");
    }
}

void printThresholds(Bench& bench, const std::vector<World>& worlds)
{
    std::printf(
        "\n## Thresholds of lines, 240 x 135, orthographic\n\n| scene | threshold | with a line, %% | otherwise by 5 "
        "tap, %% | 9 plus tap | parabola | vote |\n|---|---|---|---|---|---|---|\n");
    for (const World& world : worlds) {
        printThreshold(bench, world, table.outlineGap, {1.5, 3, 4.5, 6, 9, 18});
        printThreshold(bench, world, table.edgeAngle, {10, 20, 32, 45, 60, 90});
    }
}

double sumOf(const NormalErrors& m)
{
    double all = 0;
    for (const auto& [name, ms] : m.milliseconds)
        if (name.rfind("pixel_art/", 0) == 0) all += ms;
    return all;
}

void printLook(Bench& bench)
{
    ParameterValues values = table.initial();
    values.set(table.resolution, PixelResolution::r480);
    const auto colors = shippedPalette(PaletteName::isle);
    const PaletteTextures palette = paletteTextures({colors.begin(), colors.end()});
    const NormalErrors m = bench.measure(values, isleParts(0.5), &palette);
    std::printf("\n## The whole look of the isle, 480 x 270\n\n| pass | ms |\n|---|---|\n");
    for (const auto& [name, ms] : m.milliseconds)
        if (name.rfind("pixel_art/", 0) == 0) std::printf("| %s | %.3f |\n", name.c_str(), ms);
    const double scene = m.milliseconds.at("pixel_art/sun") + m.milliseconds.at("pixel_art/world");
    std::printf("\nThe whole look takes %.2f times what it is drawn from (goal: 1.3)", sumOf(m) / scene);
    values.set(table.method, NormalsBy::trueNormals);
    values.set(table.outlineStrength, 0.0);
    values.set(table.highlightStrength, 0.0);
    std::printf(" and %.2f times the scene lit, with the normals as drawn, without lines and palette.\n",
                sumOf(m) / sumOf(bench.measure(values, isleParts(0.5))));
}

}  // namespace

int main(int argc, char** argv)
{
    Bench bench;
    std::vector<World> worlds{{"test scene", testParts(0.5)}, {"thin bars", barParts()}, {"isle", isleParts(0.5)}};
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--csv") == 0) bench.csv = true;
        if (std::strcmp(argv[i], "--small") == 0) bench.small = true;
        if (std::strcmp(argv[i], "--look") == 0) worlds.clear();
        if (std::strcmp(argv[i], "--model") == 0 && i + 1 < argc)
            worlds.push_back({"a visitor's model", modelParts(render::loadGltf(argv[i + 1]), 0)});
    }
    if (bench.csv) std::printf("scene,size,depth,projection,method,mean,p99,beyond5,beyond20,fetches,ms\n");
    for (const World& world : worlds) {
        const std::size_t sizes = bench.small ? 1 : table.rows()[table.resolution.row].choices.size();
        for (std::size_t size = 0; size < sizes; ++size)
            for (const DepthBits bits : {DepthBits::float32, DepthBits::unorm24, DepthBits::unorm16})
                printMethods(bench, world, static_cast<PixelResolution>(size), bits);
        for (const PixelResolution size : {PixelResolution::r240, PixelResolution::r480})
            printMethods(bench, world, size, DepthBits::float32, PixelProjection::orthographic);
    }
    if (!bench.csv && !worlds.empty()) printThresholds(bench, worlds);
    if (!bench.csv) printLook(bench);
    return 0;
}
