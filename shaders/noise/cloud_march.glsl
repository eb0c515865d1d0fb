// Light of the clouds along a ray: noise in a layer, lit by the sun through the cloud itself and by the sky. Permutations:
// BAKED; JITTER; EVEN_STEPS (equal steps, plain sums).
#include "noise/cloud_noise.glsl"
#include "noise/cloud_medium.glsl"

#ifdef BAKED
layout(binding = UNIT_EXHIBIT_A) uniform sampler3D bakedNoise;
#endif
#ifdef JITTER
layout(binding = UNIT_EXHIBIT_B) uniform sampler2D blueNoise;
#endif

const float CLOUD_FARTHEST = 32000.0;
const float CLOUD_GROUND = -1100.0;  // meters, relative to the cloud base

float evaluations = 0.0;

// Loops over octaves in a lookup of large lumps and of fine ones.
#ifdef BAKED
const int lumpLoops = 0;
const int fineLoops = 0;
#else
int lumpLoops = 2 * parameters.cloudOctaves + 1;
int fineLoops = parameters.cloudOctaves;
#endif
// Iterations of a step towards the sun; two of five have two fine lookups.
#define LIGHT_STEP_LOOPS (1 + lumpLoops + fineLoops)

#ifdef LOOP_LIMIT
const int ANY_NUMBER = 1 << 30;
int loopsLeft = 0;  // for steps towards the sun
#endif

// A ray of CLOUD_FARTHEST that never leaves the clouds, where strides are half as long, takes this many times `steps`.
const int MOST_STEPS = 4;

// The steps along a ray, of which each takes `loops` iterations without those towards the sun, and MOST_STEPS times as
// many may be taken. A driver that ends all loops of a group of pixels after so many iterations would leave out the rest
// of the clouds. At most half of them are for these steps. If what is left is too little for all steps towards the sun,
// a quarter of it is for those of one pixel, because neighboring pixels differ.
int affordableSteps(int loops)
{
#ifdef LOOP_LIMIT
    int steps = min(parameters.cloudSteps, LOOP_LIMIT / (8 * loops));
    int left = LOOP_LIMIT - MOST_STEPS * steps * loops;
    bool enough = MOST_STEPS * steps * parameters.lightSteps * LIGHT_STEP_LOOPS <= left;
    loopsLeft = enough ? ANY_NUMBER : left / 4;
    return steps;
#else
    return parameters.cloudSteps;
#endif
}

// The steps towards the sun, of which each takes `loops` iterations. The first points of a ray, which hide those behind
// them, are given the most.
int affordableLightSteps(int loops)
{
#ifdef LOOP_LIMIT
    int count = min(parameters.lightSteps, max(loopsLeft / (8 * loops), 1));
    loopsLeft -= count * loops;
    return count;
#else
    return parameters.lightSteps;
#endif
}

vec2 noiseOfClouds(vec3 p, float repeat)
{
    evaluations += 1.0;
#ifdef BAKED
    return textureLod(bakedNoise, p / repeat, 0.0).xy;
#else
    return cloudNoiseAt(fract(p / repeat), uint(parameters.seed), parameters.cloudOctaves);
#endif
}

// Cloud coverage over a place of the ground: 0 to 1.
float weatherAt(vec3 p)
{
    float wide = noiseOfClouds(vec3(p.x, 1700.0, p.z) * WEATHER_SCALE + work.weatherShift, CLOUD_REPEAT).x;
    return clamp(parameters.coverage + (wide - 0.5) * 1.5, 0.0, 1.0);
}

// Height of the clouds' top as a share of that of the layer.
float cloudTop(float weather)
{
    return mix(0.2, 0.98, weather * weather);
}

// Extinction per meter. `fine`: with eroded edges.
float cloudDensity(vec3 p, float weather, bool fine)
{
    float h = p.y / CLOUD_TOP;
    if (h <= 0.0 || h >= 1.0) return 0.0;
    float top = cloudTop(weather);
    // Above its top there is no cloud, for any noise value.
    if (h >= top) return 0.0;
    float profile = smoothstep(0.0, 0.09, h) * (1.0 - smoothstep(0.35 * top, top, h));
    float shape = noiseOfClouds(p + work.cloudShift, CLOUD_REPEAT).x;
    float d = (shape - mix(0.86, 0.34, weather) - 0.5 * (1.0 - profile)) * 4.5;
    if (d <= 0.0) return 0.0;
    d = min(d, 1.0);
    if (fine && parameters.erosion > 0.0) {
        vec3 q = p + work.fineShift;
        // The same noise at a higher frequency is added. Its period divides that of the lower frequency.
        float edges = 0.0;
        for (int i = 0; i < 2; ++i) edges = mix(edges, noiseOfClouds(q, i == 0 ? CLOUD_FINE_REPEAT : CLOUD_FINE_REPEAT / 4.0).y, i == 0 ? 1.0 : 0.2);
        // Inverting the noise makes lumps at the top of a cloud; without it, there are wisps at the bottom.
        float eaten = mix(edges, 1.0 - edges, clamp(h * 4.0, 0.0, 1.0));
        d = clamp((d - parameters.erosion * eaten * (1.0 - 0.5 * d)) / (1.0 - 0.5 * parameters.erosion), 0.0, 1.0);
    }
    // Droplets grow with height.
    return d * parameters.density * mix(0.55, 1.0, clamp(h * 2.0, 0.0, 1.0));
}

// Optical depth towards the sun in `count` steps. The count is 0 if it is not needed: an empty loop costs less than a
// branch, whose both sides some drivers execute. Edges are eroded in the nearest fifth, whatever the count is, so that
// more steps give the same depth with a smaller error.
float depthToSun(vec3 p, float weather, float shift, int count)
{
    float depth = 0.0;
    float last = 0.0;
    // To the end of the layer, at most 1.2 km: the rest adds little.
    float reach = min(1200.0, (CLOUD_TOP - p.y) / max(work.sunDirection.y, 0.05));
    for (int i = 0; i < count; ++i) {
        float end = reach * pow((float(i) + 1.0) / float(count), 1.7);
        float at = mix(last, end, mix(0.5, shift, 0.6));
        depth += cloudDensity(p + work.sunDirection * at, weather, last < 0.2 * reach) * (end - last);
        last = end;
    }
    return depth;
}

float hazeReach()
{
    return mix(60000.0, 7000.0, sqrt(parameters.haze));
}

struct CloudLight {
    vec3 light;      // light of the clouds that a ray sees, through the air
    float through;   // share of the light behind them that it sees
    float distance;  // mean distance of that light, weighted by how much of it is seen; 0 if there is none
};

// A ray that is not wanted takes no steps: a loop that ends at once costs less than a branch, whose both sides some drivers
// execute.
CloudLight marchedClouds(PortalRay ray, bool isWanted)
{
    CloudLight seen = CloudLight(vec3(0.0), 1.0, 0.0);
    vec3 d = ray.direction;
    float rise = abs(d.y) < 1e-5 ? 1e-5 : d.y;
    float a = -ray.origin.y / rise;
    float b = (CLOUD_TOP - ray.origin.y) / rise;
    float first = max(max(min(a, b), ray.start), 0.0);
    float end = isWanted ? min(max(a, b), CLOUD_FARTHEST) : 0.0;
    if (!(end > first)) return seen;

    float cosine = dot(d, work.sunDirection);
    float through = 1.0;
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    float distance = 0.0;
#ifdef JITTER
    float shift = fract(textureLod(blueNoise, (floor(ray.pixel) + 0.5) / 64.0, 0.0).r + work.sampleShift);
#else
    float shift = 0.5;
#endif
    vec3 sun = sunLight();
    vec3 above = skyAmbient(1.0);
    vec3 below = skyAmbient(-0.6) * 0.55;
    float t = first;
    float densityBefore = 0.0;
    vec3 glowBefore = vec3(0.0);
    float fineLeft = 0.0;
    float begun = shift;
    // Two lookups of lumps and two of fine ones.
    int steps = affordableSteps(1 + parameters.scatterings + 2 * lumpLoops + 2 * fineLoops);
    for (int i = 0; i < MOST_STEPS * steps && through > 0.01 && t < end; ++i) {
#ifdef EVEN_STEPS
        float stretch = (end - first) / float(steps);
#else
        // Equally long on most rays, because clouds are equally thick everywhere; longer at a distance, so that no ray
        // in clear air needs twice as many; shorter where the layer is crossed soon. Half as long inside a cloud.
        float stretch = min(5000.0 + 1.25 * (t - first), 1.25 * (end - first)) / float(steps);
        if (fineLeft > 0.0) stretch *= 0.5;
#endif
        stretch = min(stretch * begun, end - t);
        float at = t + stretch;
        vec3 p = ray.origin + d * at;
        float weather = weatherAt(p);
        float density = cloudDensity(p, weather, true);
#ifdef EVEN_STEPS
        bool back = false;
#else
        // A cloud begins within a long stride: repeat it with short ones.
        bool back = density > 0.0 && fineLeft == 0.0;
        fineLeft = density > 0.0 ? 5.0 : max(fineLeft - 1.0, 0.0);
#endif
        float toSun = depthToSun(p, weather, shift, density > 0.0 && !back ? affordableLightSteps(LIGHT_STEP_LOOPS) : 0);
        if (back) {
            begun = max(shift, 0.05);
            continue;
        }
        begun = 1.0;
        t = at;
        float h = p.y / CLOUD_TOP;
        float sunlit = cloudSunlight(cosine, toSun, parameters.forward, parameters.backward, parameters.scatterings);
        vec3 source = sun * (0.95 * sunlit * cloudPowder(toSun + 25.0 * density, cosine, parameters.powder));
        // Sky light from above, weaker under the rest of the cloud; light reflected from sea and haze from below.
        float over = exp(-0.12 * density * max(CLOUD_TOP * cloudTop(weather) - p.y, 0.0));
        source += mix(below, above, smoothstep(0.0, 0.8, h)) * mix(0.22, 0.9, over);
        vec3 glow = source * density;
#ifdef EVEN_STEPS
        float depth = density * stretch;
        float added = through * min(depth, 1.0);
        sum += source * added;
        through *= max(1.0 - depth, 0.0);
#else
        // Between two sample points, density and emitted light are interpolated linearly.
        float densities = density + densityBefore;
        float depth = 0.5 * densities * stretch;
        float added = through * cloudAdded(1.0, depth);
        sum += (glow + glowBefore) * (added / max(densities, 1e-9));
        through *= cloudThrough(depth);
#endif
        distance += (at - 0.5 * stretch) * added;
        weight += added;
        densityBefore = density;
        glowBefore = glow;
    }
    // The remaining transmittance at the step limit counts as 0.
    seen.through = through > 0.01 ? (through - 0.01) / 0.99 : 0.0;
    if (weight > 0.0) {
        seen.distance = distance / weight;
        seen.light = throughAir(sum / weight, d, seen.distance, hazeReach()) * weight;
    }
    return seen;
}
