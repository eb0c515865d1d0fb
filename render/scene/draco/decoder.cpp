#include "render/scene/draco_codec.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <draco/compression/decode.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <exception>
#include <new>
#include <type_traits>

namespace vitrine::render {
namespace {

/// Draco's decoder `Base`, which compares the counts of the data with limits before it allocates memory for them: those
/// of the connectivity before it is decoded, and the attributes before their values are.
template <typename Base> class Bounded final : public Base {
public:
    explicit Bounded(const DracoLimits& limits) : limits_(limits) {}
    [[nodiscard]] bool isTooLarge() const { return tooLarge_; }

protected:
    bool DecodeGeometryData() override
    {
        draco::DecoderBuffer ahead = *this->buffer();  // Reads from the same bytes, with a position of its own.
        constexpr bool hasTraversal = std::is_same_v<Base, draco::MeshEdgebreakerDecoder>;
        std::uint8_t traversal = 0;
        if (hasTraversal && !ahead.Decode(&traversal)) return false;
        std::uint32_t first = 0, second = 0;
        if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) return false;
        const std::uint32_t faces = hasTraversal ? second : first;
        const std::uint32_t vertices = hasTraversal ? first : second;
        tooLarge_ = faces > limits_.faces || vertices > limits_.vertices;
        return !tooLarge_ && Base::DecodeGeometryData();
    }
    bool DecodeAllAttributes() override
    {
        std::uint64_t bytes = 0;
        for (std::int32_t i = 0; i < this->mesh()->num_attributes(); ++i)
            bytes += static_cast<std::uint64_t>(this->mesh()->attribute(i)->byte_stride());
        const std::uint64_t vertices = this->mesh()->num_points();
        tooLarge_ = vertices > limits_.vertices || (vertices > 0 && bytes > limits_.bytes / vertices);
        return !tooLarge_ && Base::DecodeAllAttributes();
    }

private:
    DracoLimits limits_;
    bool tooLarge_ = false;
};

template <typename Base>
DracoProblem decodeWith(draco::DecoderBuffer& buffer, const DracoLimits& limits, draco::Mesh& mesh)
{
    Bounded<Base> decoder(limits);
    const draco::DecoderOptions options;
    if (decoder.Decode(options, &buffer, &mesh).ok()) return DracoProblem::none;
    return decoder.isTooLarge() ? DracoProblem::tooLarge : DracoProblem::broken;
}

DracoProblem decodeMesh(std::string_view bytes, const DracoLimits& limits, draco::Mesh& mesh)
{
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::DecoderBuffer ahead = buffer;
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok() || header.encoder_type != draco::TRIANGULAR_MESH)
        return DracoProblem::broken;
    if (header.version_major != 2 || header.version_minor != 2) return DracoProblem::version;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
        return decodeWith<draco::MeshEdgebreakerDecoder>(buffer, limits, mesh);
    if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
        return decodeWith<draco::MeshSequentialDecoder>(buffer, limits, mesh);
    return DracoProblem::broken;
}

template <typename Stored> bool copyValues(const draco::PointAttribute& from, std::size_t vertices, DracoAttribute& to)
{
    const std::size_t size = to.components * sizeof(Stored);
    to.values.resize(vertices * size);
    std::vector<Stored> value(to.components);
    for (std::size_t i = 0; i < vertices; ++i) {
        const draco::AttributeValueIndex at = from.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
        if (at.value() >= from.size() ||
            !from.ConvertValue<Stored>(at, static_cast<std::int8_t>(to.components), value.data()))
            return false;
        std::copy_n(reinterpret_cast<const unsigned char*>(value.data()), size, to.values.data() + i * size);
    }
    return true;
}

bool copyAttribute(const draco::Mesh& mesh, DracoAttribute& to)
{
    const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(to.id);
    if (from == nullptr || from->num_components() != static_cast<int>(to.components)) return false;
    const std::size_t vertices = mesh.num_points();
    switch (to.componentType) {
    case 5120: return copyValues<std::int8_t>(*from, vertices, to);
    case 5121: return copyValues<std::uint8_t>(*from, vertices, to);
    case 5122: return copyValues<std::int16_t>(*from, vertices, to);
    case 5123: return copyValues<std::uint16_t>(*from, vertices, to);
    case 5125: return copyValues<std::uint32_t>(*from, vertices, to);
    case 5126: return copyValues<float>(*from, vertices, to);
    default: return false;
    }
}

class Decoder final : public DracoCodec {
public:
    DracoProblem decode(std::string_view bytes, const DracoLimits& limits, DracoMesh& out) noexcept override
    {
        try {
            draco::Mesh mesh;
            if (const DracoProblem problem = decodeMesh(bytes, limits, mesh); problem != DracoProblem::none)
                return problem;
            out.vertices = mesh.num_points();
            out.indices.clear();
            out.indices.reserve(3 * static_cast<std::size_t>(mesh.num_faces()));
            for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
                for (const draco::PointIndex& corner : mesh.face(f)) out.indices.push_back(corner.value());
            for (DracoAttribute& attribute : out.attributes)
                if (!copyAttribute(mesh, attribute)) return DracoProblem::attribute;
            return DracoProblem::none;
        } catch (const std::bad_alloc&) {
            return DracoProblem::tooLarge;
        } catch (const std::exception&) {
            return DracoProblem::broken;
        }
    }
};

}  // namespace
}  // namespace vitrine::render

extern "C" __attribute__((visibility("default"))) vitrine::render::DracoCodec* vitrineDraco(int version)
{
    static vitrine::render::Decoder decoder;
    return version == vitrineDracoVersion ? &decoder : nullptr;
}
