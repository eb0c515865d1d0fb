// The noise of which clouds are made, over one repeat: 0 to 1 along each axis. Large lumps, and fine ones that eat away
// their edges. Needs lib/noise_sums.glsl.

const float CLOUD_TOP = 1400.0;  // meters above the base

// Shape and edges: gradient noise that is lumpy by cellular noise, and cellular noise alone; each about 0 to 1.
vec2 cloudNoiseAt(vec3 p, uint seed, int octaves)
{
    NoiseSum wide = NoiseSum(NOISE_GRADIENT, NOISE_FBM, octaves + 1, 0.5, 2.0, 0.0, 4, seed);
    NoiseSum lumps = NoiseSum(NOISE_CELLULAR, NOISE_FBM, octaves, 0.5, 2.0, 0.0, 6, seed + 50u);
    NoiseSum fine = NoiseSum(NOISE_CELLULAR, NOISE_FBM, octaves, 0.5, 2.0, 0.0, 8, seed + 90u);
    float shape = 0.5 + 0.62 * noiseSum(wide, p * 4.0, 0.0).value + 0.38 * noiseSum(lumps, p * 6.0, 0.0).value;
    float edges = 0.5 + 0.5 * noiseSum(fine, p * 8.0, 0.0).value;
    return vec2(shape, edges);
}
