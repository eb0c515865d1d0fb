// Light that air scatters towards the eye: dust of a density that thins with height, in a box.
//
// This file is GLSL 4.50 and C++ (exhibits/crepuscular_rays/rays_cpu.h); needs lib/numerics.glsl.

// Meters beyond which a ray has left all air: an endless one has a length, too.
const float AIR_FARTHEST = 1.0e9;

// Share of light scattered into a unit of solid angle, per steradian; integrates to 1. `cosine` between the ways
// before and after. Henyey and Greenstein 1941, "Diffuse Radiation in the Galaxy".
float airPhase(float cosine, float anisotropy)
{
    float g = clamp(anisotropy, -0.999, 0.999);
    float g2 = g * g;
    float b = max(1.0 + g2 - 2.0 * g * clamp(cosine, -1.0, 1.0), 1.0e-7);
    return (1.0 - g2) / (4.0 * PI * b * sqrt(b));
}

// (1 - exp(-x)) / x, 1 at 0; exp may not overflow.
float airMean(float x)
{
    if (abs(x) < 1.0e-2) return 1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0));
    return (1.0 - exp(min(-x, 40.0))) / x;
}

// Optical depth of `way` meters that begin at height `from` and rise `slope` per meter, for an extinction of
// `density` per meter at height 0 that falls by a factor e every 1 / `thinning` meters. Never negative.
float airOpticalDepth(float from, float slope, float path, float density, float thinning)
{
    float atStart = density * exp(clamp(-thinning * from, -40.0, 40.0));
    float meters = clamp(path, 0.0, AIR_FARTHEST);
    return clamp(atStart * meters * airMean(thinning * slope * meters), 0.0, 1.0e4);
}

// Light of radiance 1 from all sides that a stretch of air scatters into a ray and out to the eye, by air that swallows
// nothing: what the stretch takes out of the ray. `through` and `throughEnd` are the shares of light that come through
// the air before the stretch and up to its end. However it is cut into steps, they add up to the same.
float airScattered(float through, float throughEnd)
{
    return max(through - throughEnd, 0.0);
}

// Entry and exit of a ray in the box, as distances along it; exit < entry where it misses.
vec2 airBox(vec3 origin, vec3 direction, vec3 low, vec3 high)
{
    float entry = -1.0e30;
    float exit = 1.0e30;
    for (int axis = 0; axis < 3; ++axis) {
        if (abs(direction[axis]) < 1.0e-12) {
            if (origin[axis] < low[axis] || origin[axis] > high[axis]) return vec2(1.0, -1.0);
            continue;
        }
        float a = (low[axis] - origin[axis]) / direction[axis];
        float b = (high[axis] - origin[axis]) / direction[axis];
        entry = max(entry, min(a, b));
        exit = min(exit, max(a, b));
    }
    return vec2(entry, exit);
}

// The same for the beam that parallel light makes of an opening: the opening's rectangle, flat along `axis` at
// `plane`, swept along the light. `along` is the way of the light for which `axis` changes by 1. The beam is a box
// once every point is slid back along the light onto the plane; what is outside `roomLow` to `roomHigh` does not count.
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
    vec2 beam = airBox(slidOrigin, slidDirection, flatLow, flatHigh);
    vec2 room = airBox(origin, direction, roomLow, roomHigh);
    return vec2(max(beam.x, room.x), min(beam.y, room.y));
}
