// The local lights of a frame: lamps, candles. Mirrored by LocalLightBlock in render/plan/local_lights.h. Who includes
// this binds the block and, with LOCAL_SHADOWS defined, the shadow maps at UNIT_LOCAL_SHADOWS.
#include "lib/bindings.glsl"
#include "lib/local_light.glsl"

const int MOST_LOCAL_LIGHTS = 32;

layout(std140, binding = BLOCK_LOCAL_LIGHTS) uniform LocalLights {
    vec4 count;  // x: of lights
    LocalLight lights[MOST_LOCAL_LIGHTS];
} localLights;

#ifdef LOCAL_SHADOWS
layout(binding = UNIT_LOCAL_SHADOWS) uniform sampler2DArrayShadow localShadows;

// 1 where nothing stands between the light and a place that is lifted off its surface along `normal`.
float localVisibility(LocalLight light, vec3 place, vec3 normal)
{
    if (light.shadow < 0.0) return 1.0;
    vec3 fromLight = place - light.position;
    float texel = 2.0 * length(fromLight) / float(textureSize(localShadows, 0).x);
    fromLight += normal * (1.5 * texel);
    vec3 position = localShadowPosition(fromLight, light.nearPlane);
    float layer = light.shadow + float(localShadowFace(fromLight));
    return texture(localShadows, vec4(position.x, position.y, layer, position.z));
}
#else
float localVisibility(LocalLight light, vec3 place, vec3 normal)
{
    return 1.0;
}
#endif

// Irradiance of all of them on a surface at `place` with unit `normal`.
vec3 localLightIrradiance(vec3 place, vec3 normal)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < min(int(localLights.count.x), MOST_LOCAL_LIGHTS); ++i) {
        LocalLight light = localLights.lights[i];
        vec3 irradiance = localIrradiance(light, place, normal);
        if (irradiance.x + irradiance.y + irradiance.z > 0.0) sum += irradiance * localVisibility(light, place, normal);
    }
    return sum;
}
