// Uniforms of the card and its two prints.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "printing/lens.glsl"
#include "lenticular/card_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    CardObject object;
};
