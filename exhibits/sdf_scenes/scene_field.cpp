#include "exhibits/sdf_scenes/scene_field.h"

#include "exhibits/sdf_scenes/scene_walk.h"

namespace vitrine::scenes {

SceneField::SceneField(std::shared_ptr<const SceneProgram> program, SceneConstants words)
    : program_(std::move(program)), words_(std::move(words))
{
}

SceneField::SceneField(std::shared_ptr<const Scene> scene, double time, const std::vector<double>& parameters)
    : program_(std::make_shared<SceneProgram>(scene)), words_(program_->words(scene->numbersAt(time, parameters)))
{
}

double SceneField::distance(const glm::dvec3& p) const
{
    if (program_->nodes().empty()) return nothingNear;
    SceneWalk walk(*program_, words_.words, false);
    walk.run(program_->steps(), p);
    return walk.state(0).distance;
}

SceneSample SceneField::sample(const glm::dvec3& p) const
{
    if (program_->nodes().empty()) return {.distance = nothingNear};
    SceneWalk walk(*program_, words_.words, true);
    walk.run(program_->steps(), p);
    return {walk.state(0).distance, walk.surface(0).node, walk.surface(0).material};
}

std::vector<NodeSample> SceneField::nodes(const glm::dvec3& p) const
{
    SceneWalk walk(*program_, words_.words, false);
    walk.run(program_->steps(), p);
    std::vector<NodeSample> samples;
    for (const SceneWalk::State& state : walk.states()) samples.push_back({state.distance, state.lipschitz});
    return samples;
}

render::Box SceneField::box() const
{
    if (program_->nodes().empty()) return {};
    return words_.extents.front().box;
}

}  // namespace vitrine::scenes
