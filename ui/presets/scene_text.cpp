#include "ui/presets/scene_text.h"

#include "exhibits/framework/files/preset.h"

namespace vitrine::ui {
namespace {

std::size_t chosenIn(const Museum& museum, const SceneState& sceneState, const std::string& name)
{
    if (const auto found = museum.find(name)) return *found;
    FrameRequest request;
    request.camera = sceneState.camera;
    const std::optional<Pointed> middle =
        museum.surroundings().pick(museum.prepare(sceneState, request), request, {0, 0});
    return middle ? middle->exhibit : hallIndex;
}

}  // namespace

std::string textOf(const Museum& museum, const SceneState& sceneState, std::size_t chosen, const std::string& name)
{
    Exhibition everything;
    everything.name = name;
    everything.chosen = std::string(museum.subject(chosen).name());
    everything.camera = sceneState.camera;
    everything.values = namedValues(museum.subjects(), sceneState.values);
    return exhibitionText(everything);
}

SceneState lookFrom(const Museum& museum, std::string text, std::string fileName, std::vector<std::string>& notes,
                    std::size_t* chosen)
{
    SceneState sceneState = museum.initialSceneState();
    const NamedValues initial = namedValues(museum.subjects(), sceneState.values);
    Exhibition read = parseExhibition(std::move(text), std::move(fileName), initial);
    for (auto& [name, values] : read.values) {
        if (const auto at = museum.find(name)) sceneState.values[*at] = std::move(values);
    }
    sceneState.camera = read.camera;
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    if (chosen) *chosen = chosenIn(museum, sceneState, read.chosen);
    return sceneState;
}

}  // namespace vitrine::ui
