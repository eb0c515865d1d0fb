// One drawn mesh with a material.
#include "lib/bindings.glsl"
#include "kit/surface_object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    SurfaceObject object;
};
