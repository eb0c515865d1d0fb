#include "exhibits/sdf_scenes/scene_walk.h"

#include "exhibits/sdf_scenes/scene_functions_cpu.h"

#include <algorithm>

namespace vitrine::scenes {

namespace {

glm::dvec3 wordsAt(const double* words, std::uint32_t word)
{
    return {words[word], words[word + 1], words[word + 2]};
}

glsl::SceneMaterial materialAt(const double* w)
{
    return glsl::sceneMaterial({w[0], w[1], w[2], w[3]}, {w[4], w[5], w[6], w[7]}, {w[8], w[9], w[10], w[11]},
                               {w[12], w[13], w[14], w[15]});
}

}  // namespace

SceneWalk::SceneWalk(const SceneProgram& program, const std::vector<double>& words, bool withMaterials)
    : program_(program), words_(words.data()), states_(program.nodes().size()),
      surfaces_(withMaterials ? states_.size() : 0)
{
    kinds_.reserve(states_.size());
    for (const ProgramNode& node : program.nodes()) kinds_.push_back(&program.kind(node));
}

void SceneWalk::run(std::span<const Step> steps, const glm::dvec3& p)
{
    for (std::size_t i = 0; i < steps.size();) i = advance(steps, i, p);
}

std::size_t SceneWalk::advance(std::span<const Step> steps, std::size_t i, const glm::dvec3& p)
{
    const Step& step = steps[i];
    const ProgramNode& node = program_.nodes()[step.node];
    State& state = states_[step.node];
    switch (step.type) {
    case Step::Type::enter: enter(step.node, node.parent == noIndex ? p : states_[node.parent].asked); break;
    case Step::Type::shape: shape(step.node); break;
    case Step::Type::first:
        state.distance = states_[step.child].distance;
        inherit(step.node, step.child);
        break;
    case Step::Type::combine: combine(step); break;
    case Step::Type::modify: modify(step); break;
    case Step::Type::again:
        if (again(step)) return step.back;
        break;
    case Step::Type::leave:
        if (node.scale != noIndex) state.distance = glsl::sdfScaled(state.distance, words_[node.scale + 3]);
        break;
    }
    return i + 1;
}

/// Transforms a point to a node's own space.
glm::dvec3 SceneWalk::into(const ProgramNode& node, glm::dvec3 p) const
{
    if (node.translate != noIndex) p -= wordsAt(words_, node.translate);
    if (node.rotate != noIndex)
        p = glsl::sceneTurned(p, wordsAt(words_, node.rotate), wordsAt(words_, node.rotate + 3),
                              wordsAt(words_, node.rotate + 6));
    if (node.scale != noIndex) p *= wordsAt(words_, node.scale);
    return p;
}

double SceneWalk::operand(std::uint32_t index, const glm::dvec3& p)
{
    const ProgramNode& node = program_.nodes()[index];
    const glm::dvec3 own = into(node, node.parent == noIndex ? p : states_[node.parent].asked);
    ++primitiveEvaluations_;
    double distance = kinds_[index]->distance.cpu(own, words_ + node.numbers);
    if (node.scale != noIndex) distance = glsl::sdfScaled(distance, words_[node.scale + 3]);
    states_[index].distance = distance;
    return distance;
}

void SceneWalk::enter(std::uint32_t index, const glm::dvec3& outside)
{
    const ProgramNode& node = program_.nodes()[index];
    const NodeKind& kind = *kinds_[index];
    State& state = states_[index];
    const glm::dvec3 p = into(node, outside);
    const double* v = words_ + node.numbers;
    state.own = p;
    state.copy = 0;
    state.asked = kind.place ? kind.place.cpu(p, v) : kind.copy ? kind.copy.cpu(p, 0, v) : p;
    state.lipschitz = kind.lipschitz ? kind.lipschitz(p, v) : 1;
    if (kind.form == Form::repeater) state.distance = nothingNear;
}

void SceneWalk::shape(std::uint32_t index)
{
    const ProgramNode& node = program_.nodes()[index];
    State& state = states_[index];
    ++primitiveEvaluations_;
    state.distance = kinds_[index]->distance.cpu(state.own, words_ + node.numbers);
    if (surfaces_.empty()) return;
    surfaces_[index].node = node.node;
    std::copy_n(words_ + program_.materialWord(node.material), wordsOfMaterial, surfaces_[index].material.begin());
}

void SceneWalk::inherit(std::uint32_t node, std::uint32_t child)
{
    if (!surfaces_.empty()) surfaces_[node] = surfaces_[child];
}

void SceneWalk::combine(const Step& step)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = *kinds_[step.node];
    const double* v = words_ + node.numbers;
    const double a = states_[step.node].distance;
    const double b = states_[step.child].distance;
    states_[step.node].distance = kind.combine.cpu(a, b, v);
    if (surfaces_.empty()) return;
    WalkSurface& own = surfaces_[step.node];
    const double share = kind.share.cpu(a, b, v);
    const glsl::SceneMaterial m =
        glsl::sceneBlend(materialAt(own.material.data()), materialAt(surfaces_[step.child].material.data()), share);
    own.material = {m.color.x, m.color.y,   m.color.z,   m.ambient,     m.diffuse,         m.specular,     m.shininess,
                    m.mirror,  m.metalness, m.roughness, m.reflectance, m.refractiveIndex, m.transmission, m.emission};
    if (share > 0.5) own.node = surfaces_[step.child].node;
}

void SceneWalk::modify(const Step& step)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = *kinds_[step.node];
    const double d = states_[step.child].distance;
    State& state = states_[step.node];
    state.distance = kind.after ? kind.after.cpu(d, state.own, words_ + node.numbers) : d;
    inherit(step.node, step.child);
}

/// Returns whether another copy must be evaluated.
bool SceneWalk::again(const Step& step)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = *kinds_[step.node];
    const double* v = words_ + node.numbers;
    const double* asked = v + kind.numbers();
    State& state = states_[step.node];
    const double d = glsl::sceneCapped(states_[step.child].distance, state.asked, asked[6],
                                       {asked[7], asked[8], asked[9]}, {asked[10], asked[11], asked[12]});
    if (d < state.distance || state.copy == 0) inherit(step.node, step.child);
    state.distance = std::min(state.distance, d);
    if (++state.copy >= static_cast<int>(asked[3]) * static_cast<int>(asked[4]) * static_cast<int>(asked[5])) {
        state.distance = glsl::sceneBeyond(state.distance, state.own, asked[6], {asked[13], asked[14], asked[15]},
                                           {asked[16], asked[17], asked[18]});
        return false;
    }
    state.asked = kind.copy.cpu(state.own, state.copy, v);
    return true;
}

}  // namespace vitrine::scenes
