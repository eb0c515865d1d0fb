// Colors of a palette, sorted by luminance, and the search for the nearest one.
#include "lib/bindings.glsl"
#include "lib/srgb.glsl"

layout(binding = UNIT_EXHIBIT_B) uniform sampler2D paletteColors;       // linear light
layout(binding = UNIT_EXHIBIT_C) uniform sampler2DArray paletteNearest; // index of 32 x 32 x 32 sRGB-encoded colors, over 255

int nearestInPalette(vec3 linear)
{
    ivec3 cell = clamp(ivec3(srgbFromLinear(linear) * 31.0 + 0.5), ivec3(0), ivec3(31));
    return int(texelFetch(paletteNearest, cell, 0).r * 255.0 + 0.5);
}

vec3 paletteColor(int index)
{
    return texelFetch(paletteColors, ivec2(index, 0), 0).rgb;
}
