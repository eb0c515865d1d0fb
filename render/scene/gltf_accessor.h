#pragma once

#include "render/scene/tinygltf.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine::render {

/// Returns the bytes of one element of an accessor; 0 if its type or component type is unknown to glTF.
[[nodiscard]] std::uint64_t elementBytes(const tinygltf::Accessor&);

/// Returns the values of a validated accessor: `count * components` floats, where `components` depends on its type.
/// Integers are divided by their largest value if the accessor is `normalized`. Sparse replacements are applied.
[[nodiscard]] std::vector<float> readFloats(const tinygltf::Model&, int accessor);

/// Returns the values of a validated scalar accessor of unsigned integers, with sparse replacements applied.
[[nodiscard]] std::vector<std::uint32_t> readIndices(const tinygltf::Model&, int accessor);

/// Returns the indices of the replaced elements of a sparse accessor whose views were validated.
[[nodiscard]] std::vector<std::uint32_t> readSparsePositions(const tinygltf::Model&, const tinygltf::Accessor&);

}  // namespace vitrine::render
