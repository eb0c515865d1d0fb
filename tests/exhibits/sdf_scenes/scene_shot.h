#pragma once

#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace vitrine::test {

/// Shot of a scene alone, from its own camera: linear, with depth and normals.
struct SceneShot : ExhibitShot<scenes::SdfScenesTable> {
    explicit SceneShot(const std::filesystem::path& file = {}) : ExhibitShot("sdf_scenes")
    {
        sceneState = museum.get().initialSceneState();  // With the hall's haze.
        useSmallMaps(hall(), 256);
        size(96, 64);
        if (!file.empty()) values().set(table().scene, file.string());
        read();
    }
    /// Reads the named file. Returns the sentences on unreadable files.
    std::vector<Message> read()
    {
        TabledSceneState tabled = museum.get().readTables(sceneState);
        sceneState = std::move(tabled.sceneState);
        request.frame.camera = museum.get().exhibit(exhibit).bestView(values());
        return tabled.unreadable;
    }
    /// Sets a parameter of the scene.
    SceneShot& set(std::string_view name, double value)
    {
        values().setParameter(values().table().find(name).value(), value);
        return *this;
    }
    [[nodiscard]] const scenes::ShownScene& shown()
    {
        return *static_cast<const scenes::SdfScenesTable&>(values().table()).shown;
    }
    /// Returns the evaluator of the shown scene.
    [[nodiscard]] scenes::SceneField field()
    {
        std::vector<double> own;
        for (const Real& row : static_cast<const scenes::SdfScenesTable&>(values().table()).ofScene)
            own.push_back(values()[row]);
        return scenes::SceneField(shown().scene, values()[table().moment], own);
    }
    /// Returns the transform to the scene's own space from the exhibit's, which is the world's if it is alone.
    [[nodiscard]] glm::dmat4 sceneFromWorld()
    {
        const scenes::Scene& scene = *shown().scene;
        const scenes::SceneCamera camera = scenes::sceneCamera(scene, scene.numbersAt(0), 0);
        return scenes::scenePortal(camera, shown().toOpening).workFromExhibit;
    }
};

inline const scenes::SdfScenesTable& scenesTable()
{
    return SceneShot::table();
}

inline std::filesystem::path shippedScene(const std::string& name)
{
    return std::filesystem::path(VITRINE_SOURCE_DIR) / "assets/scenes" / (name + ".json");
}

/// Writes a scene file with this root; `head` are further members, each followed by a comma.
inline std::filesystem::path writeScene(const TemporaryFolder& folder, const std::string& root,
                                        const std::string& head = "", const std::string& name = "scene.json")
{
    const std::filesystem::path path = folder / name;
    std::ofstream(path) << "{\"format\": \"vitrine-scene\", \"version\": 1,\n" + head + "\n\"root\": " + root + "\n}\n";
    return path;
}

}  // namespace vitrine::test
