#include "render/scene/gltf_guard.h"

#include "render/files/read_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace vitrine::render {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& problem)
{
    throw Failure(Blame::file, "Cannot read " + name + ": " + problem + "; export it again.");
}

std::uint64_t littleEndian32(const std::string& bytes, std::size_t at)
{
    std::uint64_t x = 0;
    for (std::size_t i = 4; i > 0; --i) x = x << 8U | static_cast<unsigned char>(bytes[at + i - 1]);
    return x;
}

/// The JSON chunk of a container whose lengths all agree.
std::string jsonChunk(const std::string& bytes, const std::string& name)
{
    constexpr std::uint64_t json = 0x4E4F534A;
    constexpr std::uint64_t bin = 0x004E4942;
    const std::uint64_t size = bytes.size();
    if (size < 20) fail(name, "it is too short for a GLB container");
    if (littleEndian32(bytes, 4) != 2) fail(name, "it is not of glTF version 2");
    if (littleEndian32(bytes, 8) != size) fail(name, "its header gives another length than the file has");
    const std::uint64_t jsonLength = littleEndian32(bytes, 12);
    if (littleEndian32(bytes, 16) != json) fail(name, "its first chunk is not JSON");
    if (20 + jsonLength > size || jsonLength % 4 != 0) fail(name, "its JSON chunk does not fit the file");
    const std::uint64_t next = 20 + jsonLength;
    if (next < size) {
        if (next + 8 > size) fail(name, "something other than a chunk follows its JSON");
        const std::uint64_t binLength = littleEndian32(bytes, next);
        if (littleEndian32(bytes, next + 4) != bin) fail(name, "its second chunk is not BIN");
        if (next + 8 + binLength > size || binLength % 4 != 0) fail(name, "its BIN chunk does not fit the file");
        if (next + 8 + binLength < size) fail(name, "something follows its BIN chunk");
    }
    std::string text = bytes.substr(20, jsonLength);
    while (!text.empty() && text.back() == ' ') text.pop_back();  // Padding.
    return text;
}

const Json& arrayAt(const JsonDocument& document, const char* key)
{
    static const Json none = Json::array();
    const auto at = document.root().find(key);
    if (at == document.root().end()) return none;
    if (!at->is_array()) throw document.failure(key, "this must be an array; export the file again.");
    return *at;
}

std::string element(const char* array, std::size_t i, const char* key)
{
    std::string path = array;
    ((path += '[') += std::to_string(i)) += ']';
    if (*key != '\0') (path += '.') += key;
    return path;
}

/// A whole number that is not negative, `absent` when the key is not there.
std::uint64_t wholeNumber(const JsonDocument& document, const char* array, std::size_t i, const char* key,
                          std::optional<std::uint64_t> absent)
{
    const Json& object = arrayAt(document, array)[i];
    if (!object.is_object())
        throw document.failure(element(array, i, ""), "this must be an object; export the file again.");
    const auto at = object.find(key);
    if (at == object.end() && absent) return *absent;
    if (at == object.end() || !at->is_number_unsigned()) {
        throw document.failure(element(array, i, key), "this must be a whole number from 0 up; export the file again.");
    }
    return at->get<std::uint64_t>();
}

void checkCount(const JsonDocument& document, const char* array, std::uint64_t most)
{
    const std::size_t count = arrayAt(document, array).size();
    if (count > most) {
        throw document.failure(array, "there are " + std::to_string(count) + ", more than the " + std::to_string(most) +
                                          " allowed; simplify the model.");
    }
}

void checkBuffers(const JsonDocument& document, const GltfLimits& limits)
{
    std::vector<std::uint64_t> lengths;
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < arrayAt(document, "buffers").size(); ++i) {
        const std::uint64_t length = wholeNumber(document, "buffers", i, "byteLength", std::nullopt);
        if (length < 1) throw document.failure(element("buffers", i, "byteLength"), "a buffer cannot be empty.");
        // One at a time: the sum of two numbers below 2^31 cannot overflow.
        if (length > limits.bufferBytes || (total += length) > limits.bufferBytes) {
            throw document.failure(element("buffers", i, "byteLength"), "the buffers together are larger than " +
                                                                            std::to_string(limits.bufferBytes) +
                                                                            " bytes; simplify the model.");
        }
        lengths.push_back(length);
    }
    for (std::size_t i = 0; i < arrayAt(document, "bufferViews").size(); ++i) {
        const std::uint64_t buffer = wholeNumber(document, "bufferViews", i, "buffer", std::nullopt);
        const std::uint64_t offset = wholeNumber(document, "bufferViews", i, "byteOffset", 0);
        const std::uint64_t length = wholeNumber(document, "bufferViews", i, "byteLength", std::nullopt);
        if (buffer >= lengths.size())
            throw document.failure(element("bufferViews", i, "buffer"), "there is no such buffer.");
        if (length < 1) throw document.failure(element("bufferViews", i, "byteLength"), "a view cannot be empty.");
        if (offset > lengths[buffer] || length > lengths[buffer] - offset) {
            throw document.failure(element("bufferViews", i, "byteLength"), "this view reaches beyond its buffer.");
        }
    }
}

int hexDigit(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percentDecoded(const std::string& uri)
{
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        if (low < 0) {
            out += uri[i];
            continue;
        }
        out += static_cast<char>(16 * high + low);
        i += 2;
    }
    return out;
}

void checkReferences(const JsonDocument& document, const char* array)
{
    for (std::size_t i = 0; i < arrayAt(document, array).size(); ++i) {
        const Json& object = arrayAt(document, array)[i];
        if (!object.is_object())
            throw document.failure(element(array, i, ""), "this must be an object; export the file again.");
        const auto uri = object.find("uri");
        if (uri == object.end()) continue;
        if (!uri->is_string())
            throw document.failure(element(array, i, "uri"), "this must be text; export the file again.");
        const auto& text = uri->get_ref<const std::string&>();
        if (text.starts_with("data:")) continue;
        if (const std::string why = whyRefused(percentDecoded(text)); !why.empty()) {
            throw document.failure(element(array, i, "uri"),
                                   "this reference is refused because " + why +
                                       "; put the file beside the model and name it relatively.");
        }
    }
}

void checkExtensions(const JsonDocument& document)
{
    // Quantized vertices need nothing but the component types that the reader knows anyway.
    constexpr std::array<std::string_view, 2> known = {"KHR_materials_emissive_strength", "KHR_mesh_quantization"};
    const Json& required = arrayAt(document, "extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        const std::string name = required[i].is_string() ? required[i].get<std::string>() : "?";
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw document.failure(element("extensionsRequired", i, ""),
                                   "the file cannot be shown without " + name +
                                       ", which is not supported; export it without that.");
        }
    }
}

void checkStrings(const JsonDocument& document, const Json& json, const std::string& path, std::uint64_t most)
{
    if (json.is_string()) {
        const auto& text = json.get_ref<const std::string&>();
        if (text.size() > most && !text.starts_with("data:")) {
            throw document.failure(path, "this text is longer than " + std::to_string(most) + " bytes; shorten it.");
        }
    } else if (json.is_object()) {
        for (const auto& [key, value] : json.items()) {
            if (key.size() > most)
                throw document.failure(path, "one of its keys is longer than " + std::to_string(most) + " bytes.");
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

}  // namespace

bool isGlb(const std::string& bytes)
{
    return bytes.starts_with("glTF");
}

JsonDocument guardGltf(const std::string& bytes, const std::string& name, const GltfLimits& limits)
{
    JsonLimits json;
    json.bytes = limits.jsonBytes;
    json.stringBytes = limits.jsonBytes;
    JsonDocument document = parseJson(isGlb(bytes) ? jsonChunk(bytes, name) : bytes, name, json);
    if (!document.root().is_object()) fail(name, "its JSON is not an object");
    checkStrings(document, document.root(), {}, limits.stringBytes);
    checkExtensions(document);
    checkCount(document, "nodes", limits.nodes);
    checkCount(document, "images", limits.images);
    checkBuffers(document, limits);
    checkReferences(document, "buffers");
    checkReferences(document, "images");
    return document;
}

}  // namespace vitrine::render
