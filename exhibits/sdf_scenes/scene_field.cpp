#include "exhibits/sdf_scenes/scene_field.h"

#include "exhibits/sdf_scenes/scene_functions_cpu.h"

#include <algorithm>

namespace vitrine::scenes {
namespace {

constexpr double nothingNear = 1e9;

/// What each node has while a point is evaluated.
struct NodeState {
    glm::dvec3 own{0};    // The point in the node's space.
    glm::dvec3 asked{0};  // Where its children are asked.
    double distance = 0;
    int copy = 0;
    double lipschitz = 1;
};

struct Surface {
    std::uint32_t node = none;
    glsl::SceneMaterial material{};
};

/// Evaluates at a point, step by step; with materials where asked for.
class Walk {
public:
    Walk(const SceneProgram& program, const std::vector<double>& words, bool withMaterials)
        : program_(program), words_(words.data()), states_(program.nodes().size()),
          surfaces_(withMaterials ? states_.size() : 0)
    {
    }

    void run(const glm::dvec3& p)
    {
        const std::vector<Step>& steps = program_.steps();
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const Step& step = steps[i];
            const ProgramNode& node = program_.nodes()[step.node];
            NodeState& state = states_[step.node];
            switch (step.type) {
            case Step::Type::enter: enter(step.node, node.parent == none ? p : states_[node.parent].asked); break;
            case Step::Type::shape: shape(step.node); break;
            case Step::Type::first:
                state.distance = states_[step.child].distance;
                inherit(step.node, step.child);
                break;
            case Step::Type::combine: combine(step); break;
            case Step::Type::modify: modify(step); break;
            case Step::Type::again:
                if (again(step)) i = step.back - 1;
                break;
            case Step::Type::leave:
                if (node.scale != none) state.distance = glsl::sdfScaled(state.distance, words_[node.scale + 3]);
                break;
            }
        }
    }

    [[nodiscard]] const std::vector<NodeState>& states() const { return states_; }
    [[nodiscard]] const Surface& surface(std::uint32_t node) const { return surfaces_[node]; }

private:
    [[nodiscard]] glm::dvec3 vectorAt(std::uint32_t word) const
    {
        return {words_[word], words_[word + 1], words_[word + 2]};
    }

    void enter(std::uint32_t index, const glm::dvec3& outside)
    {
        const ProgramNode& node = program_.nodes()[index];
        const NodeKind& kind = program_.kind(node);
        NodeState& state = states_[index];
        glm::dvec3 p = outside;
        if (node.translate != none) p -= vectorAt(node.translate);
        if (node.rotate != none)
            p = glsl::sceneTurned(p, vectorAt(node.rotate), vectorAt(node.rotate + 3), vectorAt(node.rotate + 6));
        if (node.scale != none) p *= vectorAt(node.scale);
        const double* v = words_ + node.numbers;
        state.own = p;
        state.copy = 0;
        state.asked = kind.place ? kind.place.cpu(p, v) : kind.copy ? kind.copy.cpu(p, 0, v) : p;
        state.lipschitz = kind.lipschitz ? kind.lipschitz(p, v) : 1;
        if (kind.form == Form::repeater) state.distance = nothingNear;
    }

    void shape(std::uint32_t index)
    {
        const ProgramNode& node = program_.nodes()[index];
        NodeState& state = states_[index];
        state.distance = program_.kind(node).distance.cpu(state.own, words_ + node.numbers);
        if (surfaces_.empty()) return;
        const double* w = words_ + program_.materialWord(node.material);
        surfaces_[index] = {node.node, glsl::sceneMaterial({w[0], w[1], w[2], w[3]}, {w[4], w[5], w[6], w[7]},
                                                           {w[8], w[9], w[10], w[11]})};
    }

    void inherit(std::uint32_t node, std::uint32_t child)
    {
        if (!surfaces_.empty()) surfaces_[node] = surfaces_[child];
    }

    void combine(const Step& step)
    {
        const ProgramNode& node = program_.nodes()[step.node];
        const NodeKind& kind = program_.kind(node);
        const double* v = words_ + node.numbers;
        const double a = states_[step.node].distance;
        const double b = states_[step.child].distance;
        states_[step.node].distance = kind.combine.cpu(a, b, v);
        if (surfaces_.empty()) return;
        Surface& own = surfaces_[step.node];
        const double share = kind.share.cpu(a, b, v);
        own.material = glsl::sceneBlend(own.material, surfaces_[step.child].material, share);
        if (share > 0.5) own.node = surfaces_[step.child].node;
    }

    void modify(const Step& step)
    {
        const ProgramNode& node = program_.nodes()[step.node];
        const NodeKind& kind = program_.kind(node);
        const double d = states_[step.child].distance;
        NodeState& state = states_[step.node];
        state.distance = kind.after ? kind.after.cpu(d, state.own, words_ + node.numbers) : d;
        inherit(step.node, step.child);
    }

    /// Whether there is another copy to ask.
    bool again(const Step& step)
    {
        const ProgramNode& node = program_.nodes()[step.node];
        const NodeKind& kind = program_.kind(node);
        const double* v = words_ + node.numbers;
        const double* asked = v + kind.numbers();
        NodeState& state = states_[step.node];
        const double d = glsl::sceneCapped(states_[step.child].distance, state.asked, asked[6],
                                           {asked[7], asked[8], asked[9]}, {asked[10], asked[11], asked[12]});
        if (d < state.distance || state.copy == 0) inherit(step.node, step.child);
        state.distance = std::min(state.distance, d);
        if (++state.copy >= static_cast<int>(asked[3]) * static_cast<int>(asked[4]) * static_cast<int>(asked[5]))
            return false;
        state.asked = kind.copy.cpu(state.own, state.copy, v);
        return true;
    }

    const SceneProgram& program_;
    const double* words_;
    std::vector<NodeState> states_;
    std::vector<Surface> surfaces_;
};

}  // namespace

SceneField::SceneField(std::shared_ptr<const SceneProgram> program, SceneWords words)
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
    Walk walk(*program_, words_.words, false);
    walk.run(p);
    return walk.states().front().distance;
}

SceneSample SceneField::sample(const glm::dvec3& p) const
{
    if (program_->nodes().empty()) return {.distance = nothingNear};
    Walk walk(*program_, words_.words, true);
    walk.run(p);
    const Surface& surface = walk.surface(0);
    const glsl::SceneMaterial& m = surface.material;
    return {walk.states().front().distance,
            surface.node,
            {m.color.x, m.color.y, m.color.z, m.ambient, m.diffuse, m.specular, m.shininess, m.mirror, m.metalness,
             m.roughness, m.reflectance, m.refractiveIndex}};
}

std::vector<NodeSample> SceneField::nodes(const glm::dvec3& p) const
{
    Walk walk(*program_, words_.words, false);
    walk.run(p);
    std::vector<NodeSample> samples;
    for (const NodeState& state : walk.states()) samples.push_back({state.distance, state.lipschitz});
    return samples;
}

render::Box SceneField::box() const
{
    if (program_->nodes().empty()) return {};
    return words_.extents.front().box;
}

}  // namespace vitrine::scenes
