#include "exhibits/framework/scene/tree.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace vitrine {

std::size_t Tree::find(std::string_view id) const
{
    const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const TreeNode& node) { return node.id == id; });
    return found == nodes.end() ? TreeNode::none : static_cast<std::size_t>(found - nodes.begin());
}

glm::dmat3 TreePlace::rotation() const
{
    const glm::dmat4 one(1);
    return glm::dmat3(glm::rotate(one, rotate.x, {1, 0, 0}) * glm::rotate(one, rotate.y, {0, 1, 0}) *
                      glm::rotate(one, rotate.z, {0, 0, 1}));
}

}  // namespace vitrine
