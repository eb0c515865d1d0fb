// Lights the backdrop: a lamp behind the ice cream throws a round glow on the sheet, which fades towards its edges.
// Permutation: WRITE_NORMAL.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "ice_cream/backdrop_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    IceCreamBackdrop backdrop;
};

in vec3 place;
in vec3 world;
in vec3 worldNormal;
in vec3 roomLight;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

void main()
{
    turnDisk(framePixel(gl_FragCoord.xy));
    vec3 n = normalize(worldNormal);
    vec2 fromGlow = (place.xy - vec2(0.0, -0.1)) / vec2(0.7, 0.5);
    float glow = 0.06 + 0.94 * exp(-dot(fromGlow, fromGlow));
    // The walls of the niche keep some of the room's light off the sheet.
    vec3 light_ = roomLight * 0.35 + vec3(parameters.backdrop * glow);
    float cosine = dot(n, light.sunDirection);
    if (cosine > 0.0 && dot(light.sunIrradiance, vec3(1.0)) > 0.0 && mayBeSunlit(world)) {
        float lit = sunVisibility(world, n) * cosine;
        light_ += light.sunIrradiance * (lit / PI);
    }
    // The plinth darkens the sheet around its foot.
    float beside = max(length(place.xz - backdrop.foot.xz) - backdrop.footRadius, 0.0);
    float above = max(place.y - backdrop.foot.y, 0.0);
    light_ *= 1.0 - 0.7 * exp(-(beside + above) * 14.0);
    radiance = vec4(min(parameters.backdropColor * light_, vec3(6e4)), 1.0);
#ifdef WRITE_NORMAL
    normalOut = vec4(n, 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(parameters.backdropColor, 1.0);
#endif
}
