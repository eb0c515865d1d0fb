#pragma once

#include "exhibits/sdf_scenes/near_scene.h"
#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "render/plan/frame_plan.h"

#include <memory>
#include <string>

namespace vitrine::scenes {

/// How a picture asks a scene's field: its shader's text, and the numbers that this reads.
struct AskedScene {
    std::shared_ptr<const render::ShaderSources> sources;
    std::vector<render::BufferUse> buffers;
    bool numbersInBlock = false;            ///< `sceneBlock` comes before the stage.
    std::shared_ptr<const NearScene> near;  ///< Null where every place asks every shape by name.
    std::string why;                        ///< For the ledger, where what is near is not known: why not.
    /// The same as `sources` with numbers folded, for the same inputs; null where that is of no use.
    std::shared_ptr<const render::ShaderSources> folded;
    std::string whyNotFolded;  ///< For the ledger, where that is null.
};

/// What of a scene's numbers has not changed for a while.
enum class SceneRest : std::uint8_t {
    nothing,
    all,
    steady  ///< All that do not depend on the time.
};

/// Whether lists can walk the scene: trees that are nested very deep have more levels than the shader has registers.
[[nodiscard]] bool hasLists(const ListVocabulary&);

/// By the way that is asked for, or the one that serves best. What takes time is made in the store, once for the same
/// numbers; while it is pending, every shape is asked.
[[nodiscard]] AskedScene askedScene(const ShownScene&, const SceneWords&, SceneEvaluation, SceneRest,
                                    render::AssetStore&);

}  // namespace vitrine::scenes
