#include "render/scene/gltf_accessor.h"

#include <algorithm>
#include <cstring>

namespace vitrine::render {
namespace {

/// An array of `count` elements of `components` values, `stride` bytes apart.
struct Elements {
    const unsigned char* first = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
    std::size_t components = 1;
};

template <typename Stored> Stored load(const unsigned char* at)
{
    Stored x;
    std::memcpy(&x, at, sizeof x);  // Values in files may be unaligned.
    return x;
}

template <typename Stored> float toFloat(Stored x, bool normalized)
{
    if constexpr (std::is_floating_point_v<Stored>)
        return static_cast<float>(x);
    else {
        const float value = static_cast<float>(x);
        if (!normalized) return value;
        return std::max(value / static_cast<float>(std::numeric_limits<Stored>::max()), -1.0F);
    }
}

template <typename Use> void withComponentType(int type, const Use& use)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: use(std::int8_t{}); break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: use(std::uint8_t{}); break;
    case TINYGLTF_COMPONENT_TYPE_SHORT: use(std::int16_t{}); break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: use(std::uint16_t{}); break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: use(std::uint32_t{}); break;
    case TINYGLTF_COMPONENT_TYPE_FLOAT: use(float{}); break;
    default: break;
    }
}

const unsigned char* dataAt(const tinygltf::Model& model, int view, std::size_t offset)
{
    const tinygltf::BufferView& v = model.bufferViews[static_cast<std::size_t>(view)];
    return model.buffers[static_cast<std::size_t>(v.buffer)].data.data() + v.byteOffset + offset;
}

std::size_t componentsOf(const tinygltf::Accessor& accessor)
{
    return static_cast<std::size_t>(
        std::max(0, tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type))));
}

std::vector<float> floatsOf(const Elements& from, int componentType, bool normalized)
{
    std::vector<float> out(from.count * from.components);
    withComponentType(componentType, [&](auto zero) {
        using Stored = decltype(zero);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const unsigned char* element = from.first + i / from.components * from.stride;
            out[i] = toFloat(load<Stored>(element + i % from.components * sizeof(Stored)), normalized);
        }
    });
    return out;
}

std::vector<std::uint32_t> integersOf(const Elements& from, int componentType)
{
    std::vector<std::uint32_t> out(from.count);
    withComponentType(componentType, [&](auto zero) {
        using Stored = decltype(zero);
        if constexpr (std::is_unsigned_v<Stored>) {
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = load<Stored>(from.first + i * from.stride);
        }
    });
    return out;
}

Elements elementsOf(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const std::size_t stride =
        view.byteStride != 0 ? view.byteStride : static_cast<std::size_t>(elementBytes(accessor));
    return {dataAt(model, accessor.bufferView, accessor.byteOffset), stride, accessor.count, componentsOf(accessor)};
}

Elements sparseValuesOf(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    return {
        dataAt(model, accessor.sparse.values.bufferView, static_cast<std::size_t>(accessor.sparse.values.byteOffset)),
        static_cast<std::size_t>(elementBytes(accessor)), static_cast<std::size_t>(accessor.sparse.count),
        componentsOf(accessor)};
}

/// Reads the base values with `read`, or zeros if there is no view. Then applies the sparse replacements.
template <typename Sample, typename Read>
std::vector<Sample> withSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t components,
                               const Read& read)
{
    std::vector<Sample> out =
        accessor.bufferView >= 0 ? read(elementsOf(model, accessor)) : std::vector<Sample>(accessor.count * components);
    if (!accessor.sparse.isSparse) return out;
    const std::vector<std::uint32_t> positions = readSparsePositions(model, accessor);
    const std::vector<Sample> values = read(sparseValuesOf(model, accessor));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
                    out.begin() + static_cast<std::ptrdiff_t>(positions[i] * components));
    }
    return out;
}

}  // namespace

std::uint64_t elementBytes(const tinygltf::Accessor& accessor)
{
    if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_INT ||
        accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE)
        return 0;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    return size > 0 ? static_cast<std::uint64_t>(size) * componentsOf(accessor) : 0;
}

std::vector<std::uint32_t> readSparsePositions(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    const auto& indices = accessor.sparse.indices;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(indices.componentType));
    return integersOf({dataAt(model, indices.bufferView, static_cast<std::size_t>(indices.byteOffset)),
                       static_cast<std::size_t>(std::max(size, 0)), static_cast<std::size_t>(accessor.sparse.count), 1},
                      indices.componentType);
}

std::vector<float> readFloats(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    return withSparse<float>(model, accessor, componentsOf(accessor), [&](const Elements& elements) {
        return floatsOf(elements, accessor.componentType, accessor.normalized);
    });
}

std::vector<std::uint32_t> readIndices(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    return withSparse<std::uint32_t>(
        model, accessor, 1, [&](const Elements& elements) { return integersOf(elements, accessor.componentType); });
}

}  // namespace vitrine::render
