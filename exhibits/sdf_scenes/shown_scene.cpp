#include "exhibits/sdf_scenes/shown_scene.h"

#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/scene_grid.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/failure.h"
#include "render/hash.h"
#include "render/image/image_io.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vitrine::scenes {
namespace {

/// Numbers of a material: their values, and tests of whether they may exceed a limit at any time.
struct MaterialNumbers {
    const Scene& scene;
    const Record& record;

    [[nodiscard]] const Number& number(std::size_t i) const { return scene.numbers[record.numbers + i]; }
    [[nodiscard]] bool mayBeAbove(std::size_t i, double limit) const
    {
        return number(i).expression != noIndex || number(i).value > limit;
    }
    [[nodiscard]] bool mayBeBelow(std::size_t i, double limit) const
    {
        return number(i).expression != noIndex || number(i).value < limit;
    }
};

/// Roughness above which reflections are looked up in a blurred environment instead of traced: see
/// shaders/sdf_scenes/pbr_shading.glsl.
constexpr double roughestMirror = 0.35;

void addMaterial(const MaterialNumbers& m, SceneContents& contents)
{
    // Order of the numbers: color, then for Phong ambient, diffuse, specular, shininess, mirror.
    if (m.record.kind->name == "phong") {
        const bool mirror = m.mayBeAbove(7, 0);
        contents.mirrors = contents.mirrors || mirror;
        contents.mirrorsInReference = contents.mirrorsInReference || mirror;
        contents.litInReference = contents.litInReference || m.mayBeAbove(4, 0) || m.mayBeAbove(5, 0);
        return;
    }
    contents.litInReference = true;
    // Order of the numbers: color, metalness, roughness, reflectance, refractive index, transmission, emission.
    contents.mirrors = contents.mirrors || m.mayBeBelow(4, roughestMirror);
    contents.mirrorsInReference = contents.mirrorsInReference || (m.mayBeAbove(3, 0) && m.mayBeBelow(4, 0.3));
    contents.glass = contents.glass || m.mayBeAbove(7, 0);
    contents.glows = contents.glows || m.mayBeAbove(8, 0);
}

SceneContents contentsOf(const Scene& scene, const SceneProgram& program)
{
    SceneContents contents;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i)
        if (program.materialWord(i) != noIndex) addMaterial({scene, scene.materials[i]}, contents);
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
    const SceneConstants words = program.words(numbers);
    const SceneWithoutPlanes rest(program, words, SceneGrid::mostPlanes);
    if (rest.steps.empty() || !std::isfinite(glm::length(rest.box.high - rest.box.low))) return scene;
    const render::Box box = occupiedBox(program, words, rest.steps, rest.box).box;
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
    if (!read.scene) throw read.findings.front().failure();
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
    const double fits = 2 * std::atan(portal.halfSize.y / (openingInView * toEye));
    return {{0, 0, toEye - portal.behind}, {0, 0, -portal.behind}, fits};
}

namespace {

constexpr int widestPanorama = 4096;  ///< Largest width of a panorama that is made from the faces of a cube, in pixels.

/// Face of a cube that a direction meets, and position in its picture: columns to the right, rows down, 0 to 1.
struct FacePlace {
    std::size_t face;
    double column, row;
};

/// Returns the face that a direction meets. Faces: right, left, top, bottom, front, back, seen from within; front: -z.
FacePlace facePlace(const glm::dvec3& d)
{
    const glm::dvec3 size = glm::abs(d);
    const auto at = [](std::size_t face, double right, double up, double ahead) {
        return FacePlace{face, 0.5 + 0.5 * right / ahead, 0.5 - 0.5 * up / ahead};
    };
    if (size.x >= size.y && size.x >= size.z) return d.x > 0 ? at(0, d.z, d.y, d.x) : at(1, -d.z, d.y, -d.x);
    if (size.y >= size.z) return d.y > 0 ? at(2, d.x, d.z, d.y) : at(3, d.x, -d.z, -d.y);
    return d.z < 0 ? at(4, d.x, d.y, -d.z) : at(5, -d.x, d.y, d.z);
}

glm::dvec3 colorAt(const render::Image& face, double column, double row)
{
    const auto within = [](double x, int count) { return std::clamp(x * count - 0.5, 0.0, count - 1.0); };
    const double x = within(column, face.width), y = within(row, face.height);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, face.width - 1), y1 = std::min(y0 + 1, face.height - 1);
    glm::dvec3 color;
    for (int c = 0; c < 3; ++c) {
        const int channel = face.channels < 3 ? 0 : c;
        const auto mixed = [&](int line) {
            return std::lerp(static_cast<double>(face.at(x0, line, channel)),
                             static_cast<double>(face.at(x1, line, channel)), x - x0);
        };
        color[c] = std::lerp(mixed(y0), mixed(y1), y - y0);
    }
    return color;
}

std::shared_ptr<const render::Texture> panoramaOf(const std::array<render::Image, 6>& faces)
{
    auto made = std::make_shared<render::Texture>();
    made->name = "six faces";
    made->width = std::clamp(4 * faces[0].width, 4, widestPanorama);
    made->height = made->width / 2;
    made->channels = 3;
    made->floats.reserve(static_cast<std::size_t>(made->width) * static_cast<std::size_t>(made->height) * 3);
    for (int y = 0; y < made->height; ++y) {
        const double polar = (y + 0.5) / made->height * std::numbers::pi;
        for (int x = 0; x < made->width; ++x) {
            // This is the mapping with which shaders/lib/sky.glsl looks up panoramas.
            const double around = ((x + 0.5) / made->width - 0.5) * 2 * std::numbers::pi;
            const glm::dvec3 d(std::sin(polar) * std::sin(around), std::cos(polar),
                               -std::sin(polar) * std::cos(around));
            const FacePlace place = facePlace(d);
            const glm::dvec3 color = colorAt(faces[place.face], place.column, place.row);
            for (int c = 0; c < 3; ++c) made->floats.push_back(static_cast<float>(color[c]));
        }
    }
    return made;
}

}  // namespace

std::shared_ptr<const render::Texture> readEnvironment(const ShownScene& shown)
{
    const std::vector<std::filesystem::path> files = environmentFiles(*shown.scene, shown.path);
    if (files.size() == 1) return render::loadTexture(files[0], true, true);
    std::array<render::Image, 6> faces;
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = render::readColor(files[i]);
    return panoramaOf(faces);
}

std::vector<std::filesystem::path> environmentFiles(const Scene& scene, const std::filesystem::path& path)
{
    std::vector<std::filesystem::path> files;
    for (const std::string& file : scene.environment.files) files.push_back(path.parent_path() / file);
    return files;
}

namespace {

constexpr double farthestOfReference = 100;
constexpr double farthestOfPhysical = 300;
constexpr double timesAsFar =
    60;  ///< Far limit over the distance of the camera, for a scene without a camera: 300 m for 5 m.

glm::dvec3 vectorOf(const double* v)
{
    return {v[0], v[1], v[2]};
}

/// Sets the edges of a rectangle that faces this direction.
void setEdges(SceneStage& stage, std::size_t i, const glm::dvec3& facing, double width, double height)
{
    const glm::dvec3 up = std::abs(facing.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 across = glm::normalize(glm::cross(up, facing));
    stage.lightAcross[i] = glm::vec4(glm::vec3(0.5 * width * across), 0);
    stage.lightAlong[i] = glm::vec4(glm::vec3(0.5 * height * glm::cross(facing, across)), 0);
}

/// `target`: point that the camera looks at. A point light illuminates it as brightly as its color says.
void setLight(const Record& light, const double* v, const glm::dvec3& target, bool byReference, std::size_t i,
              SceneStage& stage)
{
    const auto place = [&](const glm::dvec3& p, int kind) { return glm::vec4(glm::vec3(p), static_cast<float>(kind)); };
    const auto direction = [](const double* d) {
        const double length = glm::length(vectorOf(d));
        return length > 0 ? vectorOf(d) / length : glm::dvec3(0, 1, 0);
    };
    if (light.kind->name == "point") {
        const glm::dvec3 away = vectorOf(v) - target;
        const double squared = byReference ? 1 : std::max(glm::dot(away, away), 1e-6);
        stage.lightPlace[i] = place(vectorOf(v), SCENE_POINT);
        stage.lightColor[i] = glm::vec4(glm::vec3(squared * vectorOf(v + 3)), 0);
    } else if (light.kind->name == "sun") {
        stage.lightPlace[i] = place(direction(v), SCENE_SUN);
        stage.lightColor[i] = glm::vec4(glm::vec3(vectorOf(v + 3)), static_cast<float>(std::tan(0.5 * v[6])));
    } else {
        stage.lightPlace[i] = place(vectorOf(v), SCENE_AREA);
        stage.lightColor[i] = glm::vec4(glm::vec3(vectorOf(v + 8)), 0);
        setEdges(stage, i, direction(v + 3), v[6], v[7]);
    }
}

/// Returns the number of loop iterations in one evaluation of the generated field.
int loopsOfField(const SceneProgram& program, const SceneConstants& words)
{
    constexpr std::size_t octavesAt = 2;  // Index in the numbers of both kinds of noise.
    double sum = 0;
    std::vector<double> within{1};
    for (const Step& step : program.steps()) {
        const ProgramNode& node = program.nodes()[step.node];
        const NodeKind& kind = program.kind(node);
        if (step.type == Step::Type::again) within.pop_back();
        if (step.type == Step::Type::enter && isNoise(kind))
            sum += within.back() * words.words[node.numbers + octavesAt];
        if (step.type != Step::Type::enter || kind.form != Form::repeater) continue;
        const double* times = &words.words[node.numbers + kind.numbers() + 3];
        within.push_back(within.back() * std::max(times[0] * times[1] * times[2], 1.0));
        sum += within.back();
    }
    return static_cast<int>(std::min(sum, 1e6));
}

}  // namespace

void setBox(SceneStage& stage, const render::Box& box)
{
    stage.boxLow = glm::vec3(glm::clamp(box.low - 1e-3, glm::dvec3(-1e6), glm::dvec3(1e6)));
    stage.boxHigh = glm::vec3(glm::clamp(box.high + 1e-3, glm::dvec3(-1e6), glm::dvec3(1e6)));
}

SceneStage sceneStage(const ShownScene& shown, const SceneConstants& words, const std::vector<double>& numbers)
{
    const Scene& scene = *shown.scene;
    const double* look = &numbers[scene.look.numbers];
    const bool byReference = look[0] > 0.5;
    const glm::dvec3 target = vectorOf(&numbers[scene.camera.numbers + 3]);
    SceneStage stage;
    setBox(stage, words.extents.empty() ? render::Box{glm::dvec3(0), glm::dvec3(0)} : words.extents.front().box);
    const double toTarget = glm::length(vectorOf(&numbers[scene.camera.numbers]) - target);
    const double farthest = byReference ? farthestOfReference : farthestOfPhysical;
    stage.farthest = static_cast<float>(scene.hasCamera ? farthest : std::max(farthest, timesAsFar * toTarget));
    stage.largestNormalStep = static_cast<float>(scene.hasCamera ? 1e3 : 0.001 * toTarget);
    stage.bounces = static_cast<int>(look[1]);
    stage.loops = loopsOfField(*shown.program, words);
    stage.softShadows = static_cast<float>(look[2]);
    stage.occlusion = static_cast<float>(look[3]);
    stage.ambient = glm::vec3(vectorOf(look + 4));
    stage.exposure = static_cast<float>(look[7]);

    const double* around = &numbers[scene.environment.numbers];
    if (scene.environment.kind->name == "sky") {
        stage.zenith = glm::vec3(vectorOf(around));
        stage.horizon = glm::vec3(vectorOf(around + 3));
        stage.ground = glm::vec3(vectorOf(around + 6));
        stage.environmentBrightness = 1;
    } else {
        stage.environmentRotation = static_cast<float>(around[0]);
        stage.environmentBrightness = static_cast<float>(around[1]);
    }
    const std::size_t lights = std::min<std::size_t>(scene.lights.size(), SCENE_MOST_LIGHTS);
    stage.lights = static_cast<int>(lights);
    for (std::size_t i = 0; i < lights; ++i)
        setLight(scene.lights[i], &numbers[scene.lights[i].numbers], target, byReference, i, stage);
    return stage;
}

}  // namespace vitrine::scenes
