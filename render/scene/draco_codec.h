#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// Attribute to be decoded: one value for each vertex of the mesh.
struct DracoAttribute {
    std::uint32_t id = 0;               ///< Its unique id in the Draco data.
    int componentType = 0;              ///< Component type of glTF, of the values in `values`.
    std::size_t components = 0;         ///< Number of components of a value in `values`.
    std::vector<unsigned char> values;  ///< Result: tightly packed.
};

/// Upper limits for one mesh. The counts in its header are compared with them before memory is allocated.
struct DracoLimits {
    std::uint64_t faces = 0;
    std::uint64_t vertices = 0;
    std::uint64_t bytes = 0;  ///< For the values of all attributes that the data has, as they are stored there.
};

/// Mesh to be decoded.
struct DracoMesh {
    std::vector<DracoAttribute> attributes;
    std::vector<std::uint32_t> indices;  ///< Result: three for each triangle.
    std::size_t vertices = 0;            ///< Result.
};

/// `version`: the data is not of bitstream version 2.2, which glTF requires. `attribute`: an attribute is missing or
/// cannot be stored in its component type.
enum class DracoProblem : std::uint8_t { none, broken, version, tooLarge, attribute };

/// Interface of the Draco module, which is in a library of its own and is opened for the first compressed mesh.
class DracoCodec {
public:
    virtual ~DracoCodec() = default;
    /// Decodes a triangle mesh: fills in `vertices`, `indices` and the values of the attributes.
    [[nodiscard]] virtual DracoProblem decode(std::string_view bytes, const DracoLimits&, DracoMesh&) noexcept = 0;
};

/// Opens the module `vitrine_draco` on the first call. Thread-safe. Throws Failure if it cannot be opened.
[[nodiscard]] DracoCodec& dracoCodec();

}  // namespace vitrine::render

/// The module's only exported symbol. Returns null unless `version` is `vitrineDracoVersion`.
inline constexpr int vitrineDracoVersion = 1;
extern "C" vitrine::render::DracoCodec* vitrineDraco(int version);
