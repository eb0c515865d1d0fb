// Value noise for scene files, with a proven slope.
//
// GLSL 4.50 and C++ (exhibits/sdf_scenes/scene_functions_cpu.h).

#ifndef __cplusplus
#include "lib/hash.glsl"
#endif

// No noise changes by more than this per unit. At a point whose faded coordinates are u, the differences D of the
// interpolated values, which lie in [-1, 1], obey sum D^2 u (1 - u) <= 1 (Parseval's inequality for the product measure
// of the corners), so the slope is at most the largest fade' / sqrt(fade (1 - fade)), which is 15/8 / (1/2) in the
// middle.
const float SCENE_NOISE_SLOPE = 3.75;

float sceneLatticeValue(ivec3 cell)
{
    return unitFromBits(hashCell(cell, 0x5ce9e5u).x) * 2.0 - 1.0;
}

// Values of a lattice of cubes, -1 to 1, with continuous second derivatives.
float sceneValueNoise(vec3 p)
{
    vec3 q = clamp(p, vec3(-1.0e6), vec3(1.0e6));
    vec3 corner = floor(q);
    vec3 f = q - corner;
    vec3 u = f * f * f * (f * (f * 6.0 - vec3(15.0)) + vec3(10.0));
    ivec3 c = ivec3(int(corner.x), int(corner.y), int(corner.z));
    float low = 0.0;
    float high = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec3 at = c + ivec3(i % 2, i / 2, 0);
        float weight = (i % 2 == 1 ? u.x : 1.0 - u.x) * (i / 2 == 1 ? u.y : 1.0 - u.y);
        low += weight * sceneLatticeValue(at);
        high += weight * sceneLatticeValue(at + ivec3(0, 0, 1));
    }
    return low * (1.0 - u.z) + high * u.z;
}

// Octaves of it, each twice as fine and `gain` times as strong as the one before.
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

// Its slope at most.
float sceneFractalSlope(float octaves, float gain)
{
    float sum = 0.0;
    float slope = SCENE_NOISE_SLOPE;
    for (int i = 0; i < int(octaves); ++i) {
        sum += slope;
        slope *= 2.0 * gain;
    }
    return sum;
}

// Bound. Where the noise is below `level`.
float sceneNoiseSolid(vec3 p, float frequency, float level, float octaves, float gain, vec3 shift)
{
    float noise = sceneFractalNoise((p + shift) * frequency, octaves, gain);
    return (noise - level) / (frequency * sceneFractalSlope(octaves, gain));
}

float sceneDisplacementSlope(float amplitude, float frequency, float octaves, float gain)
{
    return 1.0 + amplitude * frequency * sceneFractalSlope(octaves, gain);
}

// Bound. A surface moved in and out by the noise times `amplitude`.
float sceneDisplaced(float d, vec3 p, float amplitude, float frequency, float octaves, float gain, vec3 shift)
{
    float moved = d + amplitude * sceneFractalNoise((p + shift) * frequency, octaves, gain);
    return moved / sceneDisplacementSlope(amplitude, frequency, octaves, gain);
}
