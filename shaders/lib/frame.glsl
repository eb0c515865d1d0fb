// The frame block: camera, picture, time. Filled by the renderer from the plan's View (or the pass's own).
#include "lib/bindings.glsl"

layout(std140, binding = BLOCK_FRAME) uniform Frame {
    mat4 viewFromWorld;
    mat4 clipFromView;   // of the tile, jitter included; reversed depth, near 1, infinitely far 0
    mat4 clipFromWorld;
    mat4 worldFromView;
    vec4 eye;            // world space, metres; w: near plane, metres
    vec4 size;           // whole picture: width, height, 1/width, 1/height, pixels
    vec4 sampling;       // xy: lower left corner of the tile plus jitter, pixels; zw: tan of half the field of view
    vec4 shift;          // xy: tan of where the middle of the picture looks, off the axis
    vec4 timing;         // x: seconds, wrapped; y: index of the supersample; z: seed; w: angle of one pixel, radians
    vec4 clipPlane;      // world space: only points p with dot(clipPlane, (p, 1)) >= 0 are drawn
} frame;

// For gl_ClipDistance[0] of every vertex shader that can draw what is seen in a mirror or through a portal; marched
// surfaces start their rays where it becomes positive. 1 everywhere when nothing is clipped.
float frameClipDistance(vec3 worldPosition)
{
    return dot(frame.clipPlane, vec4(worldPosition, 1.0));
}

// Position in the whole picture, in pixels, of the sample that this fragment stands for.
vec2 framePixel(vec2 fragCoord)
{
    return fragCoord + frame.sampling.xy;
}

// Lower left corner of the tile in the whole picture, pixels: a jitter below half a pixel rounds away.
vec2 frameTile()
{
    return floor(frame.sampling.xy + 0.5);
}

// Direction through a position of the whole picture, world space, with length 1 along the view axis.
// Taken from gl_FragCoord, not from a varying, so that tiles join to the bit.
vec3 frameRay(vec2 fragCoord)
{
    vec2 ndc = framePixel(fragCoord) * frame.size.zw * 2.0 - 1.0;
    return mat3(frame.worldFromView) * vec3(ndc * frame.sampling.zw + frame.shift.xy, -1.0);
}

// Distance along the view axis, metres, of a reversed depth value; infinite for the far plane.
float frameViewDepth(float depth)
{
    return frame.eye.w / depth;
}
