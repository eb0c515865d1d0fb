// Finds what a mirror at y = 0 shows of the picture of everything opaque. Both results are multiplied by the coverage, so
// that their mip levels are means of what was found.
#include "lib/frame.glsl"
#include "kit/screen_ray.glsl"

layout(location = 0) out vec4 mirrored;  // radiance; in alpha the coverage: 0 where the picture does not show it
layout(location = 1) out float way;      // part of the way from the eye that lies behind the mirror

void main()
{
    const float border = 0.08;  // Coverage fades over this part of the picture, so that nothing appears suddenly.
    const float above = 0.01;   // Meters along the ray at which it begins, so that it does not meet the mirror itself.
    mirrored = vec4(0.0);
    way = 0.0;
    vec3 direction = frameRay(gl_FragCoord.xy);
    float depth = frame.eye.y / max(-direction.y, 1e-6);
    float drawn = frameViewDepth(texelFetch(backdropDepth, ivec2(gl_FragCoord.xy), 0).r);
    if (!(frame.eye.y > 0.0 && abs(drawn - depth) < 2e-3 * depth)) return;  // Something else is drawn here.
    vec3 onward = normalize(direction * vec3(1.0, -1.0, 1.0));
    ScreenRay ray = screenRay(frame.eye + depth * direction + above * onward, onward);
    float t = screenHit(ray);
    if (t < 0.0) return;
    vec2 at = ray.uv + t * ray.uvStep;
    vec2 inside = min(at, 1.0 - at);
    vec4 shown = textureLod(backdrop, at, 0.0);
    float coverage = shown.a * smoothstep(0.0, border, min(inside.x, inside.y));
    mirrored = vec4(shown.rgb * coverage, coverage);
    way = wayBehind(ray, t) * coverage;
}
