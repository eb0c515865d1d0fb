#include "exhibits/sdf_scenes/scene_document.h"

#include "exhibits/sdf_scenes/scene_reader.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "exhibits/sdf_scenes/source_scene.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/hash.h"

#include <algorithm>

namespace vitrine::scenes {
namespace {

std::shared_ptr<const SceneReading> readNow(const std::filesystem::path& path, const std::string& text)
{
    auto reading = std::make_shared<SceneReading>();
    const SceneLimits limits;
    const auto see = [&](const std::filesystem::path& file) {
        reading->files.push_back({file, render::fileState(file)});
    };
    if (text.empty()) see(path);
    try {
        ReadScene read = readScene(
            text.empty() ? render::readFile(path, limits.json.bytes) : text, path.string(),
            [&](const std::string& reference) {
                see(path.parent_path() / reference);
                return render::readFileBeneath(path.parent_path(), reference, limits.json.bytes);
            },
            limits);
        if (!read.scene) throw read.findings.front().failure();
        auto shown = std::make_shared<ShownScene>(*shownScene(std::move(read.scene), path));
        for (const SeenFile& file : reading->files)
            if (file.path != path) shown->included.push_back(file.path);
        for (const std::filesystem::path& picture : environmentFiles(*shown->scene, path)) see(picture);
        reading->table = std::make_shared<const SdfScenesTable>(std::move(shown));
    } catch (const Failure& failure) {
        reading->why = failure.message();
    }
    return reading;
}

/// Returns a hash of the state of the files that were read; 0 while they are unchanged.
std::uint64_t changesOf(const SceneReading& reading)
{
    render::Hash hash;
    bool same = true;
    for (const SeenFile& file : reading.files) {
        const render::FileState now = render::fileState(file.path);
        same = same && now == file.state;
        render::addTo(hash.add(file.path.string()), now);
    }
    return same ? 0 : std::max<std::uint64_t>(hash.value(), 1);
}

}  // namespace

std::shared_ptr<const SceneReading> readDocument(const std::filesystem::path& path, const std::string& text,
                                                 render::AssetStore& assets)
{
    using Made = render::AssetStore::Made<SceneReading>;
    const auto make = [&] {
        auto reading = readNow(path, text);
        const std::uint64_t words = reading->table ? reading->table->shown->program->wordCount() : 0;
        return Made{std::move(reading), 4096 + 64 * words + 4 * text.size()};
    };
    // The first reading determines the files. If one of these changed, a further reading has their states in its key,
    // and may use other files.
    std::string key = path.string() + '\n' + text;
    std::shared_ptr<const SceneReading> reading;
    for (int further = 0; further < 8; ++further) {
        const auto made = assets.made<SceneReading>("sdf_scenes.document", key, make);
        if (!made.value) return std::make_shared<const SceneReading>(SceneReading{nullptr, made.failure, {}});
        reading = made.value;
        const std::uint64_t changes = changesOf(*reading);
        if (changes == 0) break;
        key += '\n' + std::to_string(changes);
    }
    return reading;
}

bool isSceneText(const std::string& text)
{
    try {
        const render::JsonText json(text, "scene", SceneLimits().json);
        const auto format = json.member(0, "format");
        if (format) return json.written(*format) == '"' + std::string(sceneFormat) + '"';
        return isSourceScene(json);
    } catch (const Failure&) {
        return false;
    }
}

std::vector<std::string> filesBeside(const ShownScene& shown)
{
    std::vector<std::string> files;
    for (const std::filesystem::path& file : shown.included) files.push_back(file.string());
    for (const std::filesystem::path& picture : environmentFiles(*shown.scene, shown.path))
        files.push_back(picture.string());
    return files;
}

}  // namespace vitrine::scenes
