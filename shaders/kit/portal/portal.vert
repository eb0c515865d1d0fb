// Draws the opening; with ALONE, the whole picture.
#include "lib/covering_triangle.glsl"
#include "lib/frame.glsl"
#include "kit/portal/portal_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PortalBlock portal;
};

#ifndef ALONE
layout(location = 0) in vec3 position;
#endif

void main()
{
#ifdef ALONE
    gl_Position = coveringPosition();
#else
    gl_Position = frame.clipFromWorld * (portal.worldFromOpening * vec4(position, 1.0));
#endif
}
