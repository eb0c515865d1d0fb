#pragma once

#include "exhibits/sdf_scenes/node_kinds.h"
#include "exhibits/sdf_scenes/record_kinds.h"
#include "render/files/json_text.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// How many copies one repetition may ask at every point.
inline constexpr double mostCopiesAsked = 64;

/// What a scene may be at most.
struct SceneLimits {
    std::size_t nodes = 16'384;    ///< After instances and includes have taken their places.
    std::size_t files = 64;        ///< The scene's own and all that it includes.
    std::size_t expansions = 64;   ///< Instances and includes inside one another.
    std::size_t findings = 20;     ///< That are reported.
    std::size_t copiesAsked = 64;  ///< By one repetition, at every point.
    render::JsonLimits json{8U << 20U, 40'000, 1'000'000, 1U << 16U};
};

/// Something wrong in a scene file, and what to do.
struct Finding {
    std::string file;
    int line = 1, column = 1;
    std::string key;       ///< Path of the value; empty for the whole file.
    std::string sentence;  ///< With its full stop.

    /// "file:line:column: key: sentence".
    [[nodiscard]] std::string text() const;
};

inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// A number of a scene, in SI.
struct Number {
    double value = 0;                 ///< At time 0, with all parameters at their initial values.
    std::uint32_t expression = none;  ///< In `Scene::expressions`, where it is more than a constant.
};

/// A number that is computed from the time `t` in seconds and parameters of the scene.
struct NumberExpression {
    std::string text;
    Unit unit = Unit::none;    ///< Of what it gives.
    std::uint32_t file = 0;    ///< Whose parameters it names.
    double low = 0, high = 0;  ///< Legal range, SI; it is cut to it.
    bool whole = false;
    bool usesTime = false;
};

/// A named number that others are computed from: a slider.
struct SceneParameter {
    std::string name;
    Unit unit = Unit::none;
    double initial = 0, low = 0, high = 1;  ///< SI.
    std::string help;
};

/// Where in a file something was written.
struct Origin {
    std::uint32_t file = 0;   ///< In `Scene::files`.
    std::uint32_t value = 0;  ///< In its `JsonText::values`.
};

/// A node of the tree. Nodes stand in the order of a walk: each before its children, these in order.
struct Node {
    const NodeKind* kind = nullptr;
    std::string name;
    Origin origin;
    std::uint32_t parent = none, firstChild = none, next = none;
    std::uint32_t numbers = 0;                                    ///< First of the kind's numbers.
    std::uint32_t translate = none, rotate = none, scale = none;  ///< First of three numbers each.
    std::uint32_t material = 0;
    bool hidden = false;
};

/// A material, light, environment, camera or look.
struct Record {
    const RecordKind* kind = nullptr;
    std::string name;
    std::uint32_t numbers = 0;  ///< First of the kind's numbers.
    std::vector<std::string> files{};
};

/// A file that was read for a scene.
struct SceneFile {
    std::shared_ptr<const render::JsonText> text;
    std::vector<SceneParameter> parameters;  ///< Those of included files stay at their initial values.
};

/// A scene that was read and is whole: every reference is resolved, every number is legal at time 0.
struct Scene {
    std::string name;
    std::string about;
    std::vector<SceneFile> files;  ///< The scene's own first.
    std::vector<Node> nodes;       ///< The root first.
    std::vector<Number> numbers;
    std::vector<NumberExpression> expressions;
    std::vector<Record> materials;  ///< The first is that of nodes without one.
    std::vector<Record> lights;
    Record environment, camera, look;
    bool hasCamera = false;        ///< Whether its file says where it is seen from.
    std::vector<Finding> leftOut;  ///< Shapes of its file that are not drawn, and why.

    [[nodiscard]] const std::vector<SceneParameter>& parameters() const { return files.front().parameters; }
    /// Whether something in it moves by itself.
    [[nodiscard]] bool animated() const;
    /// All numbers at a moment, SI: each within its range. `parameters` are in the order of `parameters()`; missing
    /// ones are initial.
    [[nodiscard]] std::vector<double> numbersAt(double time, const std::vector<double>& parameters = {}) const;
};

/// Numbers of a field as the node's functions take them: directions at unit length.
void normalizeDirections(const std::vector<Field>&, double* numbers);

}  // namespace vitrine::scenes
