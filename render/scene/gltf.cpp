#include "render/scene/gltf.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/scene/gltf_compression.h"
#include "render/scene/gltf_convert.h"
#include "render/scene/gltf_guard.h"
#include "render/scene/gltf_sources.h"
#include "render/scene/gltf_validate.h"
#include "render/scene/tinygltf.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace vitrine::render {
namespace {

/// Returns `json` without extras and without extensions, except those of materials: no others are used.
Json drawnPart(const Json& json, bool inMaterial)
{
    if (json.is_array()) {
        Json out = Json::array();
        for (const Json& element : json) out.push_back(drawnPart(element, inMaterial));
        return out;
    }
    if (!json.is_object()) return json;
    Json out = Json::object();
    auto& members = out.get_ref<Json::object_t&>();  // The keys are known to be unique, so no search is needed.
    for (const auto& [key, value] : json.items()) {
        if (key == "extras" || (key == "extensions" && !inMaterial)) continue;
        members.emplace_back(key, key == "extensions" ? value : drawnPart(value, inMaterial));
    }
    return out;
}

/// Returns the JSON that tinygltf reads: without buffers and pictures, which are read here, and without content that is
/// never drawn.
std::string textForTinygltf(const Json& root)
{
    Json out = Json::object();
    for (const char* key : {"asset", "extensionsUsed", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews",
                            "textures", "samplers", "materials"})
        if (const auto at = root.find(key); at != root.end())
            out[key] = drawnPart(*at, std::string_view(key) == "materials");
    // tinygltf refuses indices without a view (zeros by the standard). They get a view while it reads.
    Json& views = out["bufferViews"];
    const std::size_t none = views.size();
    views.push_back({{"buffer", 0U}, {"byteLength", 1U}});
    if (const auto accessors = out.find("accessors"); accessors != out.end())
        for (Json& accessor : *accessors)
            if (!accessor.contains("bufferView")) accessor["bufferView"] = none;
    return out.dump();
}

tinygltf::Model parse(const JsonDocument& document)
{
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const std::string text = textForTinygltf(document.root());
    bool good = false;
    try {
        // The size is at most limits.jsonBytes, below 2^32.
        good = loader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned int>(text.size()),
                                          "");
    } catch (const std::exception& e) {
        error = e.what();
    } catch (...) {
        error = "unknown error";
    }
    if (!good) {
        while (!error.empty() && (error.back() == '\n' || error.back() == '.')) error.pop_back();
        if (error.empty())
            throw Failure(ErrorKind::file,
                          message("Cannot read {1}: it is not glTF; export it again.", document.name()));
        throw Failure(ErrorKind::file, message("Cannot read {1}: {2}; export it again.", document.name(), error));
    }
    model.bufferViews.pop_back();
    for (std::size_t i = 0; i < model.accessors.size(); ++i)
        if (!document.root()["accessors"][i].contains("bufferView")) model.accessors[i].bufferView = -1;
    return model;
}

}  // namespace

GltfFile readGltfFile(const std::string& bytes, const std::filesystem::path& path, const GltfLimits& limits)
{
    const std::string name = path.string();
    if (bytes.size() > std::min<std::uint64_t>(limits.fileBytes, 0x7FFFFFFF)) {
        throw Failure(ErrorKind::file, message("Cannot read {1}: the file is too large; simplify the model.", name));
    }
    JsonDocument document = guardGltf(bytes, name, limits);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    tinygltf::Model gltf = parse(document);
    std::vector<Message> warnings;
    gltf.buffers = readBuffers(document, binOf(bytes, name), folder, limits, warnings);
    gltf.images = readImages(document, folder, limits, warnings);
    decompress(gltf, document, limits);
    validateGltf(gltf, document, limits);
    return {std::move(document), std::move(gltf), std::move(warnings)};
}

Model parseGltf(const std::string& bytes, const std::filesystem::path& path, const GltfLimits& limits,
                const std::function<bool()>& canceled)
{
    const GltfFile file = readGltfFile(bytes, path, limits);
    Model model = convertGltf(file.gltf, file.document, limits, canceled);
    model.warnings.insert(model.warnings.end(), file.warnings.begin(), file.warnings.end());
    return model;
}

Model loadGltf(const std::filesystem::path& path, const GltfLimits& limits, const std::function<bool()>& canceled)
{
    return parseGltf(readFile(path, limits.fileBytes), path, limits, canceled);
}

Message whyNothingIsSeen(const std::string& name, const Box& bounds)
{
    if (bounds.empty())
        return message(
            "Nothing of {1} is to be seen: it has no triangles; choose another file, or export it with its meshes.",
            name);
    const glm::dvec3 size = bounds.high - bounds.low;
    if ((size.x > 0) + (size.y > 0) + (size.z > 0) >= 2) return {};
    return message(
        "Nothing of {1} is to be seen: it is scaled to a point or a line; export it with a scale other than 0.", name);
}

}  // namespace vitrine::render
