#include "render/scene/gltf_compression.h"

#include "render/failure.h"
#include "render/scene/draco_codec.h"
#include "render/scene/gltf_accessor.h"
#include "render/scene/gltf_schema.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace vitrine::render {
namespace {

constexpr const char* dracoName = "KHR_draco_mesh_compression";
constexpr const char* meshoptName = "EXT_meshopt_compression";

/// Returns the extension of an element; null if it has none.
const Json* extensionOf(const Json& element, const char* name)
{
    const auto extensions = element.find("extensions");
    if (extensions == element.end()) return nullptr;
    const auto at = extensions->find(name);
    return at == extensions->end() ? nullptr : &*at;
}

std::uint64_t sizeOr(const Json& object, const char* key, std::uint64_t absent)
{
    const auto at = object.find(key);
    return at == object.end() ? absent : at->get<std::uint64_t>();
}

using Bytes = std::vector<unsigned char>;

/// Mode of EXT_meshopt_compression, with the function that decodes it.
struct MeshoptMode {
    std::string_view name;
    bool isIndices;
    std::size_t multiple;  ///< The number of elements is a multiple of this.
    int (*decode)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
};
constexpr std::array<MeshoptMode, 3> meshoptModes{{{"ATTRIBUTES", false, 1, meshopt_decodeVertexBuffer},
                                                   {"TRIANGLES", true, 3, meshopt_decodeIndexBuffer},
                                                   {"INDICES", true, 1, meshopt_decodeIndexSequence}}};

/// Filter that is applied to decoded attributes. `strides`: the sizes of an element that it allows; zero: any.
struct MeshoptFilter {
    std::string_view name;
    std::array<std::uint64_t, 2> strides;
    void (*apply)(void*, std::size_t, std::size_t);
};
constexpr std::array<MeshoptFilter, 4> meshoptFilters{{{"NONE", {0, 0}, nullptr},
                                                       {"OCTAHEDRAL", {4, 8}, meshopt_decodeFilterOct},
                                                       {"QUATERNION", {8, 8}, meshopt_decodeFilterQuat},
                                                       {"EXPONENTIAL", {0, 0}, meshopt_decodeFilterExp}}};

template <typename Row, std::size_t size>
const Row* rowNamed(const std::array<Row, size>& rows, const std::string& name)
{
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
    return at == rows.end() ? nullptr : &*at;
}

class Decompressor {
public:
    Decompressor(tinygltf::Model& model, const JsonDocument& document, const GltfLimits& limits)
        : model_(model), document_(document), limits_(limits)
    {
    }

    void decompress()
    {
        const Json& views = arrayAt(document_, "bufferViews");
        for (std::size_t i = 0; i < views.size(); ++i)
            if (const Json* extension = extensionOf(views[i], meshoptName))
                decodeView(i, *extension, elementPath("bufferViews", i, meshoptName));
        const Json& meshes = arrayAt(document_, "meshes");
        for (std::size_t m = 0; m < meshes.size(); ++m) {
            const Json& primitives = meshes[m].at("primitives");
            for (std::size_t p = 0; p < primitives.size(); ++p)
                if (const Json* extension = extensionOf(primitives[p], dracoName))
                    decodePrimitive(model_.meshes.at(m).primitives.at(p), *extension,
                                    elementPath("meshes", m, "primitives") + '[' + std::to_string(p) + "].extensions." +
                                        dracoName);
        }
    }

private:
    [[noreturn]] void fail(const std::string& path, const Message& problem) const
    {
        throw document_.failure(path, message("{1}; export the file again.", problem));
    }

    /// Counts decoded bytes before they are allocated.
    void count(std::uint64_t bytes, const std::string& path)
    {
        if (bytes > limits_.bufferBytes || (decoded_ += bytes) > limits_.bufferBytes)
            throw document_.failure(
                path, message("the decoded data is larger than {1} bytes; simplify the model.", limits_.bufferBytes));
    }

    /// Adds a buffer. Returns its index.
    int addBuffer(Bytes bytes)
    {
        model_.buffers.emplace_back().data = std::move(bytes);
        return static_cast<int>(model_.buffers.size()) - 1;
    }

    void decodeView(std::size_t i, const Json& extension, const std::string& path)
    {
        const std::uint64_t buffer = sizeOr(extension, "buffer", 0), offset = sizeOr(extension, "byteOffset", 0);
        const std::uint64_t length = sizeOr(extension, "byteLength", 0), elements = sizeOr(extension, "count", 0);
        const std::uint64_t stride = sizeOr(extension, "byteStride", 0);
        const MeshoptMode* mode = rowNamed(meshoptModes, extension.at("mode").get<std::string>());
        const MeshoptFilter* filter = rowNamed(meshoptFilters, extension.value("filter", "NONE"));
        if (mode == nullptr || filter == nullptr || (mode->isIndices && filter->apply != nullptr))
            fail(path, message("its mode or filter is none of EXT_meshopt_compression's"));
        const bool strideIsLegal = mode->isIndices ? stride == 2 || stride == 4
                                                   : stride >= 4 && stride <= 256 && stride % 4 == 0 &&
                                                         (filter->strides[0] == 0 || stride == filter->strides[0] ||
                                                          stride == filter->strides[1]);
        if (!strideIsLegal) fail(path, message("its byteStride does not fit its mode and filter"));
        if (buffer >= model_.buffers.size() || offset > model_.buffers[buffer].data.size() ||
            length > model_.buffers[buffer].data.size() - offset)
            fail(path, message("its compressed data reaches beyond the buffer"));
        tinygltf::BufferView& view = model_.bufferViews.at(i);
        if (elements > view.byteLength / stride || elements * stride != view.byteLength ||
            elements % mode->multiple != 0)
            fail(path, message("its count and byteStride do not make the byteLength of the view"));
        count(view.byteLength, path);
        Bytes bytes(view.byteLength);
        if (mode->decode(bytes.data(), elements, stride, model_.buffers[buffer].data.data() + offset, length) != 0)
            fail(path, message("its compressed data is broken"));
        if (filter->apply != nullptr) filter->apply(bytes.data(), elements, stride);
        view.buffer = addBuffer(std::move(bytes));
        view.byteOffset = 0;
    }

    void decodePrimitive(tinygltf::Primitive& primitive, const Json& extension, const std::string& path)
    {
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP)
            fail(path, message("compressed primitives consist of triangles"));
        const std::vector<int> accessors = accessorsOf(primitive, extension, path);
        DracoMesh mesh;
        for (const auto& [name, id] : extension.at("attributes").items()) {
            const tinygltf::Accessor& a = model_.accessors[static_cast<std::size_t>(accessors[mesh.attributes.size()])];
            const auto components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type));
            mesh.attributes.push_back({.id = id.template get<std::uint32_t>(),
                                       .componentType = a.componentType,
                                       .components = static_cast<std::size_t>(std::max(0, components))});
        }
        decode(extension, mesh, path);
        for (std::size_t i = 0; i < accessors.size(); ++i) {
            tinygltf::Accessor& a = model_.accessors[static_cast<std::size_t>(accessors[i])];
            if (a.count != mesh.vertices)
                fail(path, message("it has {1} vertices, and an accessor of it has {2}", mesh.vertices, a.count));
            fill(a, std::move(mesh.attributes[i].values), path);
        }
        if (primitive.indices < 0) {
            primitive.indices = static_cast<int>(model_.accessors.size());
            model_.accessors.emplace_back();
        }
        // The decoded triangles are separate, in place of a strip, too.
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        tinygltf::Accessor& indices = model_.accessors[static_cast<std::size_t>(primitive.indices)];
        indices.count = mesh.indices.size();
        indices.type = TINYGLTF_TYPE_SCALAR;
        indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        const auto* first = reinterpret_cast<const unsigned char*>(mesh.indices.data());
        fill(indices, Bytes(first, first + mesh.indices.size() * sizeof(std::uint32_t)), path);
    }

    /// Returns the accessors of the compressed attributes, in the order of the extension's members.
    std::vector<int> accessorsOf(const tinygltf::Primitive& primitive, const Json& extension,
                                 const std::string& path) const
    {
        std::vector<int> accessors;
        for (const auto& [name, id] : extension.at("attributes").items()) {
            const auto at = primitive.attributes.find(name);
            if (at == primitive.attributes.end())
                fail(path, message("it compresses {1}, which the primitive does not have", name));
            accessors.push_back(at->second);
        }
        const auto exists = [&](int a) { return static_cast<std::size_t>(a) < model_.accessors.size(); };
        if (!std::all_of(accessors.begin(), accessors.end(), exists) ||
            (primitive.indices >= 0 && !exists(primitive.indices)))
            fail(path, message("an accessor of it does not exist"));
        return accessors;
    }

    void decode(const Json& extension, DracoMesh& mesh, const std::string& path)
    {
        const auto index = extension.at("bufferView").get<std::size_t>();
        if (index >= model_.bufferViews.size()) fail(path, message("its buffer view does not exist"));
        const tinygltf::BufferView& view = model_.bufferViews[index];
        const Bytes& data = model_.buffers.at(static_cast<std::size_t>(view.buffer)).data;
        if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
            fail(path, message("its compressed data reaches beyond the buffer"));
        const std::string_view bytes(reinterpret_cast<const char*>(data.data()) + view.byteOffset, view.byteLength);
        const DracoLimits limits{limits_.indices / 3, limits_.vertices, limits_.bufferBytes - decoded_};
        switch (dracoCodec().decode(bytes, limits, mesh)) {
        case DracoProblem::none: break;
        case DracoProblem::broken: fail(path, message("its compressed data is broken"));
        case DracoProblem::version: fail(path, message("its compressed data is not of version 2.2 of Draco"));
        case DracoProblem::tooLarge:
            throw document_.failure(path, message("the decoded mesh is too large; simplify the model."));
        case DracoProblem::attribute:
            fail(path, message("its compressed data has not the attributes that the primitive names"));
        }
        std::uint64_t total = mesh.indices.size() * sizeof(std::uint32_t);
        for (const DracoAttribute& attribute : mesh.attributes) total += attribute.values.size();
        count(total, path);
    }

    /// Gives an accessor its values, in a buffer view of their own.
    void fill(tinygltf::Accessor& accessor, Bytes values, const std::string& path)
    {
        if (values.empty()) fail(path, message("its compressed data has no triangles"));
        tinygltf::BufferView& view = model_.bufferViews.emplace_back();
        view.byteLength = values.size();
        view.buffer = addBuffer(std::move(values));
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.byteOffset = 0;
    }

    tinygltf::Model& model_;
    const JsonDocument& document_;
    const GltfLimits& limits_;
    std::uint64_t decoded_ = 0;
};

}  // namespace

std::vector<bool> dracoAccessors(const JsonDocument& document)
{
    std::vector<bool> compressed(arrayAt(document, "accessors").size(), false);
    const auto mark = [&](const Json& accessor) {
        if (const auto i = accessor.get<std::size_t>(); i < compressed.size()) compressed[i] = true;
    };
    for (const Json& mesh : arrayAt(document, "meshes"))
        for (const Json& primitive : mesh.at("primitives")) {
            const Json* extension = extensionOf(primitive, dracoName);
            if (extension == nullptr) continue;
            const Json& attributes = primitive.at("attributes");
            for (const auto& [name, id] : extension->at("attributes").items())
                if (const auto at = attributes.find(name); at != attributes.end()) mark(*at);
            if (const auto at = primitive.find("indices"); at != primitive.end()) mark(*at);
        }
    return compressed;
}

bool isFallbackBuffer(const Json& buffer)
{
    const Json* extension = extensionOf(buffer, meshoptName);
    return extension != nullptr && extension->value("fallback", false);
}

void decompress(tinygltf::Model& model, const JsonDocument& document, const GltfLimits& limits)
{
    Decompressor(model, document, limits).decompress();
}

}  // namespace vitrine::render
