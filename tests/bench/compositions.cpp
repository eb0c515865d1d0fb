// The 15 compositions of the source: its own way to draw them beside ours, both in its look. Prints Markdown.
//   bench_compositions [--size 256x144] [--only NAME]

#include "tests/bench/scene_bench.h"

#include <cstdio>
#include <cstring>
#include <string_view>

namespace {

using namespace vitrine;
using bench::SceneBench;
using bench::SceneCosts;

constexpr const char* compositionNames[] = {"torus",
                                            "box",
                                            "primitives",
                                            "spheres_cylinders_capsules",
                                            "shading",
                                            "unions",
                                            "intersections",
                                            "subtractions",
                                            "ambient_occlusion",
                                            "environment_mapping_1",
                                            "environment_mapping_2",
                                            "noise",
                                            "fractal_noise",
                                            "waves",
                                            "clouds"};

/// What a plan does without, and why: "glass (nothing is made of glass)".
std::string leftOut(const render::FramePlan& plan)
{
    constexpr std::string_view own = "sdf_scenes/";
    std::string words;
    for (const render::CulledPass& pass : plan.skipped()) {
        if (!pass.name.starts_with(own)) continue;
        const std::string step = pass.name.substr(own.size());
        if (step == "cells" || step == "folding" || step == "shadow") continue;  // No part of its shader.
        words += (words.empty() ? "" : "; ") + step + " (" + pass.reason + ')';
    }
    return words.empty() ? "nothing" : words;
}

const char* wayOf(SceneBench& stage)
{
    const render::FramePlan plan = stage.planNow();
    const render::CulledPass* cells = plan.findSkipped("sdf_scenes/cells");
    return cells ? "every shape" : "what is near";
}

void row(SceneBench& stage, const char* name)
{
    const SceneCosts source = stage.measure(SceneEvaluation::shapes, true);
    const SceneCosts ours = stage.measure(SceneEvaluation::automatic);
    const char* way = wayOf(stage);
    const SceneCosts folded = stage.measure(SceneEvaluation::folded);
    stage.values().set(SceneBench::table().evaluation, SceneEvaluation::automatic);
    std::printf("| %s | %.1f | %.1f | %d | %.1f | %.1f | %d | %s | %.1f | %.1f | %.1f | %s |\n", name,
                source.evaluations, source.milliseconds, source.missed, ours.evaluations, ours.milliseconds,
                ours.missed, way, folded.milliseconds, source.evaluations / ours.evaluations,
                source.milliseconds / ours.milliseconds, leftOut(stage.planNow()).c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    const bench::FreshPrograms fresh;
    SceneBench stage;
    stage.size = {256, 144};
    std::string_view only;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (!std::strcmp(argv[i], "--size")) std::sscanf(argv[i + 1], "%dx%d", &stage.size.x, &stage.size.y);
        if (!std::strcmp(argv[i], "--only")) only = argv[i + 1];
    }
    stage.values().set(SceneBench::table().look, SceneLook::source);
    std::printf(
        "# The compositions of the source\n\n%d x %d pixels, in the source's look on both sides: its mirrors, "
        "shadows and rays of occlusion.\n\nIts way: every number from an array, a chain of ifs over all its kinds, "
        "255 steps, 1 mm. Evaluations are means of the frame's pixels; ms: the exhibit's pass, median of %d, or one "
        "where it takes seconds. Missed: of one pixel in 64, against a trace at float64. Folded: ours once its "
        "numbers rest.\n\n| scene | evaluations, its way | ms | missed | evaluations, ours | ms | missed | asked | ms, "
        "folded | evaluations, times | ms, times | left out |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        stage.size.x, stage.size.y, stage.runs);
    for (const char* name : compositionNames) {
        if (!only.empty() && only != name) continue;
        stage.read(std::filesystem::absolute(std::string("assets/scenes/") + name + ".json"));
        row(stage, name);
    }
    return 0;
}
