// Cost of a visitor's shader: from an edit of its text to the picture, in the start of the program, and in the frames
// of the hall.

#include "tests/bench/bench.h"
#include "tests/bench/child.h"

#include "exhibits/exhibits.h"
#include "exhibits/your_shader/your_shader.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/measure/clock.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <cstdio>

namespace vitrine::bench {
namespace {

/// Prints the time from an edited number, which no cache knows, to the picture.
void printEdits(const char* name, const std::string& before, const std::string& after, const Museum& museum, int runs)
{
    const std::size_t at = *museum.find("your_shader");
    const auto& shader = static_cast<const guest::YourShader&>(museum.exhibit(at));
    SceneState state = museum.initialSceneState();
    FrameRequest request{.camera = shader.bestView(state.values[at]), .alone = at};
    request.raster.size = {640, 360};
    render::gl::Renderer renderer;
    render::AssetStore assets;
    std::vector<double> compile, first, next;
    for (int run = -1; run < runs; ++run) {
        const std::string number = std::to_string(std::fmod(render::wallSeconds(), 1));
        const double start = render::wallSeconds();
        state.values[at] = shader.withText(state.values[at], before + number + after, assets).values;
        const double compiled = render::wallSeconds();
        renderer.draw(test::planned(museum, state, request, renderer.persistentState()));
        const double drawn = render::wallSeconds();
        state.values[at].set(shader.parameters().moment, state.values[at][shader.parameters().moment] + 0.02);
        renderer.draw(test::planned(museum, state, request, renderer.persistentState()));
        if (run < 0) continue;  // The first run starts the compiler and fills the other caches.
        compile.push_back(1e3 * (compiled - start));
        first.push_back(1e3 * (drawn - compiled));
        next.push_back(1e3 * (render::wallSeconds() - drawn));
    }
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", name, median(compile), median(first),
                median(compile) + median(first), median(next));
}

/// Prints the time from the start of the program to a picture on disk, with the drivers' programs cached.
void printStarts(int runs)
{
    const test::TemporaryFolder folder;
    std::vector<Row> rows;
    const auto add = [&](const char* name, std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--samples", "1", "--out", folder / "picture.png"});
        rows.push_back({name, [&folder, arguments] {
                            const Run run = runProgram(arguments, {{"XDG_CACHE_HOME", folder / "cache"},
                                                                   {"XDG_STATE_HOME", folder / "state"}});
                            return render::FrameReport{.milliseconds = 1e3 * run.cpuSeconds,
                                                       .wallMilliseconds = 1e3 * run.wallSeconds};
                        }});
    };
    add("hall, without", {"render", "hall", "--eye", "0.5,1.65,9", "--target", "0.5,1.2,12"});
    add("hall, with dunes.frag out of view",
        {"render", "hall", "--eye", "0.5,1.65,9", "--target", "0.5,1.2,12", "--set", "your_shader.file=dunes.frag"});
    add("hall, with dunes.frag in view", {"render", "your_shader", "--set", "file=dunes.frag"});
    measure(rows, runs);
    std::printf("\n### Start to a written picture, programs cached\n\n| what | ms (wall) | ms (CPU) | CPU against the "
                "first row |\n|---|---|---|---|\n");
    for (const Row& row : rows)
        std::printf("| %s | %.0f | %.0f | %.2f |\n", row.name.c_str(), median(row.wall), median(row.cpu),
                    median(row.cpu) / median(rows[0].cpu));
}

}  // namespace

bool yourShader(const Options& options)
{
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    std::vector<std::unique_ptr<Exhibit>> others = allExhibits();
    std::erase_if(others, [](const std::unique_ptr<Exhibit>& each) { return each->name() == "your_shader"; });
    const Museum without{std::move(others)};
    std::printf("### From an edit to the picture, alone, 640 x 360; without LiveText::pause\n\n| shader | ms to "
                "compile | ms program and first frame | ms together | ms next frame |\n|---|---|---|---|---|\n");
    const int runs = options.runsOr(9);
    printEdits("short: 1 line", "uniform float u_time;\nvoid main() { gl_FragColor = vec4(", " + u_time); }", museum,
               runs);
    const std::string dunes = render::readFile(render::asset("shaders") / "dunes.frag", 1U << 20U);
    const std::size_t number = dunes.find("420.0;");
    printEdits("long: dunes.frag, 246 lines, two passes", dunes.substr(0, number) + "420.0 + ",
               dunes.substr(number + 5), museum, runs);
    const std::size_t at = *museum.find("your_shader");
    const SceneState state = museum.initialSceneState(), rest = without.initialSceneState();
    FrameRequest away;
    away.camera = {{0.5, 1.65, 9}, {0.5, 1.2, 12}, 0.959931};
    away.raster.size = options.size;
    FrameRequest near = away;
    near.camera = museum.bestView(at, state.values[at]);
    SceneState moving = state;
    moving.values[at].set(static_cast<const guest::YourShader&>(museum.exhibit(at)).parameters().animate, true);
    const auto add = [&](std::vector<Row>& rows, const char* name, const Museum& in, const SceneState& values,
                         const FrameRequest& request) {
        rows.push_back(frame(name, in, values, request, std::make_shared<render::gl::Renderer>(), 1.0 / 30));
    };
    std::vector<Row> out, seen;
    add(out, "without the exhibit", without, rest, away);
    add(out, "with gyroid.frag, moving", museum, moving, away);
    add(seen, "without the exhibit", without, rest, near);
    add(seen, "with gyroid.frag, still", museum, state, near);
    add(seen, "with gyroid.frag, moving", museum, moving, near);
    measure(out, runs);
    measure(seen, runs);
    print("The hall, away from the frame", out);
    print("The hall, before the frame", seen);
    printStarts(options.runsOr(5));
    return true;
}

}  // namespace vitrine::bench
