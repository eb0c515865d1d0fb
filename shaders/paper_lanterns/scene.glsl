// The lake as shaders read it: the block, the lanterns stored by float.comp, and the traversal of the lattice.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/hash.glsl"
#include "lib/sdf.glsl"
#include "lib/sdf_operators.glsl"
#include "paper_lanterns/lake_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    LakeBlock lake;
};

layout(binding = UNIT_EXHIBIT_B) uniform sampler2D blueNoise;

int evaluations = 0;

float blueNoiseAt(ivec2 texel)
{
    return texelFetch(blueNoise, texel & 63, 0).x * (255.0 / 256.0) + 0.5 / 256.0;
}

#include "paper_lanterns/water.glsl"
#include "paper_lanterns/paper.glsl"
#include "paper_lanterns/lantern.glsl"
