#pragma once

#include "exhibits/framework/scene/tree.h"
#include "exhibits/sdf_scenes/shown_scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// Returns the nodes in a scene's own file by their paths, with the definitions under "nodes" after the tree.
[[nodiscard]] Tree treeOf(const Scene&);

/// Parameter of a node: a field, or one number of a field. `field` is null for the material.
struct NodeParameter {
    const Field* field = nullptr;
    std::size_t component = 0;
    bool whole = true;  ///< The parameter is the field's only number, or its direction.
};
[[nodiscard]] std::vector<NodeParameter> parametersOfNode(const Scene&, std::string_view path);

/// Returns the numbers of a node in its file as parameter values. A computed number has its value in `numbers`, which
/// are those of `Scene::numbersAt`. Returns nothing if there is no node at this path.
[[nodiscard]] std::optional<TreeParameters> nodeParameters(const Scene&, const std::vector<double>& numbers,
                                                           std::string_view path);

/// Returns the scene's text with another value of a parameter of a node.
[[nodiscard]] std::string textWithParameter(const Scene&, std::string_view path, std::size_t row, const Value&);
/// Returns the scene's text with the differences between two transforms of a node.
[[nodiscard]] std::string textWithPlace(const Scene&, std::string_view path, const TreePlace& before,
                                        const TreePlace& after);

/// Returns the index of the first node with this path; `none` if there is none.
[[nodiscard]] std::uint32_t nodeAt(const Scene&, std::string_view path);
/// Returns the path of a node, or of the instance or include that created it.
[[nodiscard]] std::string pathOf(const Scene&, std::uint32_t node);

/// Returns the transform of a node to its parent; `exhibitFromParent` maps the parent's space to the scene's. If
/// operations around the node bend space, it is their local linearization at the node's center, in the first copy found
/// of a repetition. If the center is not visible anywhere, `without` says so.
[[nodiscard]] TreePlace placeInScene(const ShownScene&, const std::vector<double>& numbers, std::uint32_t node);

/// Returns the scene with only the nodes of this path, and the operations around them.
[[nodiscard]] std::shared_ptr<const Scene> onlyNode(const Scene&, std::string_view path);

/// Returns the distance at which a ray (unit direction) first hits a surface between two distances; infinity: never.
/// Accurate to 0.05 % of the distance.
[[nodiscard]] double marched(const SceneField&, const glm::dvec3& origin, const glm::dvec3& direction, double start,
                             double end);

}  // namespace vitrine::scenes
