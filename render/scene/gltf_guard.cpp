#include "render/scene/gltf_guard.h"

#include "render/files/little_endian.h"
#include "render/files/read_file.h"
#include "render/scene/gltf_compression.h"
#include "render/scene/gltf_schema.h"
#include "render/scene/gltf_sources.h"

#include <algorithm>
#include <array>
#include <vector>

namespace vitrine::render {
namespace {

constexpr std::uint64_t jsonChunk = 0x4E4F534A;
constexpr std::uint64_t binChunk = 0x004E4942;

[[noreturn]] void fail(const std::string& name, const Message& problem)
{
    throw Failure(ErrorKind::file, message("Cannot read {1}: {2}; export it again.", name, problem));
}

/// Type and length of a chunk, and the offset of its first byte.
struct Chunk {
    std::uint64_t type = 0, first = 0, length = 0;
};

/// Returns the chunks of a container after checking all lengths. Chunks after the first two, of unknown type, are for
/// extensions.
std::vector<Chunk> chunksOf(const std::string& bytes, const std::string& name)
{
    const std::uint64_t size = bytes.size();
    if (size < 20) fail(name, message("it is too short for a GLB container"));
    if (littleEndian(bytes, 4) != 2) fail(name, message("it is not of glTF version 2"));
    if (littleEndian(bytes, 8) != size) fail(name, message("its header gives another length than the file has"));
    std::vector<Chunk> chunks;
    for (std::uint64_t next = 12; next < size;) {
        const Message after = chunks.empty()               ? message("its header")
                              : chunks.size() == 1         ? message("its JSON")
                              : chunks[1].type == binChunk ? message("its BIN chunk")
                                                           : message("its second chunk");
        if (next + 8 > size) fail(name, message("something follows {1} that is no chunk", after));
        const Chunk chunk{littleEndian(bytes, next + 4), next + 8, littleEndian(bytes, next)};
        const Message self = chunk.type == jsonChunk  ? message("JSON chunk")
                             : chunk.type == binChunk ? message("BIN chunk")
                                                      : message("chunk number {1}", chunks.size() + 1);
        // The length should be a multiple of four. Exporters that omit the padding still write valid data.
        if (chunk.first + chunk.length > size) fail(name, message("its {1} does not fit the file", self));
        chunks.push_back(chunk);
        next = chunk.first + chunk.length;
    }
    if (chunks[0].type != jsonChunk) fail(name, message("its first chunk is not JSON"));
    for (std::size_t i = 1; i < chunks.size(); ++i) {
        if (chunks[i].type == jsonChunk) fail(name, message("it has two JSON chunks"));
        if (i > 1 && chunks[i].type == binChunk) fail(name, message("its BIN chunk is not the second one"));
    }
    return chunks;
}

std::string jsonOf(const std::string& bytes, const std::string& name)
{
    const Chunk json = chunksOf(bytes, name).front();
    std::string text = bytes.substr(json.first, json.length);
    while (!text.empty() && text.back() == ' ') text.pop_back();  // Padding.
    // Some exporters pad with zeros, which only the BIN chunk should use: at most three, up to a multiple of 4.
    for (int i = 0; i < 3 && !text.empty() && text.back() == '\0'; ++i) text.pop_back();
    return text;
}

/// Returns a size that the schema check has validated; `absent` if the key is missing.
std::uint64_t sizeAt(const Json& object, const char* key, std::uint64_t absent = 0)
{
    const auto at = object.find(key);
    return at == object.end() ? absent : at->get<std::uint64_t>();
}

void checkCount(const JsonDocument& document, const char* array, std::uint64_t most)
{
    const std::size_t count = arrayAt(document, array).size();
    if (count > most) {
        throw document.failure(array,
                               message("there are {1}, more than the {2} allowed; simplify the model.", count, most));
    }
}

void checkBuffers(const JsonDocument& document, const GltfLimits& limits)
{
    std::vector<std::uint64_t> lengths;
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < arrayAt(document, "buffers").size(); ++i) {
        const std::uint64_t length = sizeAt(arrayAt(document, "buffers")[i], "byteLength");
        if (length < 1)
            throw document.failure(elementPath("buffers", i, "byteLength"), message("a buffer cannot be empty."));
        // Two checks, so that nothing overflows: the sum of two numbers below 2^31 is safe.
        if (length > limits.bufferBytes || (total += length) > limits.bufferBytes) {
            throw document.failure(
                elementPath("buffers", i, "byteLength"),
                message("the buffers together are larger than {1} bytes; simplify the model.", limits.bufferBytes));
        }
        lengths.push_back(length);
    }
    for (std::size_t i = 0; i < arrayAt(document, "bufferViews").size(); ++i) {
        const Json& view = arrayAt(document, "bufferViews")[i];
        const std::uint64_t buffer = sizeAt(view, "buffer");
        const std::uint64_t offset = sizeAt(view, "byteOffset");
        const std::uint64_t length = sizeAt(view, "byteLength");
        const std::uint64_t stride = sizeAt(view, "byteStride", 4);
        if (buffer >= lengths.size())
            throw document.failure(elementPath("bufferViews", i, "buffer"), message("there is no such buffer."));
        if (length < 1)
            throw document.failure(elementPath("bufferViews", i, "byteLength"), message("a view cannot be empty."));
        if (offset > lengths[buffer] || length > lengths[buffer] - offset) {
            throw document.failure(elementPath("bufferViews", i, "byteLength"),
                                   message("this view reaches beyond its buffer."));
        }
        if (stride < 4 || stride > 252 || stride % 4 != 0)
            throw document.failure(elementPath("bufferViews", i, "byteStride"),
                                   message("a stride is a multiple of 4 from 4 to 252; export the file again."));
    }
}

/// Checks the accessors. Elements without a view are zeros and cost the file nothing, so they have their own limit,
/// unless they are in compressed data.
void checkAccessors(const JsonDocument& document, const GltfLimits& limits)
{
    constexpr std::array<std::uint64_t, 6> componentTypes = {5120, 5121, 5122, 5123, 5125, 5126};
    constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    std::uint64_t zeros = 0;
    const Json& accessors = arrayAt(document, "accessors");
    const std::vector<bool> compressed = dracoAccessors(document);
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        const Json& accessor = accessors[i];
        const auto isOneOf = [](const auto& all, const auto& one) {
            return std::find(all.begin(), all.end(), one) != all.end();
        };
        if (!isOneOf(componentTypes, sizeAt(accessor, "componentType")) ||
            !isOneOf(types, accessor.at("type").get<std::string>()))
            throw document.failure(elementPath("accessors", i, "componentType"),
                                   message("its type or component type is none of glTF's; export the file again."));
        if (accessor.contains("bufferView") || compressed[i]) continue;
        const std::uint64_t mostElements = limits.zeroBytes / (16 * sizeof(float));
        const std::uint64_t count = sizeAt(accessor, "count");
        if (count > mostElements || (zeros += count) > mostElements)
            throw document.failure(
                elementPath("accessors", i, "count"),
                message("accessors without data have more than {1} elements; give them a bufferView.", mostElements));
    }
}

void checkReferences(const JsonDocument& document, const char* array)
{
    for (std::size_t i = 0; i < arrayAt(document, array).size(); ++i) {
        const Json& object = arrayAt(document, array)[i];
        const auto uri = object.find("uri");
        if (uri == object.end()) continue;
        const auto& text = uri->get_ref<const std::string&>();
        if (text.starts_with("data:")) continue;
        if (const Message why = whyRefused(gltfReference(text), Reach::parent); !why.empty()) {
            throw document.failure(
                elementPath(array, i, "uri"),
                message("this reference is refused because {1}; put the file beside the model and name it relatively.",
                        why));
        }
    }
}

void checkExtensions(const JsonDocument& document)
{
    const Json& required = arrayAt(document, "extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        const auto name = required[i].get<std::string>();
        if (!isDrawnExtension(name)) {
            throw document.failure(
                elementPath("extensionsRequired", i, ""),
                message("the file cannot be shown without {1}, which is not supported; export it without that.", name));
        }
    }
}

void checkStrings(const JsonDocument& document, const Json& json, const std::string& path, std::uint64_t most)
{
    if (json.is_string()) {
        const auto& text = json.get_ref<const std::string&>();
        if (text.size() > most && !text.starts_with("data:")) {
            throw document.failure(path, message("this text is longer than {1} bytes; shorten it.", most));
        }
    } else if (json.is_object()) {
        for (const auto& [key, value] : json.items()) {
            if (key.size() > most)
                throw document.failure(path, message("one of its keys is longer than {1} bytes.", most));
            std::string next = path;
            if (!next.empty()) next += '.';
            checkStrings(document, value, next += key, most);
        }
    } else if (json.is_array() && !json.empty() && !json.front().is_number()) {
        for (std::size_t i = 0; i < json.size(); ++i) {
            std::string next = path;
            ((next += '[') += std::to_string(i)) += ']';
            checkStrings(document, json[i], next, most);
        }
    }
}

/// Returns whether this can be a container or JSON, in any encoding. An array is accepted here, because it is refused
/// later with its own reason.
bool beginsAsGltf(const std::string& bytes)
{
    if (bytes.starts_with("glTF") || bytes.starts_with("\xEF\xBB\xBF") || bytes.starts_with("\xFF\xFE") ||
        bytes.starts_with("\xFE\xFF"))
        return true;
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first == std::string::npos || bytes[first] == '{' || bytes[first] == '[';
}

}  // namespace

bool isDrawnExtension(std::string_view name)
{
    // Quantized vertices use only component types that the reader supports anyway.
    constexpr std::array<std::string_view, 6> drawn{"EXT_meshopt_compression",         "KHR_draco_mesh_compression",
                                                    "KHR_materials_emissive_strength", "KHR_materials_unlit",
                                                    "KHR_mesh_quantization",           "KHR_texture_transform"};
    return std::find(drawn.begin(), drawn.end(), name) != drawn.end();
}

bool isGlb(const std::string& bytes)
{
    return bytes.starts_with("glTF");
}

std::string_view binOf(const std::string& bytes, const std::string& name)
{
    if (!isGlb(bytes)) return {};
    const std::vector<Chunk> chunks = chunksOf(bytes, name);
    if (chunks.size() < 2 || chunks[1].type != binChunk) return {};
    return std::string_view(bytes).substr(chunks[1].first, chunks[1].length);
}

JsonDocument guardGltf(const std::string& bytes, const std::string& name, const GltfLimits& limits)
{
    JsonLimits json;
    json.bytes = limits.jsonBytes;
    json.stringBytes = limits.jsonBytes;
    if (!beginsAsGltf(bytes))
        throw Failure(ErrorKind::file, message("Cannot read {1}: this is not a glTF file; choose another file.", name));
    JsonDocument document = parseJson(isGlb(bytes) ? jsonOf(bytes, name) : bytes, name, json);
    if (!document.root().is_object()) fail(name, message("its JSON is not an object"));
    checkStrings(document, document.root(), {}, limits.stringBytes);
    makeWholeNumbersIntegers(document.root());
    checkGltfSchema(document);
    if (const auto version = document.root()["asset"]["version"].get<std::string>(); !version.starts_with("2."))
        throw document.failure("asset.version",
                               message("this is glTF {1}, and version 2 is read; export it as glTF 2.0.", version));
    checkExtensions(document);
    checkCount(document, "nodes", limits.nodes);
    checkCount(document, "images", limits.images);
    checkBuffers(document, limits);
    checkAccessors(document, limits);
    checkReferences(document, "buffers");
    return document;
}

}  // namespace vitrine::render
