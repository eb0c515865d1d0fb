#pragma once

#include "render/files/strict_json.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::test {

/// Builder of small glTF files, which are valid until a test changes `json` or `bin`.
class GltfBuilder {
public:
    GltfBuilder();

    /// Appends data to the buffer with a buffer view. Returns the view's index.
    int view(std::string_view bytes);
    /// Adds an accessor of float components. Returns its index.
    int floats(const std::vector<float>& values, const std::string& type);
    /// Adds an accessor of 16-bit indices. Returns its index.
    int indices(const std::vector<std::uint16_t>& values);
    /// Adds a mesh of one triangle with the corners (0,0,0) (1,0,0) (0,1,0) and the texture coordinates (0,1) (1,1)
    /// (0,0), which match the picture. Returns its index.
    int triangle();
    /// Adds a node to the scene. Returns its index.
    int node(render::Json);

    [[nodiscard]] std::string glb() const;
    /// Returns a .gltf file, with the buffer as a data: URI.
    [[nodiscard]] std::string text() const;

    render::Json json;
    std::string bin;

private:
    [[nodiscard]] render::Json complete() const;
};

/// Returns a GLB container with any JSON text and BIN bytes, padded, and with further chunks: types of four characters,
/// and bytes.
[[nodiscard]] std::string glbOf(std::string json, std::string bin,
                                const std::vector<std::pair<std::string, std::string>>& further = {});

}  // namespace vitrine::test
