// Cost of the hall and of its exhibits. In each round all cases of a table are measured in turn, so that other work on
// the machine disturbs all of them alike.

#include "tests/bench/bench.h"

#include "exhibits/exhibits.h"
#include "exhibits/museum/museum.h"
#include "exhibits/sdf_morph/sdf_morph.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/measure/clock.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::bench {
namespace {

struct Row {
    std::string name;
    std::function<render::FrameReport()> draw;
    std::vector<double> cpu{}, wall{};
    render::FrameReport last{};
};

void measure(std::vector<Row>& rows, int rounds)
{
    for (Row& row : rows)
        for (int warm = 0; warm < 3; ++warm) row.last = row.draw();
    for (int round = 0; round < rounds; ++round) {
        for (Row& row : rows) {
            row.last = row.draw();
            row.cpu.push_back(row.last.milliseconds);
            row.wall.push_back(row.last.wallMilliseconds);
        }
    }
}

void print(const char* title, const std::vector<Row>& rows)
{
    std::printf("\n### %s\n\n| what | passes | draws | triangles | ms (clock) | lowest to highest | ms (wall) | "
                "against the first row |\n|---|---|---|---|---|---|---|---|\n",
                title);
    for (const Row& row : rows) {
        const auto [low, high] = std::minmax_element(row.cpu.begin(), row.cpu.end());
        std::printf("| %s | %lld | %lld | %lld | %.2f | %.2f to %.2f | %.2f | %.3f |\n", row.name.c_str(),
                    static_cast<long long>(row.last.counters.at("passes")),
                    static_cast<long long>(row.last.counters.at("draws")),
                    static_cast<long long>(row.last.counters.at("triangles")), median(row.cpu), *low, *high,
                    median(row.wall), median(row.cpu) / median(rows.front().cpu));
    }
}

}  // namespace

bool hallCosts(const Options& options)
{
    const glm::ivec2 size = options.size;
    const int rounds = options.runsOr(9);
    const double start = render::wallSeconds();
    const render::gl::HeadlessContext context;
    const double contextReady = render::wallSeconds();
    const Museum museum{allExhibits()};
    const double museumReady = render::wallSeconds();
    render::gl::Renderer renderer;
    render::gl::Renderer aloneRenderer;
    const SceneState sceneState = museum.initialSceneState();
    FrameRequest entrance;
    entrance.camera = sceneState.camera;
    entrance.raster.size = size;
    const render::FrameReport first =
        renderer.draw(test::planned(museum, sceneState, entrance, renderer.persistentState()));
    const double firstReady = render::wallSeconds();

    std::printf("Clock: %s\nSize: %d x %d, %d rounds in turn after 3 warm-up frames, medians\n", first.clock.c_str(),
                size.x, size.y, rounds);
    std::printf("\n### Start to first frame, without a window, programs as the cache has them\n\n| step | ms (wall) "
                "|\n|---|---|\n| OpenGL context | %.0f |\n| reading the hall | %.0f |\n| first frame: programs, "
                "uploads, shadow, probe, picture | %.0f |\n| together | %.0f |\n",
                1e3 * (contextReady - start), 1e3 * (museumReady - contextReady), 1e3 * (firstReady - museumReady),
                1e3 * (firstReady - start));

    // The empty hall has its own renderer, so that neither changes the other's cache.
    const Museum empty{std::vector<std::unique_ptr<Exhibit>>{}};
    render::gl::Renderer emptyRenderer;
    const SceneState emptySceneState = empty.initialSceneState();
    FrameRequest away = entrance;
    away.camera = {{0.5, 1.65, 9}, {0.5, 1.2, 12}, 0.959931};  // Exhibits and their shadows are out of view.
    FrameRequest intoTheBeam = away;
    intoTheBeam.camera.target.y = 3.2;  // The beam of the oculus is in view: it is ray marched and composited.
    const std::size_t sdf = *museum.find("sdf_morph");
    FrameRequest near = entrance;
    near.camera = museum.bestView(sdf, sceneState.values[sdf]);
    FrameRequest alone = entrance;
    alone.alone = sdf;
    alone.camera = museum.subject(sdf).bestView(sceneState.values[sdf]);
    const auto draw = [&](const FrameRequest& request) {
        return [&museum, &renderer, &sceneState, request] {
            return renderer.draw(test::planned(museum, sceneState, request, renderer.persistentState()));
        };
    };
    const auto drawEmpty = [&](const FrameRequest& request) {
        return [&empty, &emptyRenderer, &emptySceneState, request] {
            return emptyRenderer.draw(test::planned(empty, emptySceneState, request, emptyRenderer.persistentState()));
        };
    };
    std::vector<Row> rows;
    rows.push_back({"empty hall, towards the door", drawEmpty(away)});
    rows.push_back({"hall with all exhibits out of view, towards the door", draw(away)});
    rows.push_back({"empty hall, above the door", drawEmpty(intoTheBeam)});
    rows.push_back({"hall with the exhibits out of view but for a beam in the air, above the door", draw(intoTheBeam)});
    rows.push_back({"empty hall, from the entrance", drawEmpty(entrance)});
    rows.push_back({"hall with the exhibit in view, from the entrance", draw(entrance)});
    rows.push_back({"hall, before the exhibit", draw(near)});
    measure(rows, rounds);
    print("Cost of the hall", rows);
    const auto passes = [](const Row& row) { return static_cast<long long>(row.last.counters.at("passes")); };
    std::printf("\nWith the exhibits out of view, the hall takes %lld passes, the empty hall %lld; its time is %.2f "
                "times that of the empty hall.\n",
                passes(rows[1]), passes(rows[0]), median(rows[1].cpu) / median(rows[0].cpu));

    std::vector<Row> sliders;
    const auto& table = static_cast<const SdfMorph&>(museum.exhibit(sdf)).parameters();
    double morph = 0;
    render::gl::Renderer morphRenderer;
    sliders.push_back({"exhibit before the visitor: nothing moved", draw(near)});
    sliders.push_back({"exhibit's slider (morph)", [&] {
                           SceneState changed = sceneState;
                           changed.values[sdf].set(table.morph, morph = morph < 0.9 ? morph + 0.05 : 0.0);
                           return morphRenderer.draw(
                               test::planned(museum, changed, near, morphRenderer.persistentState()));
                       }});
    double exposure = 0;
    sliders.push_back({"hall's slider that develops only (exposure)", [&] {
                           SceneState changed = sceneState;
                           changed.hall().setParameter(*changed.hall().table().find("exposure"),
                                                       exposure = exposure < 1 ? exposure + 0.1 : -1.0);
                           return renderer.draw(test::planned(museum, changed, near, renderer.persistentState()));
                       }});
    double elevation = 0.3;
    render::gl::Renderer sunRenderer;  // Its own renderer, because a moving sun leaves nothing to cache.
    sliders.push_back({"hall's slider that lights anew (sun elevation)", [&] {
                           SceneState changed = sceneState;
                           changed.hall().setParameter(*changed.hall().table().find("sunElevation"),
                                                       elevation = elevation < 0.5 ? elevation + 0.01 : 0.3);
                           return sunRenderer.draw(test::planned(museum, changed, near, sunRenderer.persistentState()));
                       }});
    measure(sliders, rounds);
    print("From a slider's change to the finished frame", sliders);

    // Separate renderers, so that the one with a static object keeps its shadow map.
    std::vector<Row> mobile;
    render::gl::Renderer stillRenderer;
    render::gl::Renderer turningRenderer;
    const std::size_t rays = *museum.find("crepuscular_rays");
    SceneState turning = sceneState;
    turning.values[rays].setParameter(*turning.values[rays].table().find("animate"), 1.0);
    FrameRequest later = entrance;
    mobile.push_back({"mobile at rest", [&] {
                          return stillRenderer.draw(
                              test::planned(museum, sceneState, entrance, stillRenderer.persistentState()));
                      }});
    mobile.push_back({"mobile turning: its part of the sun's map anew in each frame", [&] {
                          later.time += 1.0 / 30;
                          return turningRenderer.draw(
                              test::planned(museum, turning, later, turningRenderer.persistentState()));
                      }});
    measure(mobile, rounds);
    print("The turning mobile", mobile);
    std::printf("\nA frame with the mobile turning takes %.2f times as long as one with it at rest.\n",
                median(mobile[1].cpu) / median(mobile[0].cpu));

    std::vector<Row> variants;
    const auto variant = [&](const char* name, const std::function<void(ParameterValues&)>& change) {
        SceneState changed = sceneState;
        change(changed.values[sdf]);
        variants.push_back({name, [&museum, &aloneRenderer, alone, changed] {
                                return aloneRenderer.draw(
                                    test::planned(museum, changed, alone, aloneRenderer.persistentState()));
                            }});
    };
    variant("as it stands", [](ParameterValues&) {});
    variant("without cone pre-pass", [&](ParameterValues& v) { v.set(table.conePrepass, false); });
    variant("without cone pre-pass and relaxation", [&](ParameterValues& v) {
        v.set(table.conePrepass, false);
        v.set(table.relaxation, SdfRelaxation::none);
    });
    variant("no bounces", [&](ParameterValues& v) { v.set(table.bounces, 0); });
    variant("four bounces", [&](ParameterValues& v) { v.set(table.bounces, 4); });
    variant("glass", [&](ParameterValues& v) { v.set(table.material, SdfMaterial::glass); });
    variant("area shadow, 16 rays", [&](ParameterValues& v) { v.set(table.shadowMethod, SdfShadow::area); });
    measure(variants, rounds);
    print("The exhibit alone", variants);
    return true;
}

}  // namespace vitrine::bench
