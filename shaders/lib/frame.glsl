// The frame block: camera, picture, time. Filled by the renderer from the plan's View (or the pass's own).
#include "lib/bindings.glsl"
#include "lib/frame_block.glsl"

layout(std140, binding = BLOCK_FRAME) uniform Frame {
    FrameBlock frame;
};

// For gl_ClipDistance[0] of every vertex shader that can draw what is seen in a mirror or through a portal; marched
// surfaces start their rays where it becomes positive. 1 everywhere when nothing is clipped.
float frameClipDistance(vec3 worldPosition)
{
    return dot(frame.clipPlane, vec4(worldPosition, 1.0));
}

// Position in the whole picture, in pixels, of the sample that this fragment stands for.
vec2 framePixel(vec2 fragCoord)
{
    return fragCoord + frame.tileOrigin;
}

// Lower left corner of the tile in the whole picture, pixels: a jitter below half a pixel rounds away.
vec2 frameTile()
{
    return floor(frame.tileOrigin + 0.5);
}

// Direction through a position of the whole picture, world space, with length 1 along the view axis.
// Taken from gl_FragCoord, not from a varying, so that tiles join to the bit.
vec3 frameRay(vec2 fragCoord)
{
    vec2 ndc = framePixel(fragCoord) * frame.inverseSize * 2.0 - 1.0;
    return mat3(frame.worldFromView) * vec3(ndc * frame.tanHalfFov + frame.tanShift, -1.0);
}

// Distance along the view axis, meters, of a reversed depth value; infinite for the far plane.
float frameViewDepth(float depth)
{
    return frame.nearPlane / depth;
}
