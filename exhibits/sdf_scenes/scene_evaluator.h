#pragma once

#include "exhibits/sdf_scenes/scene_grid.h"
#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "render/plan/frame_plan.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// Shader source and buffers that evaluate a scene's SDF in one frame.
struct SceneEvaluator {
    std::shared_ptr<const render::ShaderSources> sources;
    std::vector<render::BufferUse> buffers;
    bool numbersInBlock = false;            ///< `sceneBlock` precedes the stage in the uniform block.
    std::shared_ptr<const SceneGrid> near;  ///< Null if every point evaluates every shape by its own code.
    std::string why;                        ///< Reason for the frame report if there is no acceleration grid.
    /// The same as `sources` with numbers folded as constants, for the same inputs; null if it brings nothing.
    std::shared_ptr<const render::ShaderSources> folded;
    std::string whyNotFolded;  ///< Reason for the frame report if that is null.
};

/// Returns the buffers that shaders/sdf_scenes/near.glsl reads.
[[nodiscard]] std::vector<render::BufferUse> buffersOf(const SceneGrid&);

/// Scene constants that are stable enough to be compiled into the shader.
enum class SceneRest : std::uint8_t {
    nothing,
    all,
    steady  ///< All constants that do not depend on the time.
};

/// Returns the evaluator for the requested method, or for the one that suits the scene best. Expensive parts are made
/// in the store, once for the same numbers. While they are pending, every shape is evaluated.
[[nodiscard]] SceneEvaluator sceneEvaluator(const ShownScene&, const SceneConstants&, SceneEvaluation, SceneRest,
                                            render::AssetStore&);

}  // namespace vitrine::scenes
