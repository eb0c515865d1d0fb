// Code shared by all works: the portal's rays, the block, and the atmosphere.
#include "kit/portal/portal.glsl"
#include "lib/numerics.glsl"
#include "lib/noise_sums.glsl"
#include "lib/sky_view.glsl"
#include "noise/noise_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    NoiseBlock work;
};

// Irradiance of the sun on a plane that faces it, after absorption by the air; 0 once it has set.
vec3 sunLight()
{
    return work.sunLight;
}

// Radiance of the clear sky.
vec3 skyLight(vec3 d)
{
    return work.skyScale * skyViewRadiance(d, work.sunDirection);
}

// Approximate mean of the sky over the hemisphere above a plane with this `up` component: light in shadows.
vec3 skyAmbient(float up)
{
    return mix(0.75 * work.skyAround, work.skyAbove, 0.5 + 0.5 * up);
}

// The sun's disk, darker towards its limb, with the aureole of haze. `footprint`: width of a pixel at distance 1.
vec3 sunDisk(vec3 d, float footprint)
{
    const float radius = 0.00465;
    float angle = safeAcos(dot(d, work.sunDirection));
    float edge = max(footprint, 1e-4);
    float disk = 1.0 - smoothstep(radius - 0.5 * edge, radius + 0.5 * edge, angle);
    float limb = 0.6 + 0.4 * safeSqrt(1.0 - angle * angle / (radius * radius));
    // A disk that is narrower than a pixel keeps its light.
    float share = min(1.0, 4.0 * radius * radius / (edge * edge));
    return sunLight() * (90.0 * disk * limb * share + 0.5 * exp(-angle * 22.0) + 1.6 * exp(-angle * 95.0));
}

// Sunlight that water with this mean square slope reflects, for a sun of irradiance 1: Beckmann distribution of slopes.
// Limited, because averaging cannot remove an unbounded sample.
float sunGlitter(vec3 n, vec3 toEye, float slopes)
{
    vec3 h = safeNormalize(work.sunDirection + toEye, n);
    float c = max(dot(n, h), 1e-3);
    float c2 = c * c;
    float d = exp((c2 - 1.0) / (c2 * slopes)) / (PI * slopes * c2 * c2);
    float f = schlick(max(dot(h, toEye), 0.0), 0.02);
    return min(f * d / (4.0 * max(dot(n, toEye), 0.08)), 8.0);
}

// Applies aerial perspective to radiance seen at a distance; the air's own light is that of the horizon.
vec3 throughAir(vec3 radiance, vec3 d, float distance, float reach)
{
    float left = exp(-distance / reach);
    vec3 air = skyLight(normalize(vec3(d.x, max(d.y, 0.0) * 0.5 + 0.015, d.z)));
    return mix(air, radiance, left);
}

PortalSeen nothingSeen()
{
    PortalSeen seen;
    seen.radiance = vec3(0.0);
    seen.normal = vec3(0.0);
    seen.distance = 1e20;
    seen.evaluations = 0.0;
    seen.albedo = vec3(0.0);
    return seen;
}
