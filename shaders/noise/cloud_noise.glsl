// Noise of the clouds over one period: 0 to 1 along each axis. Large lumps, and fine ones that erode their edges. Needs
// lib/noise_sums.glsl.

const float CLOUD_TOP = 1400.0;  // meters above the base

NoiseSum cloudSum(int kind, int octaves, int period, uint seed)
{
    NoiseSum sum;
    sum.kind = kind;
    sum.sum = NOISE_FBM;
    sum.octaves = octaves;
    sum.gain = 0.5;
    sum.lacunarity = 2.0;
    sum.rotation = 0.0;
    sum.period = period;
    sum.seed = seed;
    return sum;
}

// Shape and edges: gradient noise mixed with cellular noise, and cellular noise alone; each about 0 to 1.
vec2 cloudNoiseAt(vec3 p, uint seed, int octaves)
{
    NoiseSum wide = cloudSum(NOISE_GRADIENT, octaves + 1, 4, seed);
    NoiseSum lumps = cloudSum(NOISE_CELLULAR, octaves, 6, seed + 50u);
    NoiseSum fine = cloudSum(NOISE_CELLULAR, octaves, 8, seed + 90u);
    float shape = 0.5 + 0.62 * noiseSum(wide, p * 4.0, 0.0).value + 0.38 * noiseSum(lumps, p * 6.0, 0.0).value;
    float edges = 0.5 + 0.5 * noiseSum(fine, p * 8.0, 0.0).value;
    return vec2(shape, edges);
}
