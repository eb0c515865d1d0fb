#include "render/scene/gltf_sources.h"
#include "render/scene/gltf_compression.h"
#include "render/scene/gltf_schema.h"

#include "render/failure.h"
#include "render/files/read_file.h"

#include <algorithm>
#include <optional>

namespace vitrine::render {
namespace {

using FileBytes = std::vector<unsigned char>;

std::string textAt(const Json& object, const char* key)
{
    const auto at = object.find(key);
    return at == object.end() ? std::string() : at->get<std::string>();
}

int hexDigit(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// Returns the value of a base64 digit (RFC 4648, 4), or -1.
int base64Digit(char c)
{
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : (c == '/' ? 63 : -1);
}

/// Decodes base64; returns nothing if `text` is invalid. Padding may be missing.
std::optional<FileBytes> base64Decoded(std::string_view text)
{
    for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    FileBytes out;
    out.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int digit = base64Digit(c);
        if (digit < 0) return std::nullopt;
        bits = bits << 6U | static_cast<std::uint32_t>(digit);
        if ((held += 6) >= 8) out.push_back(static_cast<unsigned char>(bits >> static_cast<unsigned>(held -= 8)));
    }
    return out;
}

/// Returns the content of a data: URI (RFC 2397) of any media type.
FileBytes dataOf(const JsonDocument& document, const std::string& path, const std::string& uri)
{
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos)
        throw document.failure(path, message("a data: URI has a comma before its data; export the file again."));
    const std::string_view head = std::string_view(uri).substr(0, comma);
    const std::string_view data = std::string_view(uri).substr(comma + 1);
    const bool encoded = data.find('%') != std::string_view::npos;
    const std::string plain = encoded ? percentDecoded(data) : std::string();
    const std::string_view text = encoded ? std::string_view(plain) : data;
    if (!head.ends_with(";base64")) return {text.begin(), text.end()};
    std::optional<FileBytes> bytes = base64Decoded(text);
    if (!bytes) throw document.failure(path, message("this data: URI is not base 64; export the file again."));
    return std::move(*bytes);
}

FileBytes fileOf(const std::string& uri, const std::filesystem::path& folder, const GltfLimits& limits)
{
    const std::string bytes = readFileBeneath(folder, gltfReference(uri), limits.fileBytes, Reach::parent);
    return {bytes.begin(), bytes.end()};
}

/// Truncates the bytes to `length`. Throws if there are fewer.
FileBytes ofLength(const JsonDocument& document, const std::string& path, FileBytes bytes, std::size_t length)
{
    if (bytes.size() < length) {
        throw document.failure(
            path, message("the buffer has {1} bytes, fewer than its byteLength of {2}; export the file again.",
                          bytes.size(), length));
    }
    bytes.resize(length);
    return bytes;
}

}  // namespace

std::string percentDecoded(std::string_view uri)
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

std::string gltfReference(std::string_view uri)
{
    std::string path = percentDecoded(uri);
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

std::vector<tinygltf::Buffer> readBuffers(const JsonDocument& document, std::string_view bin,
                                          const std::filesystem::path& folder, const GltfLimits& limits,
                                          std::vector<Message>& warnings)
{
    const Json& rows = arrayAt(document, "buffers");
    std::vector<tinygltf::Buffer> buffers(rows.size());
    std::uint64_t zeros = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto length = rows[i].at("byteLength").get<std::size_t>();
        const std::string uri = textAt(rows[i], "uri");
        const std::string path = elementPath("buffers", i, uri.empty() ? "byteLength" : "uri");
        FileBytes& data = buffers[i].data;
        if (isFallbackBuffer(rows[i])) continue;
        if (uri.starts_with("data:")) {
            data = ofLength(document, path, dataOf(document, path, uri), length);
        } else if (!uri.empty()) {
            try {
                data = fileOf(uri, folder, limits);
            } catch (const Failure& failure) {
                throw document.failure(path, failure.message());
            }
            data = ofLength(document, path, std::move(data), length);
        } else if (i == 0 && !bin.empty()) {
            data = ofLength(document, path, FileBytes(bin.begin(), bin.end()), length);
        } else {
            if ((zeros += length) > limits.zeroBytes) {
                throw document.failure(
                    path,
                    message("the buffers without data are larger than {1} bytes; give them a uri.", limits.zeroBytes));
            }
            data.resize(length);
            warnings.push_back(message("Buffer {1} names no data; it is zeros.", i));
        }
    }
    return buffers;
}

std::vector<tinygltf::Image> readImages(const JsonDocument& document, const std::filesystem::path& folder,
                                        const GltfLimits& limits, std::vector<Message>& warnings)
{
    const Json& rows = arrayAt(document, "images");
    std::vector<tinygltf::Image> images(rows.size());
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        tinygltf::Image& image = images[i];
        image.name = textAt(rows[i], "name");
        const std::string uri = textAt(rows[i], "uri");
        const std::string path = elementPath("images", i, "uri");
        const auto view = rows[i].find("bufferView");
        if ((view != rows[i].end()) == !uri.empty())
            throw document.failure(path, message("a picture has either a uri or a bufferView; export the file again."));
        if (view != rows[i].end()) {
            image.bufferView = view->get<int>();  // Its bytes are read from the buffer after validation.
        } else if (uri.starts_with("data:")) {
            image.image = dataOf(document, path, uri);
        } else {
            image.uri = uri;
            if (const Message why = whyRefused(gltfReference(uri), Reach::parent); !why.empty())
                warnings.push_back(message("The reference to the picture {1} is not followed: {2}.", uri, why));
            try {
                image.image = fileOf(uri, folder, limits);
            } catch (const Failure&) {
                // The model is drawn without this picture. A material that uses the picture reports that it is missing.
            }
        }
        if ((total += image.image.size()) > limits.bufferBytes)
            throw document.failure(path, message("the pictures together are larger than {1} bytes; simplify the model.",
                                                 limits.bufferBytes));
    }
    return images;
}

}  // namespace vitrine::render
