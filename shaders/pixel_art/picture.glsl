// Projection and stored depth of the small picture. Permutations: ORTHOGRAPHIC, STANDARD_DEPTH. These are compile-time
// constants, so that they cost nothing per texel.
#include "lib/bindings.glsl"
#include "pixel_art/pixel_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D storedDepth;

float depthAt(ivec2 p)
{
    return texelFetch(storedDepth, p, 0).r;
}

#include "pixel_art/normals.glsl"

DepthLens pictureLens()
{
#ifdef ORTHOGRAPHIC
    bool orthographic = true;
#else
    bool orthographic = false;
#endif
#ifdef STANDARD_DEPTH
    bool standardDepth = true;
#else
    bool standardDepth = false;
#endif
    return DepthLens(pixel.halfExtent, pixel.nearPlane, pixel.farPlane, orthographic, standardDepth, pixel.size,
                     pixel.depthLevels > 0.0 ? 1.0 / pixel.depthLevels : 0.0);
}
