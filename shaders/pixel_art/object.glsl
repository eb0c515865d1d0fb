// Uniforms of a part of the small world. `object` has the fields of kit/surface_object.glsl.
#include "lib/bindings.glsl"
#include "pixel_art/object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PixelObjectBlock part;
};
#define object part.surface
