// Glare. Only light above the screen's white is scattered: what the screen can show makes its glare in the viewer's eye.
// An eye scatters about the same share of a light into each octave of angles (Stiles and Holladay: 10 / angle^2), so each
// mip level, twice as wide as the one before, gets the same share.
#include "lib/bindings.glsl"
#include "lib/glare_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Glare {
    GlareBlock glare;
};
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D halos;

// Part of the exposed light that is above the screen's white, with its hue. Finite as a half float.
vec3 glareSource(vec3 exposed)
{
    float peak = max(exposed.r, max(exposed.g, exposed.b));
    return min(exposed * (max(peak - 1.0, 0.0) / max(peak, 1.0)), vec3(6e4));
}

// The light with that part scattered: what a pixel loses, others gain.
vec3 withGlare(vec3 exposed)
{
    float scattered = glare.share * float(glare.levels);
    vec2 at = (gl_FragCoord.xy + glare.offset) * glare.scale;
    return exposed - scattered * glareSource(exposed) + textureLod(halos, at, 0.0).rgb;
}
