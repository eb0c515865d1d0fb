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
#include <string>
#include <vector>

namespace vitrine::bench {

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
    const auto count = [](const Row& row, const char* of) { return static_cast<long long>(row.last.counters.at(of)); };
    std::printf("\n### %s\n\n| what | passes | draws | triangles | ms (clock) | lowest to highest | ms (wall) | "
                "against the first row |\n|---|---|---|---|---|---|---|---|\n",
                title);
    for (const Row& row : rows) {
        const auto [low, high] = std::minmax_element(row.cpu.begin(), row.cpu.end());
        std::printf("| %s | %lld | %lld | %lld | %.2f | %.2f to %.2f | %.2f | %.3f |\n", row.name.c_str(),
                    count(row, "passes"), count(row, "draws"), count(row, "triangles"), median(row.cpu), *low, *high,
                    median(row.wall), median(row.cpu) / median(rows.front().cpu));
    }
}

Row frame(std::string name, const Museum& museum, const SceneState& state, FrameRequest request, SharedRenderer with,
          double perFrame)
{
    return {std::move(name), [&museum, state, request, with = std::move(with), perFrame]() mutable {
                request.time += perFrame;
                return with->draw(test::planned(museum, state, request, with->persistentState()));
            }};
}

bool hallCosts(const Options& options)
{
    const int rounds = options.runsOr(9);
    const double start = render::wallSeconds();
    const render::gl::HeadlessContext context;
    const double contextReady = render::wallSeconds();
    const Museum museum{allExhibits()};
    const double museumReady = render::wallSeconds();
    const auto renderer = std::make_shared<render::gl::Renderer>();
    const SceneState sceneState = museum.initialSceneState();
    FrameRequest entrance;
    entrance.camera = sceneState.camera;
    entrance.raster.size = options.size;
    const render::FrameReport first =
        renderer->draw(test::planned(museum, sceneState, entrance, renderer->persistentState()));
    const double firstReady = render::wallSeconds();

    std::printf("Clock: %s\nSize: %d x %d, %d rounds in turn after 3 warm-up frames, medians\n", first.clock.c_str(),
                options.size.x, options.size.y, rounds);
    std::printf("\n### Start to first frame, without a window, programs as the cache has them\n\n| step | ms (wall) "
                "|\n|---|---|\n| OpenGL context | %.0f |\n| reading the hall | %.0f |\n| first frame: programs, "
                "uploads, shadow, probe, picture | %.0f |\n| together | %.0f |\n",
                1e3 * (contextReady - start), 1e3 * (museumReady - contextReady), 1e3 * (firstReady - museumReady),
                1e3 * (firstReady - start));

    // The empty hall has its own renderer, so that neither changes the other's cache.
    const Museum empty{std::vector<std::unique_ptr<Exhibit>>{}};
    const auto emptyRenderer = std::make_shared<render::gl::Renderer>();
    const SceneState emptySceneState = empty.initialSceneState();
    FrameRequest away = entrance;
    away.camera = {{0.5, 1.65, 9}, {0.5, 1.2, 12}, 0.959931};  // Exhibits and their shadows are out of view.
    FrameRequest intoTheBeam = away;
    intoTheBeam.camera.target.y = 3.2;  // The beam of the oculus is in view: it is ray marched and composited.
    const std::size_t sdf = *museum.find("sdf_morph");
    FrameRequest near = entrance;
    near.camera = museum.bestView(sdf, sceneState.values[sdf]);
    const auto draw = [&](const char* name, const FrameRequest& request) {
        return frame(name, museum, sceneState, request, renderer);
    };
    const auto drawEmpty = [&](const char* name, const FrameRequest& request) {
        return frame(name, empty, emptySceneState, request, emptyRenderer);
    };
    std::vector<Row> rows;
    rows.push_back(drawEmpty("empty hall, towards the door", away));
    rows.push_back(draw("hall with all exhibits out of view, towards the door", away));
    rows.push_back(drawEmpty("empty hall, above the door", intoTheBeam));
    rows.push_back(draw("hall with the exhibits out of view but for a beam in the air, above the door", intoTheBeam));
    rows.push_back(drawEmpty("empty hall, from the entrance", entrance));
    rows.push_back(draw("hall with the exhibit in view, from the entrance", entrance));
    rows.push_back(draw("hall, before the exhibit", near));
    measure(rows, rounds);
    print("Cost of the hall", rows);
    const auto passes = [](const Row& row) { return static_cast<long long>(row.last.counters.at("passes")); };
    std::printf("\nWith the exhibits out of view, the hall takes %lld passes, the empty hall %lld; its time is %.2f "
                "times that of the empty hall.\n",
                passes(rows[1]), passes(rows[0]), median(rows[1].cpu) / median(rows[0].cpu));

    std::vector<Row> sliders;
    const auto& table = static_cast<const sdf_morph::SdfMorph&>(museum.exhibit(sdf)).parameters();
    const auto slider = [&](const char* name, const SharedRenderer& with,
                            const std::function<void(SceneState&)>& move) {
        sliders.push_back({name, [&, with, move] {
                               SceneState changed = sceneState;
                               move(changed);
                               return with->draw(test::planned(museum, changed, near, with->persistentState()));
                           }});
    };
    double morph = 0, exposure = 0, elevation = 0.3;
    slider("exhibit before the visitor: nothing moved", renderer, [](SceneState&) {});
    slider("exhibit's slider (morph)", std::make_shared<render::gl::Renderer>(), [&](SceneState& changed) {
        changed.values[sdf].set(table.morph, morph = morph < 0.9 ? morph + 0.05 : 0.0);
    });
    slider("hall's slider that develops only (exposure)", renderer, [&](SceneState& changed) {
        changed.hall().setParameter(*changed.hall().table().find("exposure"),
                                    exposure = exposure < 1 ? exposure + 0.1 : -1.0);
    });
    // Its own renderer, because a moving sun leaves nothing to cache.
    slider("hall's slider that lights anew (sun elevation)", std::make_shared<render::gl::Renderer>(),
           [&](SceneState& changed) {
               changed.hall().setParameter(*changed.hall().table().find("sunElevation"),
                                           elevation = elevation < 0.5 ? elevation + 0.01 : 0.3);
           });
    measure(sliders, rounds);
    print("From a slider's change to the finished frame", sliders);

    // Separate renderers, so that the one with a static object keeps its shadow map.
    const std::size_t rays = *museum.find("crepuscular_rays");
    SceneState turning = sceneState;
    turning.values[rays].setParameter(*turning.values[rays].table().find("animate"), 1.0);
    std::vector<Row> mobile;
    mobile.push_back(frame("mobile at rest", museum, sceneState, entrance, std::make_shared<render::gl::Renderer>()));
    mobile.push_back(frame("mobile turning: its part of the sun's map anew in each frame", museum, turning, entrance,
                           std::make_shared<render::gl::Renderer>(), 1.0 / 30));
    measure(mobile, rounds);
    print("The turning mobile", mobile);
    std::printf("\nA frame with the mobile turning takes %.2f times as long as one with it at rest.\n",
                median(mobile[1].cpu) / median(mobile[0].cpu));
    return true;
}

}  // namespace vitrine::bench
