#pragma once

#include "exhibits/sdf_scenes/scene_program.h"
#include "render/plan/frame_plan.h"

namespace vitrine::bench {

/// Makes a pass of a scene ask its field as the source does: every object from arrays, by a chain of ifs over its 16
/// kinds of shapes and those of the scene; 255 steps as long as the distance, until it is below 1 mm; mirrors, lights
/// and shadows whether the scene has any or not, in its look. Its trees are lists of operations as well, in buffers
/// where it has uniform arrays. Written for this bench from the description of the source.
void useSourceMarch(render::Pass&, const scenes::SceneProgram&, const scenes::SceneWords&);

}  // namespace vitrine::bench
