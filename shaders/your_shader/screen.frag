// Shows the picture of a visitor's shader, which has display values: on the opening of its frame, or pixel by pixel if
// it is shown alone.
#define PORTAL_DISPLAY_LIGHT
#include "kit/portal/portal.glsl"
#include "lib/srgb.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler2D shownPicture;

#ifdef MARKED_IMAGES
#if MARKED_IMAGES > 0
layout(binding = UNIT_EXHIBIT_B) uniform sampler2D firstKept;
#endif
#if MARKED_IMAGES > 1
layout(binding = UNIT_EXHIBIT_C) uniform sampler2D secondKept;
#endif
#endif

const vec2 SCREEN_HALF = vec2(1.2, 0.8);  // meters, of screenPortal
const float SCREEN_BEFORE = 0.02;         // meters in front of the wall

// Display light of the picture; values that are no numbers become black.
vec3 displayed(vec3 color)
{
    return linearFromSrgb(mix(vec3(0.0), min(color, vec3(1.0)), greaterThan(color, vec3(0.0))));
}

#ifdef MARKED_IMAGES
// Whether the texel at a place from 0 to 1 holds infinity or no number. By its bits, as drivers may assume that there
// are no such values.
bool isInvalid(sampler2D image, vec2 at)
{
    ivec2 size = textureSize(image, 0);
    vec4 texel = texelFetch(image, clamp(ivec2(floor(at * vec2(size))), ivec2(0), size - 1), 0);
    return any(equal(floatBitsToUint(texel) & 0x7f800000u, uvec4(0x7f800000u)));
}

vec3 marked(vec3 color, vec2 at)
{
    bool invalid = isInvalid(shownPicture, at);
#if MARKED_IMAGES > 0
    invalid = invalid || isInvalid(firstKept, at);
#endif
#if MARKED_IMAGES > 1
    invalid = invalid || isInvalid(secondKept, at);
#endif
    return invalid ? vec3(1.0, 0.0, 1.0) : color;
}
#endif

PortalSeen portalSeen(PortalRay ray)
{
    PortalSeen seen;
    seen.normal = vec3(0.0, 0.0, 1.0);
    seen.evaluations = 0.0;
    seen.albedo = vec3(0.0);
    vec3 color;
#ifdef ALONE
    seen.distance = 2.0;
    ivec2 size = textureSize(shownPicture, 0);
    if (size == ivec2(frame.size))
        color = texelFetch(shownPicture, clamp(ivec2(floor(ray.pixel)), ivec2(0), size - 1), 0).rgb;
    else
        color = textureLod(shownPicture, ray.pixel / frame.size, 0.0).rgb;
    vec2 at = ray.pixel / frame.size;
#else
    seen.distance = (SCREEN_BEFORE - ray.origin.z) / min(ray.direction.z, -1e-4);
    vec2 place = (ray.origin + ray.direction * seen.distance).xy;
    float texel = 2.0 * SCREEN_HALF.x / float(textureSize(shownPicture, 0).x);
    float level = log2(max(seen.distance * ray.footprint / texel, 1.0));
    vec2 at = 0.5 + 0.5 * place / SCREEN_HALF;
    color = textureLod(shownPicture, at, level).rgb;
#endif
#ifdef MARKED_IMAGES
    color = marked(color, at);
#endif
    // The exposure cancels, so that the screen shows the shader's own colors in every light.
    seen.radiance = displayed(color) / max(portal.radianceScale * light.exposure, 1e-12);
    return seen;
}

#include "kit/portal/main.glsl"
