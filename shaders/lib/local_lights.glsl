// Local lights of a frame: lamps, candles. A pass that includes this binds the block (render/plan/local_lights.h) and,
// with LOCAL_SHADOWS defined, the shadow maps at UNIT_LOCAL_SHADOWS.
#include "lib/bindings.glsl"
#include "lib/local_light.glsl"

layout(std140, binding = BLOCK_LOCAL_LIGHTS) uniform LocalLights {
    LocalLightsBlock localLights;
};

// Lights that may reach a place, as bits.
uint lightsNear(vec3 place)
{
    ivec3 last = ivec3(LIGHT_CELLS_X, LIGHT_CELLS_Y, LIGHT_CELLS_Z) - 1;
    // Clamped first: the conversion of a large number is undefined.
    ivec3 at = ivec3(clamp((place - localLights.cellsLow) * localLights.cellsPerMeter, vec3(0.0), vec3(last)));
    int cell = (at.z * LIGHT_CELLS_Y + at.y) * LIGHT_CELLS_X + at.x;
    return uint(localLights.cells[cell / 4][cell % 4]);
}

#ifdef LOCAL_SHADOWS
layout(binding = UNIT_LOCAL_SHADOWS) uniform sampler2DArrayShadow localShadows;

// Visibility of the light: 1 if nothing lies between it and the place, which is lifted off its surface along `normal`.
float localVisibility(LocalLightEntry lamp, vec3 place, vec3 normal)
{
    if (!lamp.castsShadow) return 1.0;
    vec3 fromLight = place - lamp.position;
    float texel = 2.0 * length(fromLight) / float(textureSize(localShadows, 0).x);
    fromLight += normal * (1.5 * texel);
    vec3 position = localShadowPosition(fromLight, lamp.nearPlane);
    float layer = float(lamp.firstLayer + localShadowFace(fromLight));
    // The level is explicit, because not all pixels of a quad look here; this kind of sampler has no textureLod.
    return textureGrad(localShadows, vec4(position.x, position.y, layer, position.z), vec2(0.0), vec2(0.0));
}
#else
float localVisibility(LocalLightEntry lamp, vec3 place, vec3 normal)
{
    return 1.0;
}
#endif

// Irradiance of one light on a surface, shadow included.
vec3 localLit(LocalLightEntry lamp, vec3 place, vec3 normal)
{
    vec3 irradiance = localIrradiance(lamp, place, normal);
    if (irradiance.x + irradiance.y + irradiance.z <= 0.0) return vec3(0.0);
    return irradiance * localVisibility(lamp, place, normal);
}
