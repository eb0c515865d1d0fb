// End of a shader that draws an exhibit elsewhere: display values of its light, as lib/tonemap.frag makes them.
// TONE_CURVE is a function of lib/tonemap.glsl.
#include "lib/tonemap.glsl"

// Encodes display light as sRGB (lib/srgb.glsl, which other files may include in a branch that is not compiled).
vec3 exportedLight(vec4 radiance)
{
    // An alpha above 1 marks display light, as in lib/display_light.glsl.
    vec3 exposed = radiance.rgb * light.exposure;
    vec3 c = clamp(radiance.a > 1.0 ? toneNone(exposed) : TONE_CURVE(exposed), 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
