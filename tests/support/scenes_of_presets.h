#pragma once

#include "exhibits/framework/files/preset.h"
#include "render/files/read_file.h"
#include "tests/support/museum_on_paper.h"

#include <filesystem>
#include <map>
#include <string>

namespace vitrine::test {

/// Returns all shipped presets by name ("sdf_morph/glass"), seen from their own camera or the exhibit's best view.
inline std::map<std::string, Scene> scenesOfPresets()
{
    namespace fs = std::filesystem;
    const fs::path presetsFolder = fs::path(VITRINE_SOURCE_DIR) / "assets" / "presets";
    std::map<std::string, Scene> scenes;
    for (std::size_t i = 0; i < museum().subjects().size(); ++i) {
        const SceneObject& subject = museum().subject(i);
        const fs::path folder = presetsFolder / subject.name();
        if (!fs::is_directory(folder)) continue;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() != ".json") continue;
            const Preset preset = parsePreset(render::readFile(entry.path(), presetLimits.bytes), entry.path().string(),
                                              subject.name(), subject.parameters());
            Scene scene;
            scene.sceneState.values[i] = preset.values;
            scene.see(preset.camera.value_or(museum().bestView(i, preset.values)));
            scenes.emplace(std::string(subject.name()) + '/' + entry.path().stem().string(), std::move(scene));
        }
    }
    return scenes;
}

}  // namespace vitrine::test
