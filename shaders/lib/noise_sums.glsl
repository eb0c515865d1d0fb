// Sums of octaves of noise in three dimensions: fractal Brownian motion, ridged, billow and turbulence (Musgrave, in
// Ebert et al. 2003, "Texturing and Modeling"), and domain warping. With derivatives, by the chain rule.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/noise.glsl"
#include "lib/noise_simplex.glsl"
#include "lib/noise_cellular.glsl"
#endif

const int NOISE_VALUE = 0;
const int NOISE_GRADIENT = 1;
const int NOISE_SIMPLEX = 2;
const int NOISE_CELLULAR = 3;

const int NOISE_FBM = 0;
const int NOISE_RIDGED = 1;
const int NOISE_BILLOW = 2;
const int NOISE_TURBULENCE = 3;

Noise3 noiseOfKind(int kind, ivec3 cell, vec3 place, ivec3 period, uint seed)
{
    if (kind == NOISE_VALUE) return valueNoise(cell, place, period, seed);
    if (kind == NOISE_SIMPLEX) return simplexNoise(cell, place, period, seed);
    if (kind == NOISE_CELLULAR) return cellularNoise(cell, place, period, seed);
    return gradientNoise(cell, place, period, seed);
}

// Noise at a point near the origin of its lattice, or near the lattice point given by `cell` and `place`.
Noise3 noiseNear(int kind, vec3 p, ivec3 cell, vec3 place, ivec3 period, uint seed)
{
    vec3 q = p + place;
    vec3 base = floor(q);
    return noiseOfKind(kind, cell + ivec3(base), q - base, period, seed);
}

// Upper bound on the slope of this kind of noise per cell, for any seed.
float noiseSteepest(int kind)
{
    if (kind == NOISE_VALUE) return 3.75;
    if (kind == NOISE_SIMPLEX) return 6.57;
    if (kind == NOISE_CELLULAR) return 2.0;
    return 3.619;
}

// Upper bound on the second derivative along any line, per cell; 0 for noise with creases.
float noiseMostCurved(int kind)
{
    if (kind == NOISE_VALUE) return 14.07;
    if (kind == NOISE_SIMPLEX) return 46.4;
    if (kind == NOISE_CELLULAR) return 0.0;
    return 13.97;
}

// Upper bound on the error of noise that is stored in a volume with 8 texels per cell and interpolated linearly. 3e-3
// of it is for texture filters with 256 steps.
float noiseLookedUpError(int kind)
{
    if (kind == NOISE_VALUE) return 0.058;
    if (kind == NOISE_SIMPLEX) return 0.276;
    if (kind == NOISE_CELLULAR) return 0.22;
    return 0.051;
}

// Applies the shape of a sum to the noise of one octave: the result is in [-1, 1], for turbulence in [0, 1].
Noise3 noiseShaped(int sum, Noise3 n)
{
    Noise3 shaped;
    float size = abs(n.value);
    float side = n.value < 0.0 ? -1.0 : 1.0;
    if (sum == NOISE_RIDGED) {
        shaped.value = 2.0 * (1.0 - size) * (1.0 - size) - 1.0;
        shaped.slope = n.slope * (-4.0 * (1.0 - size) * side);
    } else if (sum == NOISE_BILLOW) {
        shaped.value = 2.0 * size - 1.0;
        shaped.slope = n.slope * (2.0 * side);
    } else if (sum == NOISE_TURBULENCE) {
        shaped.value = size;
        shaped.slope = n.slope * side;
    } else {
        shaped = n;
    }
    return shaped;
}

// Upper bound on the factor by which the shape of an octave (ridged, billow, turbulence) steepens the noise.
float noiseShapedSteepest(int sum)
{
    return sum == NOISE_RIDGED ? 4.0 : (sum == NOISE_BILLOW ? 2.0 : 1.0);
}

// Weight of an octave for a pixel that covers `footprint` of its cells: 1 up to a quarter of a cell, 0 from half a cell
// on, where it would alias.
float noiseFootprintFade(float footprint)
{
    float x = clamp(footprint * 4.0 - 1.0, 0.0, 1.0);
    return 1.0 - x * x * (3.0 - 2.0 * x);
}

// Rotation by `angle` radians around an axis that is parallel to no lattice direction.
mat3 noiseRotation(float angle)
{
    vec3 a = vec3(0.48, 0.6, 0.64);
    float c = cos(angle);
    float s = sin(angle);
    float k = 1.0 - c;
    return mat3(vec3(c + a.x * a.x * k, a.x * a.y * k + a.z * s, a.x * a.z * k - a.y * s),
                vec3(a.x * a.y * k - a.z * s, c + a.y * a.y * k, a.y * a.z * k + a.x * s),
                vec3(a.x * a.z * k + a.y * s, a.y * a.z * k - a.x * s, c + a.z * a.z * k));
}

struct NoiseSum {
    int kind;          // NOISE_VALUE to NOISE_CELLULAR
    int sum;           // NOISE_FBM to NOISE_TURBULENCE
    int octaves;       // at least 1
    float gain;        // amplitude of an octave over that of the one before
    float lacunarity;  // frequency of an octave over that of the one before
    float rotation;    // between octaves, radians
    int period;        // cells of the first octave; 0: none. Needs an integer lacunarity, and no rotation.
    uint seed;
};

// Sum of octaves at a point (in cells of the first octave), divided by the sum of amplitudes; so in [-1, 1].
// `footprint` is the width of a pixel there, in the same cells; 0 omits no octave.
Noise3 noiseSum(NoiseSum s, vec3 p, float footprint)
{
    mat3 turn = noiseRotation(s.rotation) * s.lacunarity;
    mat3 domain = mat3(1.0);
    float amplitude = 1.0;
    float frequency = 1.0;
    float amplitudes = 0.0;
    Noise3 total;
    total.value = 0.0;
    total.slope = vec3(0.0);
    for (int i = 0; i < s.octaves; ++i) {
        float fade = noiseFootprintFade(footprint * frequency);
        amplitudes += amplitude;
        if (fade > 0.0) {
            ivec3 period = ivec3(s.period > 0 ? int(floor(float(s.period) * frequency + 0.5)) : 0);
            Noise3 n = noiseShaped(s.sum, noiseNear(s.kind, domain * p, ivec3(0), vec3(0.0), period, s.seed + uint(i)));
            total.value += n.value * (amplitude * fade);
            total.slope += (transpose(domain) * n.slope) * (amplitude * fade);
        }
        domain = turn * domain;
        amplitude *= s.gain;
        frequency *= s.lacunarity;
    }
    if (amplitudes > 0.0) {  // Without octaves, the sum is 0.
        total.value /= amplitudes;
        total.slope = total.slope / amplitudes;
    }
    return total;
}

// Sum at a point that three further sums displace by up to `warp` cells along each axis. Quilez 2002, "Domain warping";
// the derivative is exact.
Noise3 noiseWarpedSum(NoiseSum s, vec3 p, float warp, float footprint)
{
    NoiseSum other = s;
    other.seed = s.seed + 101u;
    Noise3 x = noiseSum(other, p, footprint);
    other.seed = s.seed + 202u;
    Noise3 y = noiseSum(other, p, footprint);
    other.seed = s.seed + 303u;
    Noise3 z = noiseSum(other, p, footprint);
    Noise3 n = noiseSum(s, p + vec3(x.value, y.value, z.value) * warp, footprint);
    n.slope += (x.slope * n.slope.x + y.slope * n.slope.y + z.slope * n.slope.z) * warp;
    return n;
}
