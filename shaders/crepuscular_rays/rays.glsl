// What the passes of the sunbeams share.
#include "lib/bindings.glsl"
#include "crepuscular_rays/rays_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    RaysBlock rays;
};
