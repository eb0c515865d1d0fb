// Uniforms shared by the passes of the sunbeams.
#include "lib/bindings.glsl"
#include "crepuscular_rays/rays_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    RaysBlock rays;
};
