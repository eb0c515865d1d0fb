#include "tests/bench/scene_bench.h"

#include "exhibits/sdf_scenes/scene_field.h"
#include "render/failure.h"
#include "tests/bench/source_march.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace vitrine::bench {

using glm::dvec3;

double wallNow()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

FreshPrograms::FreshPrograms()
    : folder_(std::filesystem::temp_directory_path() / ("bench_programs" + std::to_string(getpid())))
{
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
}

FreshPrograms::~FreshPrograms()
{
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

SceneBench::SceneBench()
    : BenchFrame("sdf_scenes", {640, 360}),
      folder_(std::filesystem::temp_directory_path() / ("scene_bench" + std::to_string(getpid())))
{
    std::filesystem::create_directories(folder_);
}

SceneBench::~SceneBench()
{
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

const SdfScenesTable& SceneBench::table()
{
    static const SdfScenesTable made;
    return made;
}

std::filesystem::path SceneBench::write(const std::string& root, const std::string& camera)
{
    const std::filesystem::path path = folder_ / "scene.json";
    std::ofstream(path) << "{\"format\": \"vitrine-scene\", \"version\": 1,\n\"camera\": " << camera
                        << ",\n\"lights\": [{\"kind\": \"sun\"}],\n\"root\": " << root << "}\n";
    return path;
}

void SceneBench::read(const std::filesystem::path& path)
{
    values().set(table().scene, path.string());
    TabledSceneState read = museum.readTables(sceneState);
    if (!read.unreadable.empty()) throw Failure(Blame::file, read.unreadable.front());
    sceneState = std::move(read.sceneState);
}

const scenes::ShownScene& SceneBench::shown()
{
    return *static_cast<const SdfScenesTable&>(values().table()).shown;
}

render::FramePlan SceneBench::planNow(bool source)
{
    render::FramePlan made = plan(alone());
    made.allParts = true;
    if (!source) return made;
    for (const render::Pass& pass : made.passes())
        // No frame of the program asks for this, so that no plan offers it.
        if (pass.name == "sdf_scenes/scene")
            useSourceMarch(const_cast<render::Pass&>(pass), *shown().program,
                           shown().program->words(shown().scene->numbersAt(0)));
    return made;
}

SceneCosts SceneBench::measure(SceneEvaluation way, bool source)
{
    SceneCosts costs;
    values().set(table().evaluation, way);
    renderer.timeSteps(true);
    const double begun = wallNow();
    drawNow(source);
    costs.firstSeconds = wallNow() - begun;
    std::vector<double> times;
    const int slow = costs.firstSeconds > 3 ? 1 : runs;
    for (int run = 0; run < slow; ++run) times.push_back(drawNow(source));
    renderer.timeSteps(false);
    std::sort(times.begin(), times.end());
    costs.milliseconds = times[times.size() / 2];
    costs.evaluations = meanEvaluations();
    compare(costs);
    if (source || costs.milliseconds >= 2000) return costs;
    values().set(table().heatMap, SceneHeatMap::shapes);
    drawNow();
    costs.shapes = meanEvaluations();
    values().set(table().heatMap, SceneHeatMap::none);
    return costs;
}

/// Pixels of the last picture that are hit, against a trace at float64, of one in 64.
void SceneBench::compare(SceneCosts& costs)
{
    const render::Image depth = renderer.read(depthImage);
    const FrameRequest frame = alone();
    const render::View view = render::makeView(frame.camera, frame.raster);
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
            ++costs.asked;
            costs.missed += hit && !shownHit;
            // Within half a pixel of a surface is on it.
            costs.extra += !hit && shownHit && closest > 0.002;
        }
}

}  // namespace vitrine::bench
