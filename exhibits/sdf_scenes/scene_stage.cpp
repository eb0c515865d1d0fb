// What stands around the shapes, from the scene's numbers.

#include "exhibits/sdf_scenes/shown_scene.h"

#include <algorithm>
#include <cmath>

namespace vitrine::scenes {
namespace {

constexpr double farthestInSource = 100;
constexpr double farthestOfOurs = 300;
constexpr double timesAsFar = 60;  ///< As what a scene without a camera is seen from: as far as 300 m from 5 m.

glm::dvec3 vectorOf(const double* v)
{
    return {v[0], v[1], v[2]};
}

/// Edges of a rectangle that faces this way.
void setEdges(SceneStage& stage, std::size_t i, const glm::dvec3& facing, double width, double height)
{
    const glm::dvec3 up = std::abs(facing.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 across = glm::normalize(glm::cross(up, facing));
    stage.lightAcross[i] = glm::vec4(glm::vec3(0.5 * width * across), 0);
    stage.lightAlong[i] = glm::vec4(glm::vec3(0.5 * height * glm::cross(facing, across)), 0);
}

/// `target`: where the camera looks, at which a point of light is as bright as its color says.
void setLight(const Record& light, const double* v, const glm::dvec3& target, bool asInSource, std::size_t i,
              SceneStage& stage)
{
    const auto place = [&](const glm::dvec3& p, int kind) { return glm::vec4(glm::vec3(p), static_cast<float>(kind)); };
    const auto direction = [](const double* d) {
        const double length = glm::length(vectorOf(d));
        return length > 0 ? vectorOf(d) / length : glm::dvec3(0, 1, 0);
    };
    if (light.kind->name == "point") {
        const glm::dvec3 away = vectorOf(v) - target;
        const double squared = asInSource ? 1 : std::max(glm::dot(away, away), 1e-6);
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

}  // namespace

void setBox(SceneStage& stage, const render::Box& box)
{
    stage.boxLow = glm::vec3(glm::clamp(box.low - 1e-3, glm::dvec3(-1e6), glm::dvec3(1e6)));
    stage.boxHigh = glm::vec3(glm::clamp(box.high + 1e-3, glm::dvec3(-1e6), glm::dvec3(1e6)));
}

SceneStage sceneStage(const ShownScene& shown, const SceneWords& words, const std::vector<double>& numbers)
{
    const Scene& scene = *shown.scene;
    const double* look = &numbers[scene.look.numbers];
    const bool asInSource = look[0] > 0.5;
    const glm::dvec3 target = vectorOf(&numbers[scene.camera.numbers + 3]);
    SceneStage stage;
    setBox(stage, words.extents.empty() ? render::Box{glm::dvec3(0), glm::dvec3(0)} : words.extents.front().box);
    const double toTarget = glm::length(vectorOf(&numbers[scene.camera.numbers]) - target);
    const double farthest = asInSource ? farthestInSource : farthestOfOurs;
    stage.farthest = static_cast<float>(scene.hasCamera ? farthest : std::max(farthest, timesAsFar * toTarget));
    stage.largestNormalStep = static_cast<float>(scene.hasCamera ? 1e3 : 0.001 * toTarget);
    stage.bounces = static_cast<int>(look[1]);
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
        setLight(scene.lights[i], &numbers[scene.lights[i].numbers], target, asInSource, i, stage);
    return stage;
}

}  // namespace vitrine::scenes
