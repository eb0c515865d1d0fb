// The frame block: camera, picture, time. Filled by the renderer from the plan's View (or the pass's own).
#include "lib/bindings.glsl"
#include "lib/frame_block.glsl"

layout(std140, binding = BLOCK_FRAME) uniform Frame {
    FrameBlock frame;
};

// Position of this fragment's sample in the whole picture, in pixels.
vec2 framePixel(vec2 fragCoord)
{
    return fragCoord + frame.tileOrigin;
}

// Lower left corner of the tile in the whole picture, pixels. Rounding removes the jitter, which is below half a pixel.
vec2 frameTile()
{
    return floor(frame.tileOrigin + 0.5);
}

// World-space direction through a position of the whole picture, with length 1 along the view axis. Computed from
// gl_FragCoord, not from a varying, so that adjacent tiles are bit-identical to a whole picture.
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
