// Maps scene-linear radiance to display-referred linear light. Alpha (coverage) is premultiplied in both. Permutation:
// TONE_CURVE, the function of lib/tonemap.glsl that does it; GLARE, if halos are added first.
#include "lib/light.glsl"
#include "lib/display_light.glsl"
#include "lib/tonemap.glsl"
#ifdef GLARE
#include "lib/glare.glsl"
#endif

layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 display;

// Display light of a pixel. `exposed`: radiance times exposure. `alpha`: as opaque passes and blending left it; 1 is
// scene light, DISPLAY_LIGHT is display light.
vec3 displayLight(vec3 exposed, float alpha)
{
    float share = clamp(alpha - 1.0, 0.0, 1.0);
    vec3 shown = share < 1.0 ? TONE_CURVE(exposed) : vec3(0.0);
    return share > 0.0 ? mix(shown, toneNone(exposed), share) : shown;
}

void main()
{
    vec4 radiance = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
    vec3 exposed = radiance.rgb * light.exposure;
#ifdef GLARE
    exposed = withGlare(exposed);
#endif
    display = vec4(displayLight(exposed, radiance.a), min(radiance.a, 1.0));
    if (radiance.a <= 0.0) display.rgb = vec3(0.0);
}
