#include "exhibits/museum/lesson_scene.h"

#include "exhibits/museum/museum.h"

#include <utility>

namespace vitrine {

SceneState sceneOfStep(const Museum& museum, std::size_t exhibit, const LessonStep& step, SceneState before)
{
    SceneState state = std::move(before);
    state.values[exhibit] = step.values;
    for (const auto& [row, value] : step.hall) state.hall().setParameter(row, value);
    if (step.camera)
        state.camera = *step.camera;
    else if (step.bestView)
        state.camera = museum.bestView(exhibit, step.values);
    return state;
}

}  // namespace vitrine
