#pragma once

#include "render/scene/mesh.h"
#include "render/scene/tinygltf.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine::render {

/// What deforms the meshes of a glTF file at one moment.
struct GltfPose {
    /// Of a node with a skin: from the mesh's space to that of the model, for each joint. Empty: no skin.
    std::vector<std::vector<glm::dmat4>> jointsOfNode;
    /// Of a node with a mesh: weights of its morph targets; may be empty.
    std::vector<std::vector<double>> weightsOfNode;

    /// Whether the joints and weights of this set ("0" of JOINTS_0 and WEIGHTS_0) are used: eight joints a vertex.
    [[nodiscard]] static bool takesSet(const std::string& number) { return number == "0" || number == "1"; }
    [[nodiscard]] bool isSkinned(int node) const { return !jointsOfNode[static_cast<std::size_t>(node)].empty(); }
    [[nodiscard]] bool deforms(int node) const
    {
        return isSkinned(node) || !weightsOfNode[static_cast<std::size_t>(node)].empty();
    }
    /// Moves the vertices, which are in the order of the primitive's accessors: targets first, then joints.
    void deform(Mesh&, const tinygltf::Model&, const tinygltf::Primitive&, int node) const;
};

}  // namespace vitrine::render
