// Noise on a lattice of unit cells: value and gradient noise in two, three and four dimensions, with derivatives.
// Simplex and cellular noise: lib/noise_simplex.glsl, lib/noise_cellular.glsl; sums of octaves: lib/noise_sums.glsl.
//
// A point is given as the integer cell that contains it and its place in that cell, 0 to 1 along each axis. So noise is
// equally precise near and far from the origin; only adding cell and place to one float loses precision. `period` is
// the number of cells after which the noise repeats bit by bit along each axis, 0 for never. `seed` selects one of many
// noises. Values lie in [-1, 1] with mean 0.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/hash.glsl"
#endif

// Value and its derivative along each axis, per cell.
struct Noise2 {
    float value;
    vec2 slope;
};
struct Noise3 {
    float value;
    vec3 slope;
};
struct Noise4 {
    float value;
    vec4 slope;
};

// Wraps one coordinate of a periodic lattice. % of a negative number is undefined in GLSL.
int noiseWrap(int cell, int period)
{
    if (period <= 0) return cell;
    return cell >= 0 ? cell % period : period - 1 - (-(cell + 1)) % period;
}

ivec2 noiseWrap(ivec2 cell, ivec2 period)
{
    return ivec2(noiseWrap(cell.x, period.x), noiseWrap(cell.y, period.y));
}

ivec3 noiseWrap(ivec3 cell, ivec3 period)
{
    return ivec3(noiseWrap(cell.x, period.x), noiseWrap(cell.y, period.y), noiseWrap(cell.z, period.z));
}

ivec4 noiseWrap(ivec4 cell, ivec4 period)
{
    return ivec4(noiseWrap(cell.x, period.x), noiseWrap(cell.y, period.y), noiseWrap(cell.z, period.z),
                 noiseWrap(cell.w, period.w));
}

// The same for the next cell, given the wrapped one. Integer division is slow, and software renderers divide one pixel
// at a time: the corners of a cell need one division per axis.
ivec2 noiseNext(ivec2 wrapped, ivec2 period)
{
    ivec2 next = wrapped + 1;
    return next * ivec2(notEqual(next, period));
}

ivec3 noiseNext(ivec3 wrapped, ivec3 period)
{
    ivec3 next = wrapped + 1;
    return next * ivec3(notEqual(next, period));
}

ivec4 noiseNext(ivec4 wrapped, ivec4 period)
{
    ivec4 next = wrapped + 1;
    return next * ivec4(notEqual(next, period));
}

// The corner of a cell: `high` on the axes where `corner` is 1, `low` where it is 0.
ivec2 noiseCorner(ivec2 low, ivec2 high, ivec2 corner)
{
    return low + (high - low) * corner;
}

ivec3 noiseCorner(ivec3 low, ivec3 high, ivec3 corner)
{
    return low + (high - low) * corner;
}

ivec4 noiseCorner(ivec4 low, ivec4 high, ivec4 corner)
{
    return low + (high - low) * corner;
}

// Random bits of a lattice point, given by its wrapped cell: the same on every machine for the same point and seed.
uint noiseBits(ivec2 wrapped, uint seed)
{
    return hashCell(ivec3(wrapped.x, wrapped.y, 0), seed).x;
}

uint noiseBits(ivec3 wrapped, uint seed)
{
    return hashCell(wrapped, seed).x;
}

uint noiseBits(ivec4 wrapped, uint seed)
{
    uvec4 s = uvec4(seed, pcg(seed), pcg(seed ^ 2654435769u), pcg(seed ^ 1640531527u));
    return pcg4d(uvec4(uint(wrapped.x), uint(wrapped.y), uint(wrapped.z), uint(wrapped.w)) ^ s).x;
}

// Fade curve from 0 to 1: first and second derivative are 0 at both ends. noiseFadeSlope is its derivative. Perlin
// 2002, "Improving Noise".
float noiseFade(float x)
{
    return x * x * x * (x * (x * 6.0 - 15.0) + 10.0);
}

float noiseFadeSlope(float x)
{
    return 30.0 * x * x * (x * (x - 2.0) + 1.0);
}

float noiseSigned(uint bits)
{
    return unitFromBits(bits) * 2.0 - 1.0;
}

float noiseSign(uint bits)
{
    return (bits & 1u) != 0u ? -1.0 : 1.0;
}

// One of eight unit directions, none along an axis.
vec2 noiseDirection2(uint bits)
{
    float a = noiseSign(bits) * 0.92387953251128674;
    float b = noiseSign(bits >> 1u) * 0.38268343236508977;
    return (bits & 4u) != 0u ? vec2(b, a) : vec2(a, b);
}

// One of the twelve midpoints of a cube's edges, length sqrt(2). Four of them occur twice, chosen so that no direction
// is preferred. Perlin 2002.
vec3 noiseDirection3(uint bits)
{
    uint h = bits >> 28u;
    float a = noiseSign(h);
    float b = noiseSign(h >> 1u);
    if (h < 4u || h == 12u || h == 13u) return vec3(h == 12u ? 1.0 : (h == 13u ? -1.0 : a), h >= 12u ? 1.0 : b, 0.0);
    if (h < 8u) return vec3(a, 0.0, b);
    return vec3(0.0, h >= 12u ? -1.0 : a, h == 14u ? 1.0 : (h == 15u ? -1.0 : b));
}

// One of the 32 midpoints of a hypercube's edges, length sqrt(3).
vec4 noiseDirection4(uint bits)
{
    uint h = bits >> 27u;
    float a = noiseSign(h);
    float b = noiseSign(h >> 1u);
    float c = noiseSign(h >> 2u);
    uint axis = h >> 3u;
    if (axis == 0u) return vec4(0.0, a, b, c);
    if (axis == 1u) return vec4(a, 0.0, b, c);
    if (axis == 2u) return vec4(a, b, 0.0, c);
    return vec4(a, b, c, 0.0);
}

// ---- Value noise: a random number at every lattice point, smooth between them.

float valueAt(ivec2 wrapped, uint seed)
{
    return noiseSigned(noiseBits(wrapped, seed));
}

float valueAt(ivec3 wrapped, uint seed)
{
    return noiseSigned(noiseBits(wrapped, seed));
}

float valueAt(ivec4 wrapped, uint seed)
{
    return noiseSigned(noiseBits(wrapped, seed));
}

Noise2 valueNoise(ivec2 cell, vec2 place, ivec2 period, uint seed)
{
    ivec2 low = noiseWrap(cell, period);
    ivec2 high = noiseNext(low, period);
    float a = valueAt(low, seed);
    float b = valueAt(ivec2(high.x, low.y), seed);
    float c = valueAt(ivec2(low.x, high.y), seed);
    float d = valueAt(high, seed);
    float u = noiseFade(place.x);
    float v = noiseFade(place.y);
    Noise2 n;
    n.value = mix(mix(a, b, u), mix(c, d, u), v);
    n.slope = vec2(mix(b - a, d - c, v) * noiseFadeSlope(place.x),
                   (mix(c, d, u) - mix(a, b, u)) * noiseFadeSlope(place.y));
    return n;
}

Noise3 valueNoise(ivec3 cell, vec3 place, ivec3 period, uint seed)
{
    ivec3 low = noiseWrap(cell, period);
    ivec3 high = noiseNext(low, period);
    vec3 u = vec3(noiseFade(place.x), noiseFade(place.y), noiseFade(place.z));
    Noise3 n;
    n.value = 0.0;
    n.slope = vec3(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        float value = valueAt(noiseCorner(low, high, corner), seed);
        float x = corner.x == 1 ? u.x : 1.0 - u.x;
        float y = corner.y == 1 ? u.y : 1.0 - u.y;
        float z = corner.z == 1 ? u.z : 1.0 - u.z;
        n.value += value * (x * y * z);
        n.slope += value * vec3(corner.x == 1 ? y * z : -(y * z), corner.y == 1 ? x * z : -(x * z),
                                corner.z == 1 ? x * y : -(x * y));
    }
    n.slope = n.slope * vec3(noiseFadeSlope(place.x), noiseFadeSlope(place.y), noiseFadeSlope(place.z));
    return n;
}

Noise4 valueNoise(ivec4 cell, vec4 place, ivec4 period, uint seed)
{
    ivec4 low = noiseWrap(cell, period);
    ivec4 high = noiseNext(low, period);
    vec4 u = vec4(noiseFade(place.x), noiseFade(place.y), noiseFade(place.z), noiseFade(place.w));
    Noise4 n;
    n.value = 0.0;
    n.slope = vec4(0.0);
    for (int i = 0; i < 16; ++i) {
        ivec4 corner = ivec4(i & 1, (i >> 1) & 1, (i >> 2) & 1, i >> 3);
        float value = valueAt(noiseCorner(low, high, corner), seed);
        float x = corner.x == 1 ? u.x : 1.0 - u.x;
        float y = corner.y == 1 ? u.y : 1.0 - u.y;
        float z = corner.z == 1 ? u.z : 1.0 - u.z;
        float w = corner.w == 1 ? u.w : 1.0 - u.w;
        n.value += value * (x * y * z * w);
        n.slope += value * vec4(corner.x == 1 ? y * z * w : -(y * z * w), corner.y == 1 ? x * z * w : -(x * z * w),
                                corner.z == 1 ? x * y * w : -(x * y * w), corner.w == 1 ? x * y * z : -(x * y * z));
    }
    n.slope = n.slope * vec4(noiseFadeSlope(place.x), noiseFadeSlope(place.y), noiseFadeSlope(place.z),
                             noiseFadeSlope(place.w));
    return n;
}

// ---- Gradient noise (Perlin 2002): a random slope at every lattice point, where the noise is 0.

// Factor that scales the noise to [-1, 1]: the reciprocal of the largest value that any choice of directions gives.
const float GRADIENT_SCALE_2 = 1.5132;
const float GRADIENT_SCALE_3 = 0.9649;
const float GRADIENT_SCALE_4 = 0.6507;

// Sum over the corners of the cell: weights, and their derivatives, are products over the axes.
Noise2 gradientNoise(ivec2 cell, vec2 place, ivec2 period, uint seed)
{
    ivec2 low = noiseWrap(cell, period);
    ivec2 high = noiseNext(low, period);
    vec2 u = vec2(noiseFade(place.x), noiseFade(place.y));
    vec2 du = vec2(noiseFadeSlope(place.x), noiseFadeSlope(place.y));
    Noise2 n;
    n.value = 0.0;
    n.slope = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        vec2 g = noiseDirection2(noiseBits(noiseCorner(low, high, corner), seed) >> 29u);
        float ramp = dot(g, place - vec2(corner));
        float x = corner.x == 1 ? u.x : 1.0 - u.x;
        float y = corner.y == 1 ? u.y : 1.0 - u.y;
        n.value += ramp * (x * y);
        n.slope += g * (x * y) + ramp * vec2(corner.x == 1 ? du.x * y : -(du.x * y),
                                             corner.y == 1 ? du.y * x : -(du.y * x));
    }
    n.value *= GRADIENT_SCALE_2;
    n.slope = n.slope * GRADIENT_SCALE_2;
    return n;
}

// A cell of the lattice and a place in it.
struct GradientCell3 {
    vec3 place;
    ivec3 low;  // corners of the cell
    ivec3 high;
    vec3 u;
    vec3 du;
    uint seed;
};

Noise3 withCorner(GradientCell3 cell, Noise3 before, ivec3 corner)
{
    Noise3 n = before;
    vec3 g = noiseDirection3(noiseBits(noiseCorner(cell.low, cell.high, corner), cell.seed));
    float ramp = dot(g, cell.place - vec3(corner));
    float x = corner.x == 1 ? cell.u.x : 1.0 - cell.u.x;
    float y = corner.y == 1 ? cell.u.y : 1.0 - cell.u.y;
    float z = corner.z == 1 ? cell.u.z : 1.0 - cell.u.z;
    float dx = corner.x == 1 ? cell.du.x : -cell.du.x;
    float dy = corner.y == 1 ? cell.du.y : -cell.du.y;
    float dz = corner.z == 1 ? cell.du.z : -cell.du.z;
    n.value += ramp * (x * y * z);
    n.slope += g * (x * y * z) + ramp * vec3(dx * y * z, x * dy * z, x * y * dz);
    return n;
}

Noise3 gradientNoise(ivec3 cell, vec3 place, ivec3 period, uint seed)
{
    GradientCell3 c;
    c.place = place;
    c.low = noiseWrap(cell, period);
    c.high = noiseNext(c.low, period);
    c.u = vec3(noiseFade(place.x), noiseFade(place.y), noiseFade(place.z));
    c.du = vec3(noiseFadeSlope(place.x), noiseFadeSlope(place.y), noiseFadeSlope(place.z));
    c.seed = seed;
    Noise3 n;
    n.value = 0.0;
    n.slope = vec3(0.0);
#ifdef LOOP_LIMIT
    // Drivers with such a limit keep a loop of so many instructions, and work out at every turn which corner it is.
    n = withCorner(c, withCorner(c, n, ivec3(0, 0, 0)), ivec3(1, 0, 0));
    n = withCorner(c, withCorner(c, n, ivec3(0, 1, 0)), ivec3(1, 1, 0));
    n = withCorner(c, withCorner(c, n, ivec3(0, 0, 1)), ivec3(1, 0, 1));
    n = withCorner(c, withCorner(c, n, ivec3(0, 1, 1)), ivec3(1, 1, 1));
#else
    for (int i = 0; i < 8; ++i) n = withCorner(c, n, ivec3(i & 1, (i >> 1) & 1, i >> 2));
#endif
    n.value *= GRADIENT_SCALE_3;
    n.slope = n.slope * GRADIENT_SCALE_3;
    return n;
}

Noise4 gradientNoise(ivec4 cell, vec4 place, ivec4 period, uint seed)
{
    ivec4 low = noiseWrap(cell, period);
    ivec4 high = noiseNext(low, period);
    vec4 u = vec4(noiseFade(place.x), noiseFade(place.y), noiseFade(place.z), noiseFade(place.w));
    vec4 du = vec4(noiseFadeSlope(place.x), noiseFadeSlope(place.y), noiseFadeSlope(place.z), noiseFadeSlope(place.w));
    Noise4 n;
    n.value = 0.0;
    n.slope = vec4(0.0);
    for (int i = 0; i < 16; ++i) {
        ivec4 corner = ivec4(i & 1, (i >> 1) & 1, (i >> 2) & 1, i >> 3);
        vec4 g = noiseDirection4(noiseBits(noiseCorner(low, high, corner), seed));
        float ramp = dot(g, place - vec4(corner));
        float x = corner.x == 1 ? u.x : 1.0 - u.x;
        float y = corner.y == 1 ? u.y : 1.0 - u.y;
        float z = corner.z == 1 ? u.z : 1.0 - u.z;
        float w = corner.w == 1 ? u.w : 1.0 - u.w;
        float dx = corner.x == 1 ? du.x : -du.x;
        float dy = corner.y == 1 ? du.y : -du.y;
        float dz = corner.z == 1 ? du.z : -du.z;
        float dw = corner.w == 1 ? du.w : -du.w;
        n.value += ramp * (x * y * z * w);
        n.slope += g * (x * y * z * w) + ramp * vec4(dx * y * z * w, x * dy * z * w, x * y * dz * w, x * y * z * dw);
    }
    n.value *= GRADIENT_SCALE_4;
    n.slope = n.slope * GRADIENT_SCALE_4;
    return n;
}
