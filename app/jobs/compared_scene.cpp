#include "app/jobs/compared_scene.h"

#include "app/kit/useless_option.h"
#include "exhibits/compare/differing_parameters.h"
#include "render/failure.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace vitrine::app {
namespace compared_scenes {
namespace {

/// Name in place of a file: the initial values of all subjects.
constexpr const char* initialSettings = "initial";

/// Returns the first exhibit that differs; the hall if none does.
std::size_t differingExhibit(const SceneState& a, const SceneState& b)
{
    for (const compare::DifferingParameter& row : compare::differingParameters(a, b))
        if (row.subject != hallIndex) return row.subject;
    return hallIndex;
}

RequestedPicture requestedSide(const Museum& museum, const PictureOptions& options, const std::string& settings,
                               std::vector<std::string>& notes)
{
    PictureOptions one = options;
    one.settingsOnly = true;
    one.preset = settings == initialSettings ? "" : settings;
    RequestedPicture side = requestedPicture(museum, one);
    notes.insert(notes.end(), side.notes.begin(), side.notes.end());
    return side;
}

/// Returns the settings from which the comparison starts, or those that are named.
RequestedPicture requestedA(const Museum& museum, const PictureOptions& options, const std::string& settings,
                            const ComparedStart& start, std::vector<std::string>& notes)
{
    if (!settings.empty()) return requestedSide(museum, options, settings, notes);
    if (start.like)
        return requestedPicture(museum, options, start.like->scene, start.like->scene.camera, start.like->taken);
    if (start.state) return requestedPicture(museum, options, *start.state, std::nullopt);
    throw Failure(ErrorKind::usage, "`vitrine compare-settings` needs a; `vitrine compare-settings --help` says what "
                                    "it is.");
}

/// Returns the camera of both pictures: as the options say, else that of the first settings that have one, else the
/// best view of the named exhibit, or of the first one in which A and B differ.
render::Camera sharedCamera(const Museum& museum, const PictureOptions& options, const RequestedPicture& a,
                            const std::optional<RequestedPicture>& b)
{
    render::Camera camera = a.request.frame.camera;
    if (!a.cameraFromPreset && b && b->cameraFromPreset) {
        camera = b->request.frame.camera;
    } else if (!a.cameraFromPreset && a.subject == hallIndex && b) {
        const std::size_t exhibit = differingExhibit(a.sceneState, b->sceneState);
        if (exhibit != hallIndex) camera = museum.bestView(exhibit, a.sceneState.values[exhibit]);
    }
    setCamera(options, camera);
    return camera;
}

/// Returns names for people: those of the files, or whole paths if the files have one name.
std::array<std::string, 2> namesOf(const std::array<std::string, 2>& settings)
{
    std::array<std::string, 2> names;
    for (std::size_t i = 0; i < 2; ++i) names[i] = std::filesystem::path(settings[i]).filename().string();
    return names[0] == names[1] ? settings : names;
}

}  // namespace
}  // namespace compared_scenes

void addComparedOptions(CLI::App& command, PictureOptions& options, std::array<std::string, 2>& settings)
{
    const std::string what = "A preset, an exhibition, a picture that carries one, or \"initial\"";
    command.add_option("a", settings[0], what + "; an exhibit's name for its initial values");
    command.add_option("b", settings[1], what);
    command.add_option("--exhibit", options.subject, "Exhibit whose presets can be given by name as A and B");
    addCameraOptions(command, options);
}

jobs::JobScene comparedScene(const CLI::App& command, const Museum& museum, const PictureOptions& typed,
                             const std::array<std::string, 2>& typedSettings, const ComparedStart& start,
                             std::vector<std::string>& notes)
{
    using namespace compared_scenes;
    PictureOptions options = typed;
    std::array<std::string, 2> settings = typedSettings;
    if (museum.find(settings[0])) {
        refuseOn(command, "--exhibit", !typed.subject.empty() && typed.subject != settings[0],
                 "an exhibit that is named as A");
        options.subject = settings[0];
        settings[0] = initialSettings;
    }
    if (options.subject.empty())
        options.subject = start.like && !start.like->chosen.empty() ? start.like->chosen : "hall";
    RequestedPicture a = requestedA(museum, options, settings[0], start, notes);
    std::optional<RequestedPicture> b;
    if (!settings[1].empty()) b = requestedSide(museum, options, settings[1], notes);
    const bool isLike = start.like && start.like->other && !b && !start.offered;

    jobs::JobScene scene{&museum, a.sceneState, a.subject, a.request.frame};
    if (start.offered && a.subject == hallIndex) {
        const SceneState initial = museum.readTables(museum.initialSceneState()).sceneState;
        scene.subject = differingExhibit(scene.state, initial);
        if (!a.cameraFromPreset && scene.subject != hallIndex)
            a.request.frame.camera = museum.bestView(scene.subject, scene.state.values[scene.subject]);
    }
    scene.frame.camera = scene.state.camera = sharedCamera(museum, options, a, b);
    std::array<std::string, 2> names = namesOf(settings);
    if (names[0].empty()) names[0] = start.like ? start.like->name : "A";
    scene.name = names[0];
    if (b) scene.other = jobs::OtherSettings{std::move(b->sceneState), names[1]};
    if (isLike)
        scene.other =
            jobs::OtherSettings{museum.readTables(start.like->other->state).sceneState, start.like->other->name};
    if (scene.other) scene.other->state.camera = scene.frame.camera;
    return scene;
}

}  // namespace vitrine::app
