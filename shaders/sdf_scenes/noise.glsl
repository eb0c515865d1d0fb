// Noise for scene files, with a proven bound on its slope.
//
// GLSL 4.50 and C++ (exhibits/sdf_scenes/scene_functions_cpu.h).

#ifndef __cplusplus
#include "lib/noise_sums.glsl"
#endif

// Value noise of the library, whose slope is at most `noiseSteepest`.
float sceneValueNoise(vec3 p)
{
    vec3 q = clamp(p, vec3(-1.0e6), vec3(1.0e6));
    return noiseNear(NOISE_VALUE, q, ivec3(0), vec3(0.0), ivec3(0), 0x5ce9e5u).value;
}

// Sum of octaves, each with twice the frequency and `gain` times the amplitude of the one before.
float sceneFractalNoise(vec3 p, float octaves, float gain)
{
    float sum = 0.0;
    float amplitude = 1.0;
    vec3 q = p;
    for (int i = 0; i < int(octaves); ++i) {
        sum += amplitude * sceneValueNoise(q);
        amplitude *= gain;
        q = q * 2.0 + vec3(17.0, 31.0, 47.0);
    }
    return sum;
}

// Upper bound on the slope of sceneFractalNoise.
float sceneFractalSlope(float octaves, float gain)
{
    float sum = 0.0;
    float slope = noiseSteepest(NOISE_VALUE);
    for (int i = 0; i < int(octaves); ++i) {
        sum += slope;
        slope *= 2.0 * gain;
    }
    return sum;
}

// Solid where the noise is below `level`; bound.
float sceneNoiseSolid(vec3 p, float frequency, float level, float octaves, float gain, vec3 shift)
{
    float noise = sceneFractalNoise((p + shift) * frequency, octaves, gain);
    return (noise - level) / (frequency * sceneFractalSlope(octaves, gain));
}

float sceneDisplacementSlope(float amplitude, float frequency, float octaves, float gain)
{
    return 1.0 + amplitude * frequency * sceneFractalSlope(octaves, gain);
}

// Surface displaced by the noise times `amplitude`; bound.
float sceneDisplaced(float d, vec3 p, float amplitude, float frequency, float octaves, float gain, vec3 shift)
{
    float moved = d + amplitude * sceneFractalNoise((p + shift) * frequency, octaves, gain);
    return moved / sceneDisplacementSlope(amplitude, frequency, octaves, gain);
}
