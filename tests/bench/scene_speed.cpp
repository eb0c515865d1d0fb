// What a picture of a scene costs by each way to ask its field, beside the source's own way, and how long a change
// takes to be seen. Prints Markdown.
//   bench_scene_speed [--size 640x360] [--most 1024] [--only ways|near|edits|scenes]

#include "exhibits/exhibits.h"
#include "exhibits/museum/picture.h"
#include "exhibits/sdf_scenes/near_scene.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "render/failure.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/bench/many_shapes.h"
#include "tests/bench/source_march.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace vitrine;
using glm::dvec3;

const SdfScenesTable table;

double now()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Measured {
    double evaluations = 0, shapes = 0;  ///< A pixel, mean.
    double milliseconds = 0;             ///< Of the exhibit's own pass.
    double firstSeconds = 0;             ///< Of the first frame, with its program built.
    int missed = 0, extra = 0, asked = 0;
};

struct Bench {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / ("scene_speed" + std::to_string(getpid()));
    render::gl::HeadlessContext context{false};
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    SceneState sceneState = museum.initialSceneState();
    std::size_t exhibit = *museum.find("sdf_scenes");
    glm::ivec2 size{640, 360};
    int runs = 3;

    Bench() { std::filesystem::create_directories(folder); }
    ~Bench()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }

    ParameterValues& values() { return sceneState.values[exhibit]; }

    std::filesystem::path write(const std::string& root, const std::string& camera)
    {
        const std::filesystem::path path = folder / "scene.json";
        std::ofstream(path) << "{\"format\": \"vitrine-scene\", \"version\": 1,\n\"camera\": " << camera
                            << ",\n\"lights\": [{\"kind\": \"sun\"}],\n\"root\": " << root << "}\n";
        return path;
    }
    void read(const std::filesystem::path& path)
    {
        values().set(table.scene, path.string());
        TabledSceneState read = museum.readTables(sceneState);
        if (!read.unreadable.empty()) throw Failure(Blame::file, read.unreadable.front());
        sceneState = std::move(read.sceneState);
    }
    const scenes::ShownScene& shown() { return *static_cast<const SdfScenesTable&>(values().table()).shown; }

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

    render::FramePlan plan(bool source)
    {
        const FrameRequest request = frame();
        render::FramePlan made = test::planned(museum, sceneState, request, renderer.persistentState());
        made.allParts = true;  // Programs are waited for.
        if (source) askAsTheSourceDoes(made);
        return made;
    }

    /// No frame of the program asks for this, so that no plan offers it.
    void askAsTheSourceDoes(render::FramePlan& made)
    {
        for (const render::Pass& pass : made.passes())
            if (pass.name == "sdf_scenes/scene")
                bench::useSourceMarch(const_cast<render::Pass&>(pass), *shown().program,
                                      shown().program->words(shown().scene->numbersAt(0)));
    }

    double draw(const render::FramePlan& made)
    {
        double sum = 0;
        for (const render::StepReport& step : renderer.draw(made).ran)
            if (step.name == "sdf_scenes/scene") sum += step.milliseconds;
        return sum;
    }

    double mean()
    {
        const render::Image counts = renderer.read(evaluationsImage);
        double sum = 0;
        for (const float count : counts.pixels) sum += static_cast<double>(count);
        return sum / (static_cast<double>(size.x) * size.y);
    }

    Measured measure(SceneEvaluation way, bool source = false)
    {
        Measured m;
        values().set(table.evaluation, way);
        renderer.timeSteps(true);
        const double begun = now();
        draw(plan(source));
        m.firstSeconds = now() - begun;
        std::vector<double> times;
        const int slow = m.firstSeconds > 3 ? 1 : runs;
        for (int run = 0; run < slow; ++run) times.push_back(draw(plan(source)));
        renderer.timeSteps(false);
        std::sort(times.begin(), times.end());
        m.milliseconds = times[times.size() / 2];
        m.evaluations = mean();
        compare(m);
        if (!source && m.milliseconds < 2000) {
            values().set(table.heatMap, SceneHeatMap::shapes);
            draw(plan(false));
            m.shapes = mean();
            values().set(table.heatMap, SceneHeatMap::none);
        }
        return m;
    }

    /// Pixels of the last picture that are hit, against a trace at float64, of one in 64.
    void compare(Measured& m)
    {
        const render::Image depth = renderer.read(depthImage);
        const render::View view = render::makeView(frame().camera, frame().raster);
        const scenes::Scene& scene = *shown().scene;
        const scenes::SceneField field(shown().scene);
        const glm::dmat4 into =
            scenes::scenePortal(scenes::sceneCamera(scene, scene.numbersAt(0), 0), shown().toOpening).workFromExhibit;
        const dvec3 eye(into * glm::dvec4(view.eye, 1));
        for (int y = 3; y < size.y; y += 8)
            for (int x = 3; x < size.x; x += 8) {
                const glm::dvec2 ndc = glm::dvec2(x + 0.5, y + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
                const dvec3 ray = glm::normalize(dvec3(into * glm::dvec4(view.direction(ndc), 0)));
                double t = 0, closest = 1e9;
                for (int step = 0; step < 4000 && t < 60 && closest > 1e-7; ++step) {
                    const double f = field.distance(eye + t * ray);
                    closest = std::min(closest, f / std::max(t, 0.1));
                    t += f;
                }
                const bool hit = closest <= 1e-7 || t < 60;
                const bool shownHit = depth.at(x, size.y - 1 - y, 0) > 1e-9F;
                ++m.asked;
                m.missed += hit && !shownHit;
                // Within half a pixel of a surface is on it.
                m.extra += !hit && shownHit && closest > 0.002;
            }
    }
};

void row(const char* name, const Measured& m)
{
    std::printf("| %s | %.2f | %.1f | %.0f | %.1f | %d | %d |\n", name, m.evaluations, m.shapes, m.milliseconds,
                m.firstSeconds, m.missed, m.extra);
    std::fflush(stdout);
}

/// `nearAlone`: without the others, which take minutes.
void ways(Bench& bench, int most, bool nearAlone)
{
    struct Way {
        const char* name;
        SceneEvaluation way;
        int most;  ///< Shapes: with more, building it takes minutes, or a picture does.
        bool source = false;
    };
    const Way all[] = {{"the source's way", SceneEvaluation::shapes, 64, true},
                       {"interpreter, every kind", SceneEvaluation::interpreter, 64},
                       {"lists, of the scene's kinds", SceneEvaluation::lists, 64},
                       {"generated, uniforms", SceneEvaluation::shapes, 64},
                       {"generated, constants", SceneEvaluation::folded, 64},
                       {"what is near", SceneEvaluation::near, 1 << 20}};
    bench.values().set(table.shadowMethod, SceneShadow::none);
    bench.values().set(table.occlusionMethod, SceneOcclusion::none);
    double at16 = 0, shapesAt16 = 0, last = 0, lastShapes = 0;
    for (int count = 4; count <= most; count *= 4) {
        bench.read(bench.write(bench::manyShapes(count),
                               R"({"position": [2.2, 1.6, 3.2], "target": [0, 0, 0], "fieldOfView": 40})"));
        std::printf("\n## %d shapes in one smooth union\n\n| way | evaluations | shapes asked | ms | first frame, s | "
                    "missed | extra |\n|---|---|---|---|---|---|---|\n",
                    count);
        for (const Way& way : all) {
            if (count > way.most || (nearAlone && way.way != SceneEvaluation::near)) continue;
            const Measured m = bench.measure(way.way, way.source);
            row(way.name, m);
            if (way.way == SceneEvaluation::near) last = m.milliseconds, lastShapes = m.shapes;
        }
        const auto vocabulary = scenes::ListVocabulary::of(*bench.shown().program);
        const auto words = bench.shown().program->words(bench.shown().scene->numbersAt(0));
        const auto near =
            scenes::nearScene(*bench.shown().program, words, vocabulary, scenes::cellsAcross(std::size_t(count)));
        std::printf("\nFinding what is near takes %.0f ms and %.1f MiB: %zu cells, %zu with shapes, %.2f each, %zu at "
                    "most; %zu lists.\n",
                    1e3 * near->seconds, double(near->bytes()) / 1048576.0, near->cells.cells.size(),
                    near->cells.withSteps, near->cells.meanShapes, near->cells.mostShapes, near->cells.lists);
        if (count == 16) at16 = last, shapesAt16 = lastShapes;
    }
    if (at16 > 0)
        std::printf("\n%d shapes cost %.1f times the milliseconds of 16, and %.1f times the shapes (goal: 4).\n", most,
                    last / at16, lastShapes / shapesAt16);
}

void edits(Bench& bench)
{
    std::printf(
        "\n## From a saved file to the picture\n\nA shape is added to the file: the tree is another one. Seconds "
        "from then on.\n\n| shapes | read | what is near | the picture by what is near | the picture by a program "
        "of its own |\n|---|---|---|---|---|\n");
    for (const int count : {16, 64, 256}) {
        const char* camera = R"({"position": [2.2, 1.6, 3.2], "target": [0, 0, 0], "fieldOfView": 40})";
        bench.read(bench.write(bench::manyShapes(count), camera));
        bench.values().set(table.evaluation, SceneEvaluation::near);
        bench.draw(bench.plan(false));
        const std::string more = bench::manyShapes(count + 1);
        const double begun = now();
        bench.read(bench.write(more, camera));
        const double read = now();
        const render::FramePlan plan = bench.plan(false);
        const double planned = now();
        bench.draw(plan);
        const double drawn = now();
        double own = 0;
        if (count <= 64) {
            bench.values().set(table.evaluation, SceneEvaluation::shapes);
            const double ownBegun = now();
            bench.draw(bench.plan(false));
            own = now() - ownBegun + read - begun;
        }
        std::printf(own > 0 ? "| %d | %.3f | %.3f | %.3f | %.2f |\n" : "| %d | %.3f | %.3f | %.3f | not built |\n",
                    count, read - begun, planned - read, drawn - begun, own);
        std::fflush(stdout);
    }
}

void compositions(Bench& bench)
{
    bench.size /= 2;
    std::printf(
        "\n## The scenes that come with the program, in our look, at half the size\n\n| scene | evaluations, every "
        "shape | ms | "
        "evaluations, what is near | shapes asked | ms | missed | evaluations, the source's march | ms | missed "
        "|\n|---|---|---|---|---|---|---|---|---|---|\n");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator("assets/scenes"))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        bench.read(std::filesystem::absolute(file));
        const Measured every = bench.measure(SceneEvaluation::shapes);
        const Measured near = bench.measure(SceneEvaluation::near);
        const Measured source = bench.measure(SceneEvaluation::shapes, true);
        std::printf("| %s | %.2f | %.0f | %.2f | %.1f | %.0f | %d | %.2f | %.0f | %d |\n", file.stem().c_str(),
                    every.evaluations, every.milliseconds, near.evaluations, near.shapes, near.milliseconds,
                    near.missed, source.evaluations, source.milliseconds, source.missed);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const std::filesystem::path cache =
        std::filesystem::temp_directory_path() / ("scene_speed_programs" + std::to_string(getpid()));
    setenv("XDG_CACHE_HOME", cache.c_str(), 1);  // Every program is built here.
    int most = 1024;
    std::string only;
    Bench bench;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (!std::strcmp(argv[i], "--size")) std::sscanf(argv[i + 1], "%dx%d", &bench.size.x, &bench.size.y);
        if (!std::strcmp(argv[i], "--most")) most = std::atoi(argv[i + 1]);
        if (!std::strcmp(argv[i], "--only")) only = argv[i + 1];
    }
    std::printf(
        "%d x %d pixels, llvmpipe or what the head says. Evaluations and shapes are means over the frame; ms: the "
        "exhibit's pass, median of %d, or one where it takes seconds.\nMissed and extra: of one pixel in 64, against a "
        "trace at float64.\n",
        bench.size.x, bench.size.y, bench.runs);
    if (only.empty() || only == "ways" || only == "near") ways(bench, most, only == "near");
    if (only.empty() || only == "edits") edits(bench);
    if (only.empty() || only == "scenes") compositions(bench);
    std::error_code ignored;
    std::filesystem::remove_all(cache, ignored);
    return 0;
}
