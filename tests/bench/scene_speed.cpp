// What a picture of a scene costs by each way to ask its field, beside the source's own way, and how long a change
// takes to be seen. Prints Markdown.
//   bench_scene_speed [--size 640x360] [--most 1024] [--only ways|near|edits|scenes]

#include "exhibits/sdf_scenes/near_scene.h"
#include "tests/bench/many_shapes.h"
#include "tests/bench/scene_bench.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

using namespace vitrine;
using bench::SceneBench;
using bench::SceneCosts;

void row(const char* name, const SceneCosts& m)
{
    std::printf("| %s | %.2f | %.1f | %.0f | %.1f | %d | %d |\n", name, m.evaluations, m.shapes, m.milliseconds,
                m.firstSeconds, m.missed, m.extra);
    std::fflush(stdout);
}

/// `nearAlone`: without the others, which take minutes.
void ways(SceneBench& stage, int most, bool nearAlone)
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
    stage.values().set(SceneBench::table().shadowMethod, SceneShadow::none);
    stage.values().set(SceneBench::table().occlusionMethod, SceneOcclusion::none);
    double at16 = 0, shapesAt16 = 0, last = 0, lastShapes = 0;
    for (int count = 4; count <= most; count *= 4) {
        stage.read(stage.write(bench::manyShapes(count),
                               R"({"position": [2.2, 1.6, 3.2], "target": [0, 0, 0], "fieldOfView": 40})"));
        std::printf("\n## %d shapes in one smooth union\n\n| way | evaluations | shapes asked | ms | first frame, s | "
                    "missed | extra |\n|---|---|---|---|---|---|---|\n",
                    count);
        for (const Way& way : all) {
            if (count > way.most || (nearAlone && way.way != SceneEvaluation::near)) continue;
            const SceneCosts m = stage.measure(way.way, way.source);
            row(way.name, m);
            if (way.way == SceneEvaluation::near) last = m.milliseconds, lastShapes = m.shapes;
        }
        const auto vocabulary = scenes::ListVocabulary::of(*stage.shown().program);
        const auto words = stage.shown().program->words(stage.shown().scene->numbersAt(0));
        const std::clock_t begun = std::clock();
        const auto near =
            scenes::nearScene(*stage.shown().program, words, vocabulary, scenes::cellsAcross(std::size_t(count)));
        std::printf("\nFinding what is near takes %.0f ms (%.0f of processor time) and %.1f MiB: %zu cells, %zu with "
                    "shapes, %.2f each, %zu at "
                    "most; %zu lists; %.2f million evaluations of shapes.\n",
                    1e3 * near->seconds, 1e3 * double(std::clock() - begun) / CLOCKS_PER_SEC,
                    double(near->bytes()) / 1048576.0, near->cells.cells.size(), near->cells.withSteps,
                    near->cells.meanShapes, near->cells.mostShapes, near->cells.lists,
                    1e-6 * double(near->cells.evaluations));
        if (count == 16) at16 = last, shapesAt16 = lastShapes;
    }
    if (at16 > 0)
        std::printf("\n%d shapes cost %.1f times the milliseconds of 16, and %.1f times the shapes (goal: 4).\n", most,
                    last / at16, lastShapes / shapesAt16);
}

void edits(SceneBench& stage)
{
    std::printf(
        "\n## From a saved file to the picture\n\nA shape is added to the file: the tree is another one. Seconds "
        "from then on.\n\n| shapes | read | what is near | the picture by what is near | the picture by a program "
        "of its own |\n|---|---|---|---|---|\n");
    for (const int count : {16, 64, 256}) {
        const char* camera = R"({"position": [2.2, 1.6, 3.2], "target": [0, 0, 0], "fieldOfView": 40})";
        stage.read(stage.write(bench::manyShapes(count), camera));
        stage.values().set(SceneBench::table().evaluation, SceneEvaluation::near);
        stage.drawNow();
        const std::string more = bench::manyShapes(count + 1);
        const double begun = bench::wallNow();
        stage.read(stage.write(more, camera));
        const double read = bench::wallNow();
        const render::FramePlan plan = stage.planNow();
        const double planned = bench::wallNow();
        stage.draw(plan);
        const double drawn = bench::wallNow();
        double own = 0;
        if (count <= 64) {
            stage.values().set(SceneBench::table().evaluation, SceneEvaluation::shapes);
            const double ownBegun = bench::wallNow();
            stage.drawNow();
            own = bench::wallNow() - ownBegun + read - begun;
        }
        std::printf(own > 0 ? "| %d | %.3f | %.3f | %.3f | %.2f |\n" : "| %d | %.3f | %.3f | %.3f | not built |\n",
                    count, read - begun, planned - read, drawn - begun, own);
        std::fflush(stdout);
    }
}

void compositions(SceneBench& stage)
{
    stage.size /= 2;
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
        stage.read(std::filesystem::absolute(file));
        const SceneCosts every = stage.measure(SceneEvaluation::shapes);
        const SceneCosts near = stage.measure(SceneEvaluation::near);
        const SceneCosts source = stage.measure(SceneEvaluation::shapes, true);
        std::printf("| %s | %.2f | %.0f | %.2f | %.1f | %.0f | %d | %.2f | %.0f | %d |\n", file.stem().c_str(),
                    every.evaluations, every.milliseconds, near.evaluations, near.shapes, near.milliseconds,
                    near.missed, source.evaluations, source.milliseconds, source.missed);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const bench::FreshPrograms fresh;
    int most = 1024;
    std::string only;
    SceneBench stage;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (!std::strcmp(argv[i], "--size")) std::sscanf(argv[i + 1], "%dx%d", &stage.size.x, &stage.size.y);
        if (!std::strcmp(argv[i], "--most")) most = std::atoi(argv[i + 1]);
        if (!std::strcmp(argv[i], "--only")) only = argv[i + 1];
    }
    std::printf(
        "%d x %d pixels, llvmpipe or what the head says. Evaluations and shapes are means over the frame; ms: the "
        "exhibit's pass, median of %d, or one where it takes seconds.\nMissed and extra: of one pixel in 64, against a "
        "trace at float64.\n",
        stage.size.x, stage.size.y, stage.runs);
    if (only.empty() || only == "ways" || only == "near") ways(stage, most, only == "near");
    if (only.empty() || only == "edits") edits(stage);
    if (only.empty() || only == "scenes") compositions(stage);
    return 0;
}
