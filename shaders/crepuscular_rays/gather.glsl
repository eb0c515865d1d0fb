// Lookups in the mask along the line to the sun, and dithering that hides a low number of samples.
#include "lib/frame.glsl"
#include "lib/hash.glsl"
#include "lib/numerics.glsl"
#include "crepuscular_rays/light_shafts.glsl"
#include "crepuscular_rays/rays.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler2D mask;
layout(binding = UNIT_EXHIBIT_C) uniform sampler2D grain;

// Mask at a position; 0 beyond the edge, where nothing is known.
vec3 maskAt(vec2 pixel)
{
    vec2 size = vec2(textureSize(mask, 0));
    if (pixel.x < 0.0 || pixel.y < 0.0 || pixel.x > size.x || pixel.y > size.y) return vec3(0.0);
    return textureLod(mask, pixel / size, 0.0).rgb;
}

// Blue noise for a cell of the whole picture, -0.5 to 0.5, different for every supersample; 0 if switched off.
float grainAt(vec2 cell)
{
    if (!rays.shiftSamples) return 0.0;
    ivec2 size = textureSize(grain, 0);
    float noise = texelFetch(grain, ivec2(mod(cell, vec2(size))), 0).r * (255.0 / 256.0);
    return fract(noise + 0.618033989 * float(frame.sampleIndex)) - 0.5;
}

// Cell of the whole picture for this fragment of a downsampled image, and its center in mask pixels.
vec2 cellOf(vec2 fragCoord)
{
    return floor(fragCoord) + rays.firstCell;
}

vec2 maskPixel(vec2 cell)
{
    return (cell + 0.5) * rays.cellSize * rays.maskScale;
}
