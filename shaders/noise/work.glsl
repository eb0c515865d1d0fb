// What all works share: the portal's rays, the block, and the air.
#include "kit/portal/portal.glsl"
#include "lib/numerics.glsl"
#include "lib/noise_sums.glsl"
#include "noise/noise_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    NoiseBlock work;
};

// Optical depth of clear air straight up, for red, green and blue, and of haze (Bucholtz 1995, "Rayleigh-scattering
// calculations for the terrestrial atmosphere", at 680, 550 and 440 nm).
const vec3 AIR_DEPTH = vec3(0.041, 0.098, 0.242);

float hazeDepth()
{
    return 0.02 + 0.28 * parameters.haze * parameters.haze;
}

// Path through the air over that straight up. Kasten and Young 1989; below the horizon as at it.
float airMass(float up)
{
    float s = max(up, 0.0);
    float angle = degrees(asin(min(s, 1.0)));
    return 1.0 / (s + 0.50572 * pow(angle + 6.07995, -1.6364));
}

// Irradiance of the sun on what faces it, after its way through the air; 0 below the horizon.
vec3 sunLight()
{
    float up = work.sunDirection.y;
    vec3 through = exp(-(AIR_DEPTH + hazeDepth() * 0.6) * airMass(up));
    return 5.0 * through * smoothstep(-0.02, 0.03, up);
}

// Radiance of the clear sky: one scattering in air that is even along the ray (Hoffman and Preetham 2002, "Rendering
// Outdoor Light Scattering in Real Time"), with light that has come half of the way, and a share that has scattered twice.
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

// Mean of the sky over all directions above a plane that looks `up`, roughly: what lights shades.
vec3 skyAmbient(float up)
{
    vec3 high = skyLight(vec3(0.0, 0.85, 0.52));
    vec3 low = skyLight(normalize(vec3(-work.sunDirection.x, 0.12, -work.sunDirection.z) + vec3(0.0, 0.0, 1e-3)));
    return mix(low * 0.75, high, 0.5 + 0.5 * up);
}

// The sun's disk, widened a little by the air around it.
vec3 sunDisk(vec3 d)
{
    float angle = safeAcos(dot(d, work.sunDirection));
    return sunLight() * (60.0 * (1.0 - smoothstep(0.0045, 0.0075, angle)) + 0.6 * exp(-angle * 38.0));
}

// What is seen at a distance through the air, whose light there is the horizon's.
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
