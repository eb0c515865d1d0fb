// Light scattered by air towards the eye: dust in a box, whose density decreases with height.
//
// This file is GLSL 4.50 and C++ (exhibits/crepuscular_rays/rays_cpu.h); needs lib/numerics.glsl and
// lib/ray_box.glsl.

// Meters: upper limit of the length of a ray in the air, also for infinite rays.
const float AIR_FARTHEST = 1.0e9;

// Phase function, per steradian; integrates to 1. `cosine` is between the directions before and after scattering.
// Henyey and Greenstein 1941, "Diffuse Radiation in the Galaxy".
float airPhase(float cosine, float anisotropy)
{
    float g = clamp(anisotropy, -0.999, 0.999);
    float g2 = g * g;
    float b = max(1.0 + g2 - 2.0 * g * clamp(cosine, -1.0, 1.0), 1.0e-7);
    return (1.0 - g2) / (4.0 * PI * b * sqrt(b));
}

// Returns (1 - exp(-x)) / x, 1 at 0; avoids overflow of exp.
float airMean(float x)
{
    if (abs(x) < 1.0e-2) return 1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0));
    return (1.0 - exp(min(-x, 40.0))) / x;
}

// Optical depth of `path` meters that begin at height `from` and rise `slope` per meter. The extinction is `density`
// per meter at height 0 and falls by a factor e every 1 / `thinning` meters. Never negative.
float airOpticalDepth(float from, float slope, float path, float density, float thinning)
{
    float atStart = density * exp(clamp(-thinning * from, -40.0, 40.0));
    float meters = clamp(path, 0.0, AIR_FARTHEST);
    return clamp(atStart * meters * airMean(thinning * slope * meters), 0.0, 1.0e4);
}

// Light that a segment of non-absorbing air scatters into the ray and out to the eye, for uniform surrounding radiance
// 1. It equals the light that the segment removes from the ray. `through` and `throughEnd` are the transmittances up to
// the segment's start and end. The sum does not depend on how the ray is divided into segments.
float airScattered(float through, float throughEnd)
{
    return max(through - throughEnd, 0.0);
}

// Entry and exit of a ray in the beam of parallel light through an opening, as lineBox: the opening's rectangle, flat
// along `axis` at `plane`, swept along the light. `along` is the light's direction, scaled so that `axis` changes by
// 1. When every point is projected along the light onto the plane, the beam becomes a box. Parts outside `roomLow` to
// `roomHigh` are excluded.
vec2 airBeam(vec3 origin, vec3 direction, vec3 low, vec3 high, int axis, float plane, vec3 along, vec3 roomLow,
             vec3 roomHigh)
{
    vec3 slidOrigin = origin - along * (origin[axis] - plane);
    vec3 slidDirection = direction - along * direction[axis];
    slidOrigin[axis] = 0.0;
    slidDirection[axis] = 0.0;
    vec3 flatLow = low;
    vec3 flatHigh = high;
    flatLow[axis] = -1.0;
    flatHigh[axis] = 1.0;
    vec2 beam = lineBox(slidOrigin, slidDirection, flatLow, flatHigh);
    vec2 room = lineBox(origin, direction, roomLow, roomHigh);
    return vec2(max(beam.x, room.x), min(beam.y, room.y));
}
