// Light in a cloud of droplets that swallow nothing. GLSL 4.50 and C++ (exhibits/noise/noise_cpu.h); needs
// lib/numerics.glsl.

// Henyey and Greenstein 1941, "Diffuse Radiation in the Galaxy": per steradian, integrates to 1.
float cloudLobe(float cosine, float g)
{
    float g2 = g * g;
    float b = max(1.0 + g2 - 2.0 * g * clamp(cosine, -1.0, 1.0), 1.0e-7);
    return (1.0 - g2) / (4.0 * PI * b * sqrt(b));
}

// Two lobes: `forward` ahead, and the share `backward` of the light in one back, half as narrow. Integrates to 1.
float cloudPhase(float cosine, float forward, float backward)
{
    return lerpExact(cloudLobe(cosine, forward), cloudLobe(cosine, -0.5 * forward), backward);
}

// What comes through the optical depth; less than none is none, or the cloud would glow.
float cloudThrough(float depth)
{
    return exp(-max(depth, 0.0));
}

// Light that a stretch of optical depth `depth` adds to a ray when each part of it sends `source` towards the eye per
// unit of its own depth: the integral in closed form, so that the number of stretches does not matter (Hillaire 2015,
// "Physically Based and Unified Volumetric Rendering in Frostbite"). Times what comes through the cloud before it.
float cloudAdded(float source, float depth)
{
    return source * (1.0 - cloudThrough(depth));
}

// Sunlight of irradiance 1 that reaches a place under the optical depth `depth` and leaves it towards the eye, after 1
// to `orders` scatterings, per unit of optical depth. Each order counts 3/4 of the one before, sees half of its depth
// and scatters half as much ahead (Wrenninge, Kulla and Lundqvist 2013, "Oz: The Great and Volumetric").
float cloudSunlight(float cosine, float depth, float forward, float backward, int orders)
{
    float sum = 0.0;
    float share = 1.0;
    float depthShare = 1.0;
    float lobeShare = 1.0;
    for (int i = 0; i < orders; ++i) {
        sum += share * cloudPhase(cosine, forward * lobeShare, backward) * cloudThrough(depth * depthShare);
        share *= 0.75;
        depthShare *= 0.5;
        lobeShare *= 0.5;
    }
    return sum;
}
