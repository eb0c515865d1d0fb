// Mask of light sources: 1 (or the color of the sky) where nothing hides the sky, 0 elsewhere. Permutations: FROM_ALPHA
// (coverage before the sky is drawn); otherwise from depth: that of the picture, or of the occluders alone.
#include "lib/frame.glsl"
#include "lib/sky.glsl"
#include "crepuscular_rays/rays.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;

layout(location = 0) out vec4 mask;

void main()
{
    vec4 texel = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
#ifdef FROM_ALPHA
    float open = 1.0 - clamp(texel.a, 0.0, 1.0);
#else
    float open = texel.r > 0.0 ? 0.0 : 1.0;
#endif
    mask = vec4(0.0);
    if (open <= 0.0) return;

    vec3 direction = normalize(frameRay(gl_FragCoord.xy));
    vec3 color = vec3(1.0);
    if (rays.skyColors || rays.threshold > 0.0) {
        vec3 sky = min(max(skyRadiance(direction, frame.pixelAngle), vec3(0.0)) * light.exposure, vec3(1.0));
        float brightness = dot(sky, vec3(0.2126, 0.7152, 0.0722));
        if (rays.threshold > 0.0) open *= smoothStep(0.9 * rays.threshold, rays.threshold, brightness);
        if (rays.skyColors) color = sky;
    }
    if (rays.lightAngle < 3.1415) {
        float angle = safeAcos(dot(direction, light.sunDirection));
        open *= 1.0 - smoothStep(0.5 * rays.lightAngle, rays.lightAngle, angle);
    }
    mask = vec4(color * open, open);
}
