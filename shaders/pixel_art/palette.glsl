// Colors of a palette, sorted by luminance, and the search for the nearest one.
#include "lib/bindings.glsl"

layout(binding = UNIT_EXHIBIT_B) uniform sampler2D paletteColors;       // linear light
layout(binding = UNIT_EXHIBIT_C) uniform sampler2DArray paletteNearest; // index of 32 x 32 x 32 sRGB-encoded colors, over 255

vec3 encodeSrgb(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

int nearestInPalette(vec3 linear)
{
    ivec3 cell = clamp(ivec3(encodeSrgb(linear) * 31.0 + 0.5), ivec3(0), ivec3(31));
    return int(texelFetch(paletteNearest, cell, 0).r * 255.0 + 0.5);
}

vec3 paletteColor(int index)
{
    return texelFetch(paletteColors, ivec2(index, 0), 0).rgb;
}
