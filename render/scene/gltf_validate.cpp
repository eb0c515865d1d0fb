#include "render/scene/gltf_validate.h"

#include "render/scene/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vitrine::render {
namespace {

std::string at(const char* array, std::size_t i, const std::string& rest = {})
{
    std::string path = array;
    ((path += '[') += std::to_string(i)) += ']';
    return path += rest;
}

class Validator {
public:
    Validator(const tinygltf::Model& model, const JsonDocument& document, const GltfLimits& limits)
        : model_(model), document_(document), limits_(limits)
    {
    }

    void validate()
    {
        for (std::size_t i = 0; i < model_.bufferViews.size(); ++i) view(i);
        for (std::size_t i = 0; i < model_.accessors.size(); ++i) accessor(i);
        for (std::size_t i = 0; i < model_.textures.size(); ++i) {
            optionalIndex(model_.textures[i].source, model_.images.size(), at("textures", i, ".source"));
            optionalIndex(model_.textures[i].sampler, model_.samplers.size(), at("textures", i, ".sampler"));
        }
        for (std::size_t i = 0; i < model_.images.size(); ++i) {
            optionalIndex(model_.images[i].bufferView, model_.bufferViews.size(), at("images", i, ".bufferView"));
        }
        for (std::size_t i = 0; i < model_.materials.size(); ++i) material(i);
        for (std::size_t i = 0; i < model_.meshes.size(); ++i) mesh(i);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) node(i);
        const std::vector<bool> hasParent = parents();
        tree(hasParent);
        optionalIndex(model_.defaultScene, model_.scenes.size(), "scene");
        for (std::size_t i = 0; i < model_.scenes.size(); ++i)
            scene(model_.scenes[i], at("scenes", i, ".nodes"), hasParent);
    }

private:
    [[noreturn]] void fail(const std::string& path, const Message& problem) const
    {
        throw document_.failure(path, message("{1}; export the file again.", problem));
    }
    void index(int i, std::size_t size, const std::string& path) const
    {
        if (i < 0 || static_cast<std::size_t>(i) >= size)
            fail(path, message("{1} names nothing: there are {2}", i, size));
    }
    void optionalIndex(int i, std::size_t size, const std::string& path) const
    {
        if (i != -1) index(i, size, path);
    }
    void finite(const std::vector<double>& numbers, std::size_t size, const std::string& path) const
    {
        if (!numbers.empty() && numbers.size() != size) fail(path, message("this must be {1} numbers", size));
        for (const double x : numbers) {
            if (!std::isfinite(x)) fail(path, message("this is not a finite number"));
        }
    }

    /// Checks that `count` elements of `size` bytes, `stride` apart, from `offset` on, lie inside the view.
    void inside(int view, std::uint64_t offset, std::uint64_t stride, std::uint64_t count, std::uint64_t size,
                const std::string& path) const
    {
        const std::uint64_t length = model_.bufferViews[static_cast<std::size_t>(view)].byteLength;
        std::uint64_t end = 0;
        const bool overflow = __builtin_mul_overflow(stride, count - 1, &end) ||
                              __builtin_add_overflow(end, offset, &end) || __builtin_add_overflow(end, size, &end);
        if (overflow || end > length)
            fail(path, message("its elements reach beyond the buffer view, which has {1} bytes", length));
    }

    void view(std::size_t i) const
    {
        const tinygltf::BufferView& v = model_.bufferViews[i];
        index(v.buffer, model_.buffers.size(), at("bufferViews", i, ".buffer"));
        const std::uint64_t size = model_.buffers[static_cast<std::size_t>(v.buffer)].data.size();
        if (v.byteLength < 1 || v.byteOffset > size || v.byteLength > size - v.byteOffset) {
            fail(at("bufferViews", i, ".byteLength"),
                 message("this view reaches beyond its buffer, which has {1} bytes", size));
        }
        if (v.byteStride != 0 && (v.byteStride < 4 || v.byteStride > 252)) {
            fail(at("bufferViews", i, ".byteStride"), message("a stride must be 4 to 252"));
        }
    }

    void accessor(std::size_t i) const
    {
        const tinygltf::Accessor& a = model_.accessors[i];
        const std::uint64_t size = elementBytes(a);
        if (size == 0)
            fail(at("accessors", i, ".componentType"), message("its type or component type is none of glTF's"));
        if (a.count < 1 || a.count > limits_.indices) {
            fail(at("accessors", i, ".count"), message("this must be 1 to {1}", limits_.indices));
        }
        optionalIndex(a.bufferView, model_.bufferViews.size(), at("accessors", i, ".bufferView"));
        if (a.bufferView >= 0) {
            const std::uint64_t stride = model_.bufferViews[static_cast<std::size_t>(a.bufferView)].byteStride;
            if (stride != 0 && stride < size)
                fail(at("accessors", i, ".bufferView"), message("its stride is smaller than an element"));
            inside(a.bufferView, a.byteOffset, stride != 0 ? stride : size, a.count, size,
                   at("accessors", i, ".count"));
        }
        if (a.sparse.isSparse) sparse(i, a, size);
    }

    void sparse(std::size_t i, const tinygltf::Accessor& a, std::uint64_t size) const
    {
        const std::string path = at("accessors", i, ".sparse");
        const auto& s = a.sparse;
        if (s.count < 1 || static_cast<std::size_t>(s.count) > a.count)
            fail(path + ".count", message("this must be 1 to the accessor's count"));
        const int type = s.indices.componentType;
        if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
            type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
            fail(path + ".indices.componentType", message("sparse indices must be unsigned integers"));
        }
        index(s.indices.bufferView, model_.bufferViews.size(), path + ".indices.bufferView");
        index(s.values.bufferView, model_.bufferViews.size(), path + ".values.bufferView");
        // tinygltf 2.9 reads a negative offset as 0, so the JSON itself is checked.
        const Json& written = document_.root().at("accessors").at(i).at("sparse");
        for (const char* part : {"indices", "values"}) {
            const auto offset = written.at(part).find("byteOffset");
            if (offset != written.at(part).end() && offset->is_number() && offset->get<double>() < 0)
                fail(path + '.' + part + ".byteOffset", message("this must not be negative"));
        }
        const auto count = static_cast<std::uint64_t>(s.count);
        const auto indexBytes =
            static_cast<std::uint64_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
        inside(s.indices.bufferView, static_cast<std::uint64_t>(s.indices.byteOffset), indexBytes, count, indexBytes,
               path + ".indices");
        inside(s.values.bufferView, static_cast<std::uint64_t>(s.values.byteOffset), size, count, size,
               path + ".values");
        std::int64_t last = -1;
        for (const std::uint32_t position : readSparsePositions(model_, a)) {
            if (position <= last || position >= a.count)
                fail(path + ".indices", message("these must rise and stay below the accessor's count"));
            last = position;
        }
    }

    void material(std::size_t i) const
    {
        const tinygltf::Material& m = model_.materials[i];
        const auto& pbr = m.pbrMetallicRoughness;
        const std::size_t textures = model_.textures.size();
        optionalIndex(pbr.baseColorTexture.index, textures,
                      at("materials", i, ".pbrMetallicRoughness.baseColorTexture.index"));
        optionalIndex(pbr.metallicRoughnessTexture.index, textures,
                      at("materials", i, ".pbrMetallicRoughness.metallicRoughnessTexture.index"));
        optionalIndex(m.normalTexture.index, textures, at("materials", i, ".normalTexture.index"));
        optionalIndex(m.occlusionTexture.index, textures, at("materials", i, ".occlusionTexture.index"));
        optionalIndex(m.emissiveTexture.index, textures, at("materials", i, ".emissiveTexture.index"));
        finite(pbr.baseColorFactor, 4, at("materials", i, ".pbrMetallicRoughness.baseColorFactor"));
        finite(m.emissiveFactor, 3, at("materials", i, ".emissiveFactor"));
        finite({pbr.metallicFactor, pbr.roughnessFactor, m.alphaCutoff, m.normalTexture.scale,
                m.occlusionTexture.strength},
               5, at("materials", i));
    }

    void mesh(std::size_t i)
    {
        for (std::size_t p = 0; p < model_.meshes[i].primitives.size(); ++p) {
            if (++primitives_ > limits_.primitives)
                fail(at("meshes", i), message("there are more than {1} primitives", limits_.primitives));
            primitive(model_.meshes[i].primitives[p], at("meshes", i, at(".primitives", p)));
        }
    }

    void primitive(const tinygltf::Primitive& p, const std::string& path)
    {
        optionalIndex(p.material, model_.materials.size(), path + ".material");
        optionalIndex(p.indices, model_.accessors.size(), path + ".indices");
        std::size_t vertices = 0;
        for (const auto& [name, accessor] : p.attributes) {
            index(accessor, model_.accessors.size(), path + ".attributes." + name);
            const std::size_t count = model_.accessors[static_cast<std::size_t>(accessor)].count;
            if (vertices != 0 && count != vertices)
                fail(path + ".attributes." + name, message("its count differs from that of other attributes"));
            vertices = count;
        }
        // Counted per use: many primitives may share one accessor, but each gets its own vertices.
        if ((vertices_ += verticesMade(p, vertices)) > limits_.vertices) {
            fail(path, message("there are more than {1} vertices", limits_.vertices));
        }
        if (p.indices >= 0) indices(p.indices, vertices, path + ".indices");
    }

    /// Returns the number of vertices after conversion. Flat normals give each triangle three vertices of its own;
    /// strips and fans use each vertex up to three times.
    std::uint64_t verticesMade(const tinygltf::Primitive& p, std::uint64_t vertices) const
    {
        if (p.attributes.contains("NORMAL")) return vertices;
        const std::uint64_t corners =
            p.indices >= 0 ? model_.accessors[static_cast<std::size_t>(p.indices)].count : vertices;
        return std::max(vertices, p.mode > TINYGLTF_MODE_TRIANGLES ? 3 * corners : corners);
    }

    void indices(int accessor, std::size_t vertices, const std::string& path)
    {
        const tinygltf::Accessor& a = model_.accessors[static_cast<std::size_t>(accessor)];
        const bool isUnsigned = a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (a.type != TINYGLTF_TYPE_SCALAR || !isUnsigned) fail(path, message("indices must be unsigned integers"));
        if ((indices_ += a.count) > limits_.indices)
            fail(path, message("there are more than {1} indices", limits_.indices));
        const std::vector<std::uint32_t> values = readIndices(model_, accessor);
        if (*std::max_element(values.begin(), values.end()) >= vertices) {
            fail(path, message("one of them names a vertex beyond the {1} that there are", vertices));
        }
    }

    void node(std::size_t i) const
    {
        const tinygltf::Node& n = model_.nodes[i];
        optionalIndex(n.mesh, model_.meshes.size(), at("nodes", i, ".mesh"));
        for (const int child : n.children) index(child, model_.nodes.size(), at("nodes", i, ".children"));
        finite(n.matrix, 16, at("nodes", i, ".matrix"));
        finite(n.translation, 3, at("nodes", i, ".translation"));
        finite(n.rotation, 4, at("nodes", i, ".rotation"));
        finite(n.scale, 3, at("nodes", i, ".scale"));
    }

    /// Returns which nodes have a parent. Throws if one has two.
    std::vector<bool> parents() const
    {
        std::vector<bool> hasParent(model_.nodes.size(), false);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            for (const int child : model_.nodes[i].children) {
                const auto c = static_cast<std::size_t>(child);
                if (hasParent[c]) fail(at("nodes", i, ".children"), message("node {1} has two parents", child));
                hasParent[c] = true;
            }
        }
        return hasParent;
    }

    /// Checks that every node is reachable from a root and no deeper than allowed. As each has at most one parent,
    /// there are then no cycles.
    void tree(const std::vector<bool>& hasParent) const
    {
        struct Place {
            std::size_t node;
            std::uint64_t depth;
        };
        std::vector<Place> open;
        for (std::size_t i = 0; i < hasParent.size(); ++i) {
            if (!hasParent[i]) open.push_back({i, 1});
        }
        std::size_t reached = 0;
        while (!open.empty()) {
            const Place place = open.back();
            open.pop_back();
            ++reached;
            if (place.depth > limits_.nodeDepth) {
                fail(at("nodes", place.node), message("nodes are nested more than {1} deep", limits_.nodeDepth));
            }
            for (const int child : model_.nodes[place.node].children)
                open.push_back({static_cast<std::size_t>(child), place.depth + 1});
        }
        if (reached != model_.nodes.size()) fail("nodes", message("some nodes are their own ancestors"));
    }

    /// Checks that a scene names roots, each once. Its conversion then visits every node at most once.
    void scene(const tinygltf::Scene& s, const std::string& path, const std::vector<bool>& hasParent) const
    {
        std::vector<bool> named(model_.nodes.size(), false);
        for (const int n : s.nodes) {
            index(n, model_.nodes.size(), path);
            const auto i = static_cast<std::size_t>(n);
            if (hasParent[i]) fail(path, message("node {1} is not a root", n));
            if (named[i]) fail(path, message("node {1} is named twice", n));
            named[i] = true;
        }
    }

    const tinygltf::Model& model_;
    const JsonDocument& document_;
    const GltfLimits& limits_;
    std::uint64_t primitives_ = 0;
    std::uint64_t vertices_ = 0;
    std::uint64_t indices_ = 0;
};

}  // namespace

void validateGltf(const tinygltf::Model& model, const JsonDocument& document, const GltfLimits& limits)
{
    Validator(model, document, limits).validate();
}

}  // namespace vitrine::render
