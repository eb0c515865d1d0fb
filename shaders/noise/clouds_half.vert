// Draws the opening, slightly larger, into the picture of half the size; with ALONE, all of it.
#include "lib/covering_triangle.glsl"
#include "lib/frame.glsl"
#include "kit/portal/portal_block.glsl"
#include "noise/noise_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PortalBlock portal;
};
layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    NoiseBlock work;
};

#ifndef ALONE
layout(location = 0) in vec3 position;
#endif

void main()
{
#ifdef ALONE
    gl_Position = coveringPosition();
#else
    vec4 clip = frame.clipFromWorld * (portal.worldFromOpening * vec4(1.05 * position.xy, position.z, 1.0));
    gl_Position = vec4(clip.xy * work.halfFromTile.xy + clip.w * work.halfFromTile.zw, clip.zw);
#endif
}
