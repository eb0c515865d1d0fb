// State of earlier frames, for passes that read history images or outputs of sliced passes, and for sliced passes
// themselves. Filled by the renderer.
#include "lib/bindings.glsl"
#include "lib/temporal_block.glsl"

layout(std140, binding = BLOCK_TEMPORAL) uniform Temporal {
    TemporalBlock temporal;
};

// Returns whether history images, and outputs of sliced passes, have usable content.
bool temporalIsValid()
{
    return temporal.isValid;
}

// Slice of the pass that this frame draws, 0 to temporal.sliceCount - 1.
int temporalSlice()
{
    return temporal.slice;
}

// Texture coordinates of a world point in the history image; outside 0 to 1 it was not in view. Points behind the eye
// give (-1, -1).
vec2 temporalCoordinate(vec3 worldPosition)
{
    vec4 clip = temporal.previousClipFromWorld * vec4(worldPosition, 1.0);
    return clip.w > 0.0 ? vec2(clip.x, clip.y) / clip.w * 0.5 + 0.5 : vec2(-1.0);
}
