// Blends the beams over the picture: color is the added light, alpha the light that the dust absorbs. Permutations:
// SCREEN (a gathered image), POLAR (the running sum, looked up here), HAZE (extinction by the dust, and scattered light
// of the hall), BEAMS (marched sunbeams), REPLACE (shows the added light alone, or the mask).
#include "lib/light.glsl"
#include "crepuscular_rays/participating_media.glsl"
#include "lib/display_light.glsl"
#include "crepuscular_rays/gather.glsl"
#include "crepuscular_rays/coarse.glsl"
#include "crepuscular_rays/dust.glsl"

layout(binding = UNIT_EXHIBIT_B) uniform sampler2D scattered;

layout(location = 0) out vec4 over;

#ifdef POLAR
// Mean of the mask between the sun and share `t` of the way from it to `pixel`.
vec3 meanWithin(vec2 path, float t)
{
    vec2 size = vec2(textureSize(mask, 0));
    float radius = length(path) * t;
    // Cell i ends at the radius first * ratio^i.
    float i = (log(max(radius, 1e-3)) - rays.logFirstRadius) / rays.logRadiusSpan * size.x;
    // The sun is beyond the edge: nothing is visible so close to it.
    if (rays.sunIsBeyondEdge && i < 0.0) return vec3(0.0);
    float angle = angleOf(path.y, path.x);
    float turns = (angle - rays.firstAngle) / (2.0 * PI);
    float line = fract(turns) * 2.0 * PI / rays.angleSpan;
    return textureLod(mask, vec2(clamp((i + 0.5) / size.x, 0.5 / size.x, 1.0 - 0.5 / size.x), line), 0.0).rgb;
}
#endif

vec3 screenRays(float depth)
{
#if defined(POLAR)
    vec2 pixel = (floor(gl_FragCoord.xy) + 0.5 + frameTile()) * rays.maskScale;
    vec2 path = pixel - rays.sun;
    float exponent = rays.exponent;
    float left = shaftWeightBelow(1.0 - rays.gathered, exponent);
    vec3 mean = meanWithin(path, 1.0);
    if (left > 1e-5) mean = max(mean - left * meanWithin(path, 1.0 - rays.gathered), vec3(0.0)) / max(1.0 - left, 1e-6);
    return mean * rays.strength;
#elif defined(SCREEN)
    return broughtUp(mask, gl_FragCoord.xy, depth) * rays.strength;
#else
    return vec3(0.0);
#endif
}

void main()
{
    vec2 pixel = floor(gl_FragCoord.xy) + frameTile();
#ifdef SHOW_MASK
    over = vec4(maskAt((pixel + 0.5) * rays.maskScale) * rays.inverseExposure, DISPLAY_LIGHT);
    return;
#endif
    float depth = depthAt(pixel);
    int technique = rays.technique;
    over = vec4(0.0);
    if ((technique & 1) != 0) over.rgb += screenRays(depth);
#ifdef HAZE
    if ((technique & 2) != 0) {
        vec3 ray = frameRay(gl_FragCoord.xy);
        float stretch = length(ray);
        vec3 direction = ray / stretch;
        float hidden = airScattered(1.0, airThrough(frame.eye, direction, airStretch(frame.eye, direction), depth * stretch));
        vec3 hallLight = light.hasProbe ? max(texelFetch(probeIrradiance, ivec2(0), 0).rgb, vec3(0.0)) : light.skyZenith * 0.05;
        over.rgb += parameters.airColor * hallLight * (hidden * parameters.ambient);
        over.a = hidden;
    }
#endif
#ifdef BEAMS
    if ((technique & 2) != 0) over.rgb += broughtUp(scattered, gl_FragCoord.xy, depth);
#endif
#ifdef REPLACE
    over.a = 1.0;
#endif
}
