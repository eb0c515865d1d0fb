// Code shared by all works: the portal's rays, the block, and the atmosphere.
#include "kit/portal/portal.glsl"
#include "lib/numerics.glsl"
#include "lib/noise_sums.glsl"
#include "noise/noise_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    NoiseBlock work;
};

// Vertical optical depth of clear air for red, green and blue (Bucholtz 1995, "Rayleigh-scattering calculations for the
// terrestrial atmosphere", at 680, 550 and 440 nm). Haze has its own.
const vec3 AIR_DEPTH = vec3(0.041, 0.098, 0.242);

float hazeDepth()
{
    return 0.02 + 0.28 * parameters.haze * parameters.haze;
}

// Path length through the air relative to the vertical one. Kasten and Young 1989; below the horizon as at the horizon.
float airMass(float up)
{
    float s = max(up, 0.0);
    float angle = degrees(asin(min(s, 1.0)));
    return 1.0 / (s + 0.50572 * pow(angle + 6.07995, -1.6364));
}

// Irradiance of the sun on a plane that faces it, after absorption by the air; 0 below the horizon.
vec3 sunLight()
{
    float up = work.sunDirection.y;
    vec3 through = exp(-(AIR_DEPTH + hazeDepth() * 0.6) * airMass(up));
    return 5.0 * through * smoothstep(-0.02, 0.03, up);
}

// Radiance of the clear sky: single scattering in air that is uniform along the ray (Hoffman and Preetham 2002,
// "Rendering Outdoor Light Scattering in Real Time"), with light attenuated over half the path, and a share of double
// scattering.
vec3 skyLight(vec3 d)
{
    float haze = hazeDepth();
    float mass = min(airMass(d.y), 30.0);
    float cosine = dot(d, work.sunDirection);
    float up = max(work.sunDirection.y, 0.0);
    vec3 depth = AIR_DEPTH + haze;
    vec3 sun = exp(-depth * min(airMass(up), 24.0) * 0.42);
    vec3 single = AIR_DEPTH * (0.0597 * (1.0 + cosine * cosine));
    float g = 0.76;
    float lobe = 0.0796 * (1.0 - g * g) / pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
    vec3 scattered = (single + haze * lobe + AIR_DEPTH * 0.02) / depth;
    float day = smoothstep(-0.12, 0.25, work.sunDirection.y + 0.08);
    return 5.0 * day * sun * scattered * (1.0 - exp(-depth * mass));
}

// Approximate mean of the sky over the hemisphere above a plane with this `up` component: light in shadows.
vec3 skyAmbient(float up)
{
    vec3 high = skyLight(vec3(0.0, 0.85, 0.52));
    vec3 low = skyLight(normalize(vec3(-work.sunDirection.x, 0.12, -work.sunDirection.z) + vec3(0.0, 0.0, 1e-3)));
    return mix(low * 0.75, high, 0.5 + 0.5 * up);
}

// The sun's disk, with a small halo.
vec3 sunDisk(vec3 d)
{
    float angle = safeAcos(dot(d, work.sunDirection));
    return sunLight() * (60.0 * (1.0 - smoothstep(0.0045, 0.0075, angle)) + 0.6 * exp(-angle * 38.0));
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
    return seen;
}
