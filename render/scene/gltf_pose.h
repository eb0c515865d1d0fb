#pragma once

#include "render/scene/mesh.h"
#include "render/scene/tinygltf.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace vitrine::render {

/// Deformation of the meshes of a glTF file at one time.
struct GltfPose {
    /// For each node with a skin: the transform of each joint, from the mesh's space to the model's. Empty: no skin.
    std::vector<std::vector<glm::dmat4>> jointsOfNode;
    /// For each node with a mesh: weights of its morph targets; may be empty.
    std::vector<std::vector<double>> weightsOfNode;

    /// Returns whether this set of joints and weights is used ("0" for JOINTS_0 and WEIGHTS_0). Two sets make eight
    /// joints per vertex.
    [[nodiscard]] static bool takesSet(const std::string& number) { return number == "0" || number == "1"; }
    [[nodiscard]] bool isSkinned(int node) const { return !jointsOfNode[static_cast<std::size_t>(node)].empty(); }
    [[nodiscard]] bool deforms(int node) const
    {
        return isSkinned(node) || !weightsOfNode[static_cast<std::size_t>(node)].empty();
    }
    /// Deforms the vertices, which are in the order of the primitive's accessors: first morph targets, then joints.
    void deform(Mesh&, const tinygltf::Model&, const tinygltf::Primitive&, int node) const;
};

}  // namespace vitrine::render
