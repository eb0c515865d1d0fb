// Scattering in a cloud of droplets that absorb nothing. GLSL 4.50 and C++ (exhibits/noise/noise_cpu.h); needs
// lib/numerics.glsl.

// Phase function, per steradian, integrates to 1. Henyey and Greenstein 1941, "Diffuse Radiation in the Galaxy".
float cloudLobe(float cosine, float g)
{
    float g2 = g * g;
    float b = max(1.0 + g2 - 2.0 * g * clamp(cosine, -1.0, 1.0), 1.0e-7);
    return (1.0 - g2) / (4.0 * PI * b * sqrt(b));
}

// Phase function of two lobes: `forward`, and with share `backward` a second one backwards with half the anisotropy.
// Integrates to 1.
float cloudPhase(float cosine, float forward, float backward)
{
    return lerpExact(cloudLobe(cosine, forward), cloudLobe(cosine, -0.5 * forward), backward);
}

// Transmittance of an optical depth. A negative depth counts as 0, or the cloud would glow.
float cloudThrough(float depth)
{
    return exp(-max(depth, 0.0));
}

// Light that a segment of optical depth `depth` adds to a ray, if each part sends `source` towards the eye per unit of
// its depth. The integral in closed form, so that the result does not depend on the number of segments (Hillaire 2015,
// "Physically Based and Unified Volumetric Rendering in Frostbite"). Multiply by the transmittance of the cloud in
// front of it.
float cloudAdded(float source, float depth)
{
    return source * (1.0 - cloudThrough(depth));
}

// Sunlight scattered towards the eye per unit of optical depth, at a place under the optical depth `depth`, for a sun
// of irradiance 1 and 1 to `orders` scatterings. Each order has 3/4 of the weight of the one before, half its depth and
// half its anisotropy (Wrenninge, Kulla and Lundqvist 2013, "Oz: The Great and Volumetric").
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

// Factor of the sunlight near the surface of a cloud, 0 to 1: light has been scattered few times there, and little of
// it turns back, so that billows have dark edges seen with the sun behind the eye. Towards the sun, where the edges
// shine, there is no such loss. `strength` is from 0 to 1. Schneider 2015, "The Real-Time Volumetric Cloudscapes of
// Horizon Zero Dawn".
float cloudPowder(float depth, float cosine, float strength)
{
    float ahead = smoothStep(-0.3, 0.8, cosine);
    return 1.0 - strength * (1.0 - ahead) * exp(-2.0 * max(depth, 0.0));
}
