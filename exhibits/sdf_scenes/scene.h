#pragma once

#include "exhibits/sdf_scenes/node_kinds.h"
#include "exhibits/sdf_scenes/record_kinds.h"
#include "render/failure.h"
#include "render/files/json_text.h"
#include "render/text/message.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// Upper limit for the copies that one repetition evaluates at every point.
inline constexpr double mostCopiesAsked = 64;

/// Upper limits for a scene.
struct SceneLimits {
    std::size_t nodes = 16'384;    ///< Counted after instances and includes have been expanded.
    std::size_t files = 64;        ///< The scene's own file and all included ones.
    std::size_t expansions = 64;   ///< Nesting depth of instances and includes.
    std::size_t findings = 20;     ///< Number of findings that are reported.
    std::size_t copiesAsked = 64;  ///< Copies that one repetition may evaluate at a point.
    render::JsonLimits json{8U << 20U, 40'000, 1'000'000, 1U << 16U};
};

/// An error in a scene file, with advice.
struct Finding {
    std::string file;
    int line = 1, column = 1;
    std::string key;       ///< Path of the value; empty for the whole file.
    std::string sentence;  ///< With its full stop.

    /// "file:line:column: key: sentence".
    [[nodiscard]] Message text() const;
    /// Returns the error with this text and place, to be thrown.
    [[nodiscard]] Failure failure() const;
};

inline constexpr std::uint32_t noIndex = ~std::uint32_t{0};

/// A number of a scene, in SI.
struct Number {
    double value = 0;                    ///< Value at time 0, with all parameters at their initial values.
    std::uint32_t expression = noIndex;  ///< Index in `Scene::expressions`, if it is not constant.
};

/// Expression that computes a number from the time `t` in seconds and parameters of the scene.
struct NumberExpression {
    std::string text;
    Unit unit = Unit::none;    ///< Unit of the result.
    std::uint32_t file = 0;    ///< File whose parameters it uses.
    double low = 0, high = 0;  ///< Legal range, SI; the result is clamped to it.
    bool whole = false;
    bool usesTime = false;
};

/// Named number that others are computed from; shown as a slider.
struct SceneParameter {
    std::string name;
    Unit unit = Unit::none;
    double initial = 0, low = 0, high = 1;  ///< SI.
    std::string help;
};

/// Position in a file.
struct Origin {
    std::uint32_t file = 0;   ///< Index in `Scene::files`.
    std::uint32_t value = 0;  ///< Index in the file's `JsonText::values`.
};

/// Node of the tree. Nodes are stored in depth-first order: each before its children, and these in order.
struct Node {
    const NodeKind* kind = nullptr;
    std::string name;
    Origin origin;
    std::uint32_t parent = noIndex, firstChild = noIndex, next = noIndex;
    std::uint32_t numbers = 0;  ///< Index of the first of the kind's numbers.
    std::uint32_t translate = noIndex, rotate = noIndex,
                  scale = noIndex;  ///< Index of the first of three numbers each.
    std::uint32_t material = 0;
    bool hidden = false;
};

/// Material, light, environment, camera or look.
struct Record {
    const RecordKind* kind = nullptr;
    std::string name;
    std::uint32_t numbers = 0;  ///< Index of the first of the kind's numbers.
    std::vector<std::string> files{};
};

/// File that was read for a scene.
struct SceneFile {
    std::shared_ptr<const render::JsonText> text;
    std::vector<SceneParameter> parameters;  ///< Parameters of included files stay at their initial values.
};

/// A complete scene: every reference is resolved, every number is legal at time 0.
struct Scene {
    std::string name;
    std::string about;
    std::vector<SceneFile> files;  ///< The scene's own file first.
    std::vector<Node> nodes;       ///< The root first.
    std::vector<Number> numbers;
    std::vector<NumberExpression> expressions;
    std::vector<Record> materials;  ///< The first one is used for nodes without a material.
    std::vector<Record> lights;
    Record environment, camera, look;
    bool hasCamera = false;        ///< The file contains a camera.
    std::vector<Finding> leftOut;  ///< Shapes of its file that are not drawn, with reasons.

    [[nodiscard]] const std::vector<SceneParameter>& parameters() const { return files.front().parameters; }
    /// Returns whether anything in it moves by itself.
    [[nodiscard]] bool animated() const;
    /// Returns all numbers at a time, SI, each within its range. `parameters` are in the order of `parameters()`;
    /// missing ones have initial values.
    [[nodiscard]] std::vector<double> numbersAt(double time, const std::vector<double>& parameters = {}) const;
};

/// Normalizes the directions among the numbers of a node, as the node's functions expect.
void normalizeDirections(const std::vector<Field>&, double* numbers);

}  // namespace vitrine::scenes
