// Screen-space refraction: what is behind glass. If a ray hits nothing in the picture, the probe is used.
#include "kit/blur_level.glsl"
#include "kit/screen_ray.glsl"

// Radiance from `direction` at `world`. `blur` is the tangent of half the angle by which rough glass spreads the ray.
vec3 backdropRadiance(vec3 world, vec3 direction, float roughness, float blur)
{
    ScreenRay ray = screenRay(world, direction);
    float t = screenHit(ray);
    if (t < 0.0) return probeRadiance(world, direction, roughness);
    vec4 shown = textureLod(backdrop, ray.uv + t * ray.uvStep, blurLevel(wayBehind(ray, t), blur));
    // The pixel may be empty if only the exhibit is drawn.
    return shown.a < 1.0 ? mix(probeRadiance(world, direction, roughness), shown.rgb, shown.a) : shown.rgb;
}
