#pragma once

#include "render/files/strict_json.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::test {

/// Makes small glTF files, valid until a test breaks `json` or `bin`.
class GltfBuilder {
public:
    GltfBuilder();

    /// Appends data to the buffer, with a view of it; returns the view's index.
    int view(std::string_view bytes);
    /// An accessor of float components; returns its index.
    int floats(const std::vector<float>& values, const std::string& type);
    /// An accessor of 16-bit indices; returns its index.
    int indices(const std::vector<std::uint16_t>& values);
    /// A mesh of one triangle with corners (0,0,0) (1,0,0) (0,1,0) and texture coordinates that fit the
    /// picture: (0,1) (1,1) (0,0).
    int triangle();
    /// A node of the scene; returns its index.
    int node(render::Json);

    [[nodiscard]] std::string glb() const;
    /// As .gltf, with the buffer as a data: URI.
    [[nodiscard]] std::string text() const;

    render::Json json;
    std::string bin;

private:
    [[nodiscard]] render::Json complete() const;
};

/// A GLB container around any JSON text and BIN bytes, padded, and further chunks: types of four characters, and bytes.
[[nodiscard]] std::string glbOf(std::string json, std::string bin,
                                const std::vector<std::pair<std::string, std::string>>& further = {});

}  // namespace vitrine::test
