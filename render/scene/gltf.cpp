#include "render/scene/gltf.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/scene/gltf_convert.h"
#include "render/scene/gltf_guard.h"
#include "render/scene/gltf_validate.h"
#include "render/scene/tinygltf.h"

#include <exception>

namespace vitrine::render {
namespace {

/// What tinygltf's callbacks may touch.
struct Sources {
    std::filesystem::path folder;
    const GltfLimits& limits;
    std::uint64_t packedImageBytes = 0;
};

/// tinygltf tries "" and "." as folders: both mean ours.
std::string_view withoutDot(const std::string& path)
{
    std::string_view reference = path;
    while (reference.starts_with("./")) reference.remove_prefix(2);
    return reference;
}

bool fileExists(const std::string& path, void* /*sources*/)
{
    return whyRefused(withoutDot(path)).empty();  // Reading it will tell.
}

std::string expandPath(const std::string& path, void* /*sources*/)
{
    return path;
}

bool readWholeFile(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* context)
{
    const auto& sources = *static_cast<const Sources*>(context);
    try {
        const std::string bytes = readFileBeneath(sources.folder, withoutDot(path), sources.limits.fileBytes);
        out->assign(bytes.begin(), bytes.end());
        return true;
    } catch (const std::exception& e) {
        if (error) *error += e.what();
        return false;
    }
}

/// tinygltf 2.9 takes callbacks only where none is missing, though it writes nothing here, and readWholeFile knows the limit.
bool writeNothing(std::string* /*error*/, const std::string& /*path*/, const std::vector<unsigned char>& /*bytes*/, void* /*sources*/)
{
    return false;
}

bool withinTheLimit(std::size_t* bytes, std::string* /*error*/, const std::string& /*path*/, void* /*sources*/)
{
    *bytes = 0;
    return true;
}

/// By name, as versions differ: 2.7 (Debian 12) has no callback for sizes.
template <typename Callbacks> Callbacks callbacksFor(Sources& sources)
{
    Callbacks callbacks{};
    callbacks.FileExists = &fileExists;
    callbacks.ExpandFilePath = &expandPath;
    callbacks.ReadWholeFile = &readWholeFile;
    callbacks.WriteWholeFile = &writeNothing;
    if constexpr (requires { callbacks.GetFileSizeInBytes; }) callbacks.GetFileSizeInBytes = &withinTheLimit;
    callbacks.user_data = &sources;
    return callbacks;
}

/// Keeps the packed bytes; nothing is decoded here.
bool keepImage(tinygltf::Image* image, const int /*index*/, std::string* error, std::string* /*warning*/, int /*width*/,
               int /*height*/, const unsigned char* bytes, int size, void* context)
{
    // tinygltf does not check where a buffer view lies: those bytes are taken after validation.
    if (image->bufferView >= 0) return true;
    auto& sources = *static_cast<Sources*>(context);
    sources.packedImageBytes += static_cast<std::uint64_t>(std::max(size, 0));
    if (size < 0 || sources.packedImageBytes > sources.limits.bufferBytes) {
        if (error) *error += "the pictures are too large";
        return false;
    }
    image->image.assign(bytes, bytes + size);
    return true;
}

tinygltf::Model parse(const std::string& bytes, const std::string& name, Sources& sources)
{
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks(callbacksFor<tinygltf::FsCallbacks>(sources));
    loader.SetImageLoader(&keepImage, &sources);
    loader.SetImageWriter(nullptr, nullptr);
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const auto size = static_cast<unsigned int>(bytes.size());  // At most limits.fileBytes, below 2^32.
    bool good = false;
    try {
        good = isGlb(bytes)
                   ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                 reinterpret_cast<const unsigned char*>(bytes.data()), size, "")
                   : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
    } catch (const std::exception& e) {
        good = false;
        error = e.what();
    } catch (...) {
        good = false;
        error = "unknown error";
    }
    if (!good) {
        while (!error.empty() && (error.back() == '\n' || error.back() == '.')) error.pop_back();
        throw Failure(Blame::file,
                      "Cannot read " + name + ": " + (error.empty() ? "it is not glTF" : error) + "; export it again.");
    }
    return model;
}

}  // namespace

Model parseGltf(const std::string& bytes, const std::filesystem::path& path, const GltfLimits& limits,
                const std::function<bool()>& cancelled)
{
    const std::string name = path.string();
    if (bytes.size() > std::min<std::uint64_t>(limits.fileBytes, 0x7FFFFFFF)) {
        throw Failure(Blame::file, "Cannot read " + name + ": the file is too large; simplify the model.");
    }
    const JsonDocument document = guardGltf(bytes, name, limits);
    Sources sources{path.has_parent_path() ? path.parent_path() : std::filesystem::path("."), limits};
    const tinygltf::Model gltf = parse(bytes, name, sources);
    validateGltf(gltf, document, limits);
    return convertGltf(gltf, document, limits, cancelled);
}

Model loadGltf(const std::filesystem::path& path, const GltfLimits& limits, const std::function<bool()>& cancelled)
{
    return parseGltf(readFile(path, limits.fileBytes), path, limits, cancelled);
}

}  // namespace vitrine::render
