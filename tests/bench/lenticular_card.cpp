// What the simulated card costs: every model and every switch that trades accuracy for time, from near and from
// far, measured in turn in each round. Prints a table; passes or fails nothing.
//   bench_lenticular_card [--size 480x270] [--rounds 7]

#include "exhibits/exhibits.h"
#include "exhibits/lenticular/lenticular.h"
#include "exhibits/museum/museum.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

struct Row {
    std::string name;
    SceneState sceneState;
    FrameRequest request;
    std::vector<double> cpu{};
    double traces = 0;  ///< Per pixel of the card.
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Rays traced per pixel that shows the card.
double tracesOf(const Museum& museum, render::gl::Renderer& renderer, const Row& row)
{
    PictureRequest request;
    request.frame = row.request;
    request.frame.channels.evaluations = true;
    PictureMaker maker(museum, renderer, row.sceneState, request);
    while (maker.step()) {
    }
    const render::Image& image = maker.picture();
    double sum = 0;
    double pixels = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double traces = image.at(x, y, image.channels - 1);
            sum += traces;
            pixels += traces > 0;
        }
    return sum / std::max(pixels, 1.0);
}

}  // namespace

int main(int argc, char** argv)
{
    glm::ivec2 size(480, 270);
    int rounds = 7;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &size.x, &size.y);
        if (std::strcmp(argv[i], "--rounds") == 0) rounds = std::max(std::atoi(argv[i + 1]), 3);
    }
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    const std::size_t card = *museum.find("lenticular");
    const auto& exhibit = static_cast<const Lenticular&>(museum.exhibit(card));
    const LenticularTable& t = exhibit.parameters();

    struct View {
        const char* name;
        render::Camera camera;
    };
    const glm::dvec3 m = cardMiddle();
    // The card fills the picture: from a meter lenses are smaller than a pixel, from 12 cm each is 15 pixels wide.
    const View views[] = {
        {"filling the picture, lenses smaller than a pixel", {m + glm::dvec3(0.1, 0.05, 1.0), m, 0.4}},
        {"close up, a lens over many pixels", {m + glm::dvec3(0.02, 0.01, 0.12), m, 0.4}}};
    render::FrameReport report;
    std::printf("Size: %d x %d, alone, %d rounds in turn after 2 warm-up frames, medians. The whole frame is counted, "
                "the passes around the card too;\ntraces are exact and do not depend on the machine.\n",
                size.x, size.y, rounds);
    for (const View& view : views) {
        std::vector<Row> rows;
        const auto add = [&](const char* name, const std::function<void(ParameterValues&)>& change) {
            Row row{name, museum.initialSceneState(), {}};
            change(row.sceneState.values[card]);
            row.request.alone = card;
            row.request.camera = view.camera;
            row.request.raster.size = size;
            rows.push_back(std::move(row));
        };
        add("exact Snell, 8 parts (as it stands)", [](ParameterValues&) {});
        add("paraxial, 8 parts", [&](ParameterValues& v) { v.set(t.model, CardModel::paraxial); });
        add("linear, 8 parts", [&](ParameterValues& v) { v.set(t.model, CardModel::linear); });
        add("exact, one ray a pixel (moire)", [&](ParameterValues& v) { v.set(t.prefilter, false); });
        add("exact, 1 part", [&](ParameterValues& v) { v.set(t.apertureSamples, 1); });
        add("exact, 3 parts", [&](ParameterValues& v) { v.set(t.apertureSamples, 3); });
        add("exact, 16 parts", [&](ParameterValues& v) { v.set(t.apertureSamples, 16); });
        add("exact, 64 parts", [&](ParameterValues& v) { v.set(t.apertureSamples, 64); });
        add("exact, with dispersion", [&](ParameterValues& v) { v.set(t.dispersion, true); });
        add("exact, both eyes in red and cyan", [&](ParameterValues& v) { v.set(t.eyes, CardEyes::anaglyph); });
        add("exact, gloss of 1 normal", [&](ParameterValues& v) { v.set(t.glossSamples, 1); });
        add("exact, gloss of 16 normals", [&](ParameterValues& v) { v.set(t.glossSamples, 16); });
        add("exact, rolling", [&](ParameterValues& v) {
            v.set(t.hold, 0.0);
            v.set(t.period, 10.0);
        });
        rows.back().request.time = 5;
        for (Row& row : rows) {
            for (int warm = 0; warm < 2; ++warm)
                report = renderer.draw(test::planned(museum, row.sceneState, row.request, renderer.persistentState()));
            row.traces = tracesOf(museum, renderer, row);
        }
        for (int round = 0; round < rounds; ++round)
            for (Row& row : rows) {
                // The second in a row: what the first had to make is kept.
                for (int i = 0; i < 2; ++i)
                    report =
                        renderer.draw(test::planned(museum, row.sceneState, row.request, renderer.persistentState()));
                row.cpu.push_back(report.milliseconds);
            }
        std::printf("\n### The card %s\n\n| model | traces per pixel | ms (%s) | lowest to highest | against the first "
                    "row |\n|---|---|---|---|---|\n",
                    view.name, report.clock.c_str());
        for (const Row& row : rows) {
            const auto [low, high] = std::minmax_element(row.cpu.begin(), row.cpu.end());
            std::printf("| %s | %.1f | %.2f | %.2f to %.2f | %.2f |\n", row.name.c_str(), row.traces, median(row.cpu),
                        *low, *high, median(row.cpu) / median(rows.front().cpu));
        }
    }
    return 0;
}
