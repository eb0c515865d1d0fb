// Shows the small picture on its screen, every texel a sharp square. Permutations: those of kit/portal.
#define PORTAL_DISPLAY_LIGHT
#include "kit/portal/portal.glsl"
#include "pixel_art/pixel_block.glsl"
#include "pixel_art/upscale.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D shownPicture;

const vec2 SCREEN_HALF = vec2(1.12, 0.63);  // meters, 16 : 9
const float SCREEN_BEHIND = 0.05;           // meters behind the opening

vec3 bezel(vec2 beyond)
{
    float edge = max(beyond.x, beyond.y);
    return edge < 0.012 ? vec3(0.006, 0.006, 0.007) : vec3(0.020, 0.019, 0.018);
}

// Display light at `at`, in texels; `wide` texels cover a pixel of the final picture.
vec3 screenLight(vec2 at, float wide)
{
    vec2 size = vec2(pixel.size);
    vec2 moved = at + pixel.remainder;
    if (wide >= 1.0) return textureLod(shownPicture, moved / size, log2(wide)).rgb;
    vec2 place = parameters.upscale == upscale_integer ? floor(moved) + 0.5 : sharpTexel(moved, wide);
    return textureLod(shownPicture, place / size, 0.0).rgb;
}

PortalSeen portalSeen(PortalRay ray)
{
    PortalSeen seen;
    seen.normal = vec3(0.0, 0.0, 1.0);
    seen.evaluations = 0.0;
    seen.albedo = vec3(0.0);
    vec2 size = vec2(pixel.size);
    vec3 light;
#ifdef ALONE
    vec2 scale = frame.size / size;
    float texel = min(scale.x, scale.y);
    if (parameters.upscale == upscale_integer && texel >= 1.0) texel = floor(texel);
    vec2 at = (ray.pixel - 0.5 * frame.size) / texel + 0.5 * size;
    vec2 beyond = max(-at, at - size);
    light = max(beyond.x, beyond.y) > 0.0 ? vec3(0.006) : screenLight(at, 1.0 / texel);
    seen.distance = 2.0;
#else
    float behind = 0.495 + SCREEN_BEHIND;
    seen.distance = (-behind - ray.origin.z) / min(ray.direction.z, -1e-4);
    vec2 place = (ray.origin + ray.direction * seen.distance).xy;
    float texel = 2.0 * SCREEN_HALF.x / size.x;
    vec2 at = place / texel + 0.5 * size;
    vec2 beyond = abs(place) - SCREEN_HALF;
    light = max(beyond.x, beyond.y) > 0.0 ? bezel(beyond) : screenLight(at, seen.distance * ray.footprint / texel);
#endif
    seen.radiance = light;
    return seen;
}

#include "kit/portal/main.glsl"
