// What a pass may know of the frames before: for passes that read history images or the results of work over several
// frames, or that do such work. Filled by the renderer.
#include "lib/bindings.glsl"
#include "lib/temporal_block.glsl"

layout(std140, binding = BLOCK_TEMPORAL) uniform Temporal {
    TemporalBlock temporal;
};

// Whether history images, and results of work over several frames, hold something that can be used.
bool temporalIsValid()
{
    return temporal.isValid;
}

// Which part of the work this frame does, 0 to temporalParts() - 1.
int temporalPart()
{
    return temporal.part;
}

int temporalParts()
{
    return temporal.parts;
}

// Where a point of the world was in the history image, as texture coordinates; outside 0 to 1 it was not in view.
// Points behind the eye come out as (-1, -1).
vec2 temporalCoordinate(vec3 worldPosition)
{
    vec4 clip = temporal.previousClipFromWorld * vec4(worldPosition, 1.0);
    return clip.w > 0.0 ? vec2(clip.x, clip.y) / clip.w * 0.5 + 0.5 : vec2(-1.0);
}
