// Shows the picture of a visitor's shader, which has display values: on the opening of its frame, or pixel by pixel if
// it is shown alone.
#define PORTAL_DISPLAY_LIGHT
#include "kit/portal/portal.glsl"
#include "lib/srgb.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler2D shownPicture;

const vec2 SCREEN_HALF = vec2(1.2, 0.8);  // meters, of screenPortal
const float SCREEN_BEFORE = 0.02;         // meters in front of the wall

// Display light of the picture; values that are no numbers become black.
vec3 displayed(vec3 color)
{
    return linearFromSrgb(mix(vec3(0.0), min(color, vec3(1.0)), greaterThan(color, vec3(0.0))));
}

PortalSeen portalSeen(PortalRay ray)
{
    PortalSeen seen;
    seen.normal = vec3(0.0, 0.0, 1.0);
    seen.evaluations = 0.0;
    vec3 color;
#ifdef ALONE
    seen.distance = 2.0;
    ivec2 size = textureSize(shownPicture, 0);
    if (size == ivec2(frame.size))
        color = texelFetch(shownPicture, clamp(ivec2(floor(ray.pixel)), ivec2(0), size - 1), 0).rgb;
    else
        color = textureLod(shownPicture, ray.pixel / frame.size, 0.0).rgb;
#else
    seen.distance = (SCREEN_BEFORE - ray.origin.z) / min(ray.direction.z, -1e-4);
    vec2 place = (ray.origin + ray.direction * seen.distance).xy;
    float texel = 2.0 * SCREEN_HALF.x / float(textureSize(shownPicture, 0).x);
    float level = log2(max(seen.distance * ray.footprint / texel, 1.0));
    color = textureLod(shownPicture, 0.5 + 0.5 * place / SCREEN_HALF, level).rgb;
#endif
    // The exposure cancels, so that the screen shows the shader's own colors in every light.
    seen.radiance = displayed(color) / max(portal.radianceScale * light.exposure, 1e-12);
    return seen;
}

#include "kit/portal/main.glsl"
