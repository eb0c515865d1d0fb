// What a picture of a scene costs by each way to ask its field, beside the source's own way, and how long a change
// takes to be seen. Prints Markdown.
//   bench_scene_speed [--size 640x360] [--most 1024] [--only ways|near|edits|scenes]

#include "exhibits/framework/tree.h"
#include "exhibits/sdf_scenes/near_scene.h"
#include "tests/bench/many_shapes.h"
#include "tests/bench/scene_bench.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>

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

/// Seconds until the next picture is drawn, by this way to ask the field, its program built if need be.
double untilDrawn(SceneBench& stage, SceneEvaluation way)
{
    stage.values().set(SceneBench::table().evaluation, way);
    const double begun = bench::wallNow();
    stage.drawNow();
    return bench::wallNow() - begun;
}

struct EditTimes {
    double toPicture = 0, toOwnProgram = 0;
};

/// From when `edit` begins; to a program of its own only where that takes no minutes.
EditTimes timesOf(SceneBench& stage, bool own, SceneEvaluation ownWay, const std::function<void()>& edit)
{
    EditTimes times;
    const double begun = bench::wallNow();
    edit();
    const double edited = bench::wallNow() - begun;
    times.toPicture = edited + untilDrawn(stage, SceneEvaluation::near);
    if (own) times.toOwnProgram = edited + untilDrawn(stage, ownWay);
    return times;
}

void editRow(int count, const char* what, const EditTimes& times)
{
    std::printf(times.toOwnProgram > 0 ? "| %d | %s | %.3f | %.2f |\n" : "| %d | %s | %.3f | not built |\n", count,
                what, times.toPicture, times.toOwnProgram);
    std::fflush(stdout);
}

void edits(SceneBench& stage)
{
    std::printf(
        "\n## From an edit to the picture\n\nSeconds from when the edit begins; the picture is drawn by what is near, "
        "whose program is there. A program of its own has its numbers folded where one was edited, and beside it "
        "where the tree is another one.\n\n| shapes | edit | to the picture | to a picture by a program of its own "
        "|\n|---|---|---|---|\n");
    const char* const camera = R"({"position": [2.2, 1.6, 3.2], "target": [0, 0, 0], "fieldOfView": 40})";
    const auto& tree = *capability<HasTree>(stage.museum.subject(stage.exhibit));
    render::AssetStore assets = stage.museum.assets();
    for (const int count : {16, 64, 256}) {
        const bool own = count <= 64;
        stage.read(stage.write(bench::manyShapes(count), camera));
        untilDrawn(stage, SceneEvaluation::near);
        editRow(count, "a number", timesOf(stage, own, SceneEvaluation::folded, [&] {
                    const TreeRows rows = tree.rowsOf(stage.values(), "root.children[0]").value();
                    const std::size_t radius = rows.values.table().find("radius").value();
                    const double now = std::get<double>(rows.values.row(radius));
                    stage.values() = tree.withRow(stage.values(), "root.children[0]", radius, 1.1 * now, assets);
                }));
        editRow(count, "a shape added", timesOf(stage, own, SceneEvaluation::shapes, [&] {
                    const TreeEdit add{.what = TreeEdit::What::add, .node = "root", .word = "sphere"};
                    stage.values() = tree.edited(stage.values(), add, assets).values;
                }));
        stage.values().set(SceneBench::table().document, std::string());
        const std::string more = bench::manyShapes(count + 1);
        editRow(count, "a file saved with one more",
                timesOf(stage, own, SceneEvaluation::shapes, [&] { stage.read(stage.write(more, camera)); }));
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
