#pragma once

#include "render/scene/tinygltf.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine::render {

/// Bytes of one element of an accessor: 0 when its type or component type is none of glTF's.
[[nodiscard]] std::uint64_t elementBytes(const tinygltf::Accessor&);

/// The values of a validated accessor: `count * components` floats, integers divided by their largest value
/// when the accessor says `normalized`, sparse replacements applied. `components` is what its type has.
[[nodiscard]] std::vector<float> readFloats(const tinygltf::Model&, int accessor);

/// The values of a validated scalar accessor of unsigned integers, sparse replacements applied.
[[nodiscard]] std::vector<std::uint32_t> readIndices(const tinygltf::Model&, int accessor);

/// The replaced positions of a sparse accessor whose views were validated.
[[nodiscard]] std::vector<std::uint32_t> readSparsePositions(const tinygltf::Model&, const tinygltf::Accessor&);

}  // namespace vitrine::render
