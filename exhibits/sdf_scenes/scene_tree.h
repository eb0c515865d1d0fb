#pragma once

#include "exhibits/framework/tree.h"
#include "exhibits/sdf_scenes/shown_scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// The nodes in a scene's own file by their paths in it, the definitions under "nodes" behind the tree.
[[nodiscard]] Tree treeOf(const Scene&);

/// A row of a node's table: a field, or one number of it; no field for its material.
struct NodeRow {
    const Field* field = nullptr;
    std::size_t component = 0;
    bool whole = true;  ///< The field's only number, or its direction.
};
[[nodiscard]] std::vector<NodeRow> rowsOfNode(const Scene&, std::string_view path);

/// The numbers of a node in its file as values of a table of their own; of a number that is computed, what it is among
/// `numbers`, which are `Scene::numbersAt`. Nothing where there is no node at this path.
[[nodiscard]] std::optional<TreeRows> nodeRows(const Scene&, const std::vector<double>& numbers, std::string_view path);

/// The scene's text with another value in a row of a node.
[[nodiscard]] std::string textWithRow(const Scene&, std::string_view path, std::size_t row, const Value&);
/// The same with what differs of two places.
[[nodiscard]] std::string textWithPlace(const Scene&, std::string_view path, const TreePlace& before,
                                        const TreePlace& after);

/// In the tree, where the first node of this path stands; `none` where there is none.
[[nodiscard]] std::uint32_t nodeAt(const Scene&, std::string_view path);
/// The path of a node, or of the instance or include that brought it.
[[nodiscard]] std::string pathOf(const Scene&, std::uint32_t node);

/// Its place in its parent; `exhibitFromParent` is the scene's space from the parent's. Where operations around it bend
/// space, it is that space's even part at the node's middle, in the copy that is found first of what is repeated; where
/// the middle is seen nowhere, `without` says so.
[[nodiscard]] TreePlace placeInScene(const ShownScene&, const std::vector<double>& numbers, std::uint32_t node);

/// The scene without anything but the nodes of this path, and the operations around them.
[[nodiscard]] std::shared_ptr<const Scene> onlyNode(const Scene&, std::string_view path);

/// Where a ray (unit direction) first comes to a surface between two distances; infinity: nowhere. Within 0.05 % of the
/// distance.
[[nodiscard]] double marched(const SceneField&, const glm::dvec3& origin, const glm::dvec3& direction, double start,
                             double end);

}  // namespace vitrine::scenes
