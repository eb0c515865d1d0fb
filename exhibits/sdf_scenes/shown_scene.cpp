#include "exhibits/sdf_scenes/shown_scene.h"

#include "exhibits/sdf_scenes/near_scene.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/failure.h"
#include "render/hash.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::scenes {
namespace {

/// Numbers of a material: their values, and tests of whether they may exceed a limit at any time.
struct MaterialNumbers {
    const Scene& scene;
    const Record& record;

    [[nodiscard]] const Number& number(std::size_t i) const { return scene.numbers[record.numbers + i]; }
    [[nodiscard]] bool mayBeAbove(std::size_t i, double limit) const
    {
        return number(i).expression != none || number(i).value > limit;
    }
    [[nodiscard]] bool mayBeBelow(std::size_t i, double limit) const
    {
        return number(i).expression != none || number(i).value < limit;
    }
};

/// Roughness above which reflections are looked up in a blurred environment instead of traced: see
/// shaders/sdf_scenes/our_look.glsl.
constexpr double roughestMirror = 0.35;

void addMaterial(const MaterialNumbers& m, SceneContents& contents)
{
    // Order of the numbers: color, then for Phong ambient, diffuse, specular, shininess, mirror.
    if (m.record.kind->name == "phong") {
        const bool mirror = m.mayBeAbove(7, 0);
        contents.mirrors = contents.mirrors || mirror;
        contents.mirrorsInSource = contents.mirrorsInSource || mirror;
        contents.litInSource = contents.litInSource || m.mayBeAbove(4, 0) || m.mayBeAbove(5, 0);
        return;
    }
    contents.litInSource = true;
    // Order of the numbers: color, metalness, roughness, reflectance, refractive index, transmission, emission.
    contents.mirrors = contents.mirrors || m.mayBeBelow(4, roughestMirror);
    contents.mirrorsInSource = contents.mirrorsInSource || (m.mayBeAbove(3, 0) && m.mayBeBelow(4, 0.3));
    contents.glass = contents.glass || m.mayBeAbove(7, 0);
    contents.glows = contents.glows || m.mayBeAbove(8, 0);
}

SceneContents contentsOf(const Scene& scene, const SceneProgram& program)
{
    SceneContents contents;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i)
        if (program.materialWord(i) != none) addMaterial({scene, scene.materials[i]}, contents);
    contents.lamps = std::any_of(scene.lights.begin(), scene.lights.end(),
                                 [](const Record& light) { return light.kind->name == "area"; });
    contents.moves = scene.animated();
    return contents;
}

glm::dvec3 vectorAt(const std::vector<double>& numbers, std::size_t i)
{
    return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

/// Returns the scene with a camera that shows all of its shapes, if its file has none. Distance and target are rounded
/// to steps, so that moving a shape slightly does not change the view.
std::shared_ptr<const Scene> framed(const std::shared_ptr<const Scene>& scene)
{
    if (scene->hasCamera) return scene;
    const SceneProgram program(scene);
    if (program.nodes().empty()) return scene;
    const std::vector<double> numbers = scene->numbersAt(0);
    const SceneWords words = program.words(numbers);
    const SceneWithoutPlanes rest(program, words, NearScene::mostPlanes);
    if (rest.steps.empty() || !std::isfinite(glm::length(rest.box.high - rest.box.low))) return scene;
    const render::Box box = occupiedBox(program, words, rest.steps, rest.box);
    const double radius = glm::length(box.halfSize());
    if (box.empty() || !(radius > 0)) return scene;
    const double reach = std::exp2(std::ceil(4 * std::log2(radius)) / 4);
    const double step = reach / 8;
    const glm::dvec3 target = glm::round(box.center() / step) * step;
    const SceneCamera camera = sceneCamera(*scene, numbers, 0);
    const glm::dvec3 away = glm::normalize(camera.eye - camera.target);
    const glm::dvec3 eye = target + away * ((reach + 0.5 * std::sqrt(3.0) * step) / std::sin(0.5 * camera.fovY));
    auto made = std::make_shared<Scene>(*scene);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<glm::length_t>(i);
        made->numbers[scene->camera.numbers + i].value = eye[axis];
        made->numbers[scene->camera.numbers + 3 + i].value = target[axis];
    }
    return made;
}

/// Returns the largest distance from the camera to the opening for which the pane cuts no surface: the corners are no
/// farther away than the nearest surface.
double openingOf(const Scene& scene, const std::shared_ptr<const SceneProgram>& program)
{
    const std::vector<double> numbers = scene.numbersAt(0);
    const SceneCamera camera = sceneCamera(scene, numbers, 0);
    const double clear = SceneField(program, program->words(numbers)).distance(camera.eye);
    const Portal portal;
    const double corner = std::tan(0.5 * camera.fovY) * glm::length(portal.halfSize) / portal.halfSize.y;
    const double toTarget = glm::length(camera.target - camera.eye);
    return std::clamp(clear / std::hypot(1.0, corner), 0.02 * toTarget, 0.7 * toTarget);
}

}  // namespace

std::shared_ptr<const ShownScene> shownScene(std::shared_ptr<const Scene> scene, std::filesystem::path path)
{
    auto shown = std::make_shared<ShownScene>();
    shown->scene = framed(scene);
    shown->program = std::make_shared<const SceneProgram>(shown->scene);
    shown->sources = generatedSources(sceneGlsl(*shown->program, {"sdf_scenes/stage_block.glsl", "SceneStage stage"}));
    shown->contents = contentsOf(*shown->scene, *shown->program);
    shown->toOpening = openingOf(*shown->scene, shown->program);
    shown->path = std::move(path);
    render::Hash pictures;
    for (const std::filesystem::path& file : environmentFiles(*shown->scene, shown->path))
        render::addTo(pictures.add(file.string()), render::fileState(file));
    shown->pictures = pictures.value();
    return shown;
}

std::shared_ptr<const ShownScene> readShownScene(const std::filesystem::path& path)
{
    ReadScene read = readSceneFile(path);
    if (!read.scene) throw Failure(Blame::file, read.findings.front().text());
    return shownScene(std::move(read.scene), path);
}

SceneCamera sceneCamera(const Scene& scene, const std::vector<double>& numbers, double orbit)
{
    const std::size_t at = scene.camera.numbers;
    SceneCamera camera{vectorAt(numbers, at), vectorAt(numbers, at + 3), vectorAt(numbers, at + 6), numbers[at + 9]};
    const double far = glm::length(camera.eye - camera.target);
    if (!(far > 1e-6)) camera.eye = camera.target + glm::dvec3(0, 0, 1);
    const double upright = glm::length(camera.up);
    camera.up = upright > 0 ? camera.up / upright : glm::dvec3(0, 1, 0);
    const glm::dvec3 away = glm::normalize(camera.eye - camera.target);
    if (glm::length(glm::cross(away, camera.up)) < 1e-6)
        camera.up = std::abs(away.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1), orbit, {0, 1, 0}));
    camera.eye = camera.target + turn * (camera.eye - camera.target);
    camera.up = turn * camera.up;
    return camera;
}

namespace {

/// Returns the distance from the eye to the opening in meters of the hall; limited so that the wall is not in the way.
double eyeToOpening(double fovY)
{
    const Portal portal;
    return std::max(portal.halfSize.y / std::tan(0.5 * fovY), portal.behind + 0.35);
}

}  // namespace

Portal scenePortal(const SceneCamera& camera, double toOpening)
{
    Portal portal;
    const double toEye = eyeToOpening(camera.fovY);
    const glm::dvec3 back = glm::normalize(camera.eye - camera.target);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
    const double scale = toOpening / toEye;
    glm::dmat4 work(1);
    work[0] = glm::dvec4(scale * right, 0);
    work[1] = glm::dvec4(scale * glm::cross(back, right), 0);
    work[2] = glm::dvec4(scale * back, 0);
    work[3] = glm::dvec4(camera.eye - scale * (toEye - portal.behind) * back, 1);
    portal.workFromExhibit = work;
    return portal;
}

render::Camera sceneView(double fovY)
{
    const Portal portal;
    const double toEye = eyeToOpening(fovY);
    const double fits = 2 * std::atan(1.12 * portal.halfSize.y / toEye);
    return {{0, 0, toEye - portal.behind}, {0, 0, -portal.behind}, fits};
}

}  // namespace vitrine::scenes
