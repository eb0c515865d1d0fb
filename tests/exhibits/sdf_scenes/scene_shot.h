#pragma once

#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace vitrine::test {

inline const SdfScenesTable& scenesTable()
{
    static const SdfScenesTable table;
    return table;
}

/// Shot of a scene alone, from its own camera: linear, with depth and normals.
struct SceneShot {
    SceneState sceneState = gallery().museum.initialSceneState();
    PictureRequest request;
    std::size_t subject = *gallery().museum.find("sdf_scenes");

    explicit SceneShot(const std::filesystem::path& file = {})
    {
        useSmallMaps(sceneState.hall(), 256);
        seeAlone(request, subject);
        request.frame.raster.size = {96, 64};
        if (!file.empty()) values().set(scenesTable().scene, file.string());
        read();
    }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[subject]; }
    /// Reads the named file. Returns the sentences on unreadable files.
    std::vector<Message> read()
    {
        TabledSceneState tabled = gallery().museum.readTables(sceneState);
        sceneState = std::move(tabled.sceneState);
        request.frame.camera = gallery().museum.exhibit(subject).bestView(values());
        return tabled.unreadable;
    }
    /// Sets a parameter of the scene.
    SceneShot& set(std::string_view name, double value)
    {
        values().setRow(values().table().find(name).value(), value);
        return *this;
    }
    [[nodiscard]] const scenes::ShownScene& shown()
    {
        return *static_cast<const SdfScenesTable&>(values().table()).shown;
    }
    SceneShot& inHall()
    {
        request.frame.alone.reset();
        request.frame.subject = subject;
        request.frame.transparent = false;
        request.frame.camera = gallery().museum.bestView(subject, values());
        return *this;
    }
    [[nodiscard]] Picture take() const
    {
        PictureMaker maker(gallery().museum, gallery().renderer, sceneState, request);
        while (maker.step()) {
        }
        return {maker.picture(), render::makeView(request.frame.camera, request.frame.raster)};
    }
    /// Returns the evaluator of the shown scene.
    [[nodiscard]] scenes::SceneField field()
    {
        std::vector<double> own;
        for (const Real& row : static_cast<const SdfScenesTable&>(values().table()).ofScene)
            own.push_back(values()[row]);
        return scenes::SceneField(shown().scene, values()[scenesTable().moment], own);
    }
    /// Returns the transform to the scene's own space from the exhibit's, which is the world's if it is alone.
    [[nodiscard]] glm::dmat4 sceneFromWorld()
    {
        const scenes::Scene& scene = *shown().scene;
        const scenes::SceneCamera camera = scenes::sceneCamera(scene, scene.numbersAt(0), 0);
        return scenes::scenePortal(camera, shown().toOpening).workFromExhibit;
    }
};

/// Returns the ray through the center of a pixel (from the top left), with length 1 along the view axis.
inline glm::dvec3 rayOf(const render::View& view, int x, int y)
{
    const glm::dvec2 size(view.raster.size);
    return view.direction(glm::dvec2(x + 0.5, size.y - y - 0.5) / size * 2.0 - 1.0);
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
