// Simplex noise (Perlin 2001, "Noise hardware") in two, three and four dimensions: it sums over the n + 1 corners of a
// simplex instead of the 2^n corners of a cell, and prefers no axis. Points, periods and seeds are those of
// lib/noise.glsl.
//
// The lattices contain the unit steps along x, y, z and w, so that the noise repeats along these axes, as that of
// lib/noise.glsl does (Gustavson and McEwan 2022, "Tiling Simplex Noise and Flow Noise in Two and Three Dimensions").
// In two dimensions, each row is shifted by half a cell, so the period along y must be even. In three dimensions, it is
// the body-centered cubic lattice, whose simplices are congruent. In four, lattice points divide a cell's diagonal into
// thirds. Lattice points are stored as integers, in units of half or a third of a cell as needed.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/noise.glsl"
#endif

// Squared radius of influence of a lattice point: the squared lowest height of a simplex, so that its weight is 0 on
// the opposite face.
const float SIMPLEX_REACH_2 = 0.8;
const float SIMPLEX_REACH_3 = 0.5;
const float SIMPLEX_REACH_4 = 0.33333333333333331;
// Factor that scales the noise to [-1, 1]: the reciprocal of the largest value that any choice of directions gives.
const float SIMPLEX_SCALE_2 = 6.316;
const float SIMPLEX_SCALE_3 = 31.259;
const float SIMPLEX_SCALE_4 = 88.04;

// Contribution of a lattice point with gradient `g` at offset `d`: its ramp times the cube of the remaining squared
// radius.
Noise2 simplexPart(vec2 g, vec2 d)
{
    float w = max(SIMPLEX_REACH_2 - dot(d, d), 0.0);
    float ramp = dot(g, d);
    Noise2 n;
    n.value = w * w * w * ramp;
    n.slope = g * (w * w * w) - d * (6.0 * w * w * ramp);
    return n;
}

Noise3 simplexPart(vec3 g, vec3 d)
{
    float w = max(SIMPLEX_REACH_3 - dot(d, d), 0.0);
    float ramp = dot(g, d);
    Noise3 n;
    n.value = w * w * w * ramp;
    n.slope = g * (w * w * w) - d * (6.0 * w * w * ramp);
    return n;
}

Noise4 simplexPart(vec4 g, vec4 d)
{
    float w = max(SIMPLEX_REACH_4 - dot(d, d), 0.0);
    float ramp = dot(g, d);
    Noise4 n;
    n.value = w * w * w * ramp;
    n.slope = g * (w * w * w) - d * (6.0 * w * w * ramp);
    return n;
}

Noise2 simplexNoise(ivec2 cell, vec2 place, ivec2 period, uint seed)
{
    // In half cells along x: row y begins y halves further left. The cell may lie in an odd row.
    int odd = cell.y & 1;
    vec2 skewed = vec2(place.x + 0.5 * (place.y + float(odd)), place.y);
    vec2 base = floor(skewed);
    vec2 f = skewed - base;
    vec2 mid = f.x > f.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    Noise2 n;
    n.value = 0.0;
    n.slope = vec2(0.0);
    for (int i = 0; i < 3; ++i) {
        vec2 s = base + (i == 0 ? vec2(0.0) : (i == 1 ? mid : vec2(1.0)));
        // Offset of the simplex corner from the corner of the cell.
        vec2 corner = vec2(s.x - 0.5 * (s.y + float(odd)), s.y);
        ivec2 halves = ivec2(2 * cell.x + int(floor(2.0 * corner.x + 0.5)), cell.y + int(s.y));
        uint bits = noiseBits(noiseWrap(halves, ivec2(2 * period.x, period.y)), seed);
        Noise2 part = simplexPart(noiseDirection2(bits >> 29u), place - corner);
        n.value += part.value;
        n.slope += part.slope;
    }
    n.value *= SIMPLEX_SCALE_2;
    n.slope = n.slope * SIMPLEX_SCALE_2;
    return n;
}

Noise3 simplexNoise(ivec3 cell, vec3 place, ivec3 period, uint seed)
{
    vec3 skewed = vec3(place.y + place.z, place.x + place.z, place.x + place.y);
    vec3 base = floor(skewed);
    vec3 f = skewed - base;
    // Steps along the largest component first, along the smallest last.
    vec3 order = vec3(float(f.x >= f.y) + float(f.x >= f.z), float(f.y > f.x) + float(f.y >= f.z),
                      float(f.z > f.x) + float(f.z > f.y));
    Noise3 n;
    n.value = 0.0;
    n.slope = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        float last = 3.0 - float(i);
        vec3 s = base + vec3(float(order.x >= last), float(order.y >= last), float(order.z >= last));
        vec3 twice = vec3(s.y + s.z - s.x, s.x + s.z - s.y, s.x + s.y - s.z);
        ivec3 halves = 2 * cell + ivec3(int(twice.x), int(twice.y), int(twice.z));
        uint bits = noiseBits(noiseWrap(halves, 2 * period), seed);
        Noise3 part = simplexPart(noiseDirection3(bits), place - 0.5 * twice);
        n.value += part.value;
        n.slope += part.slope;
    }
    n.value *= SIMPLEX_SCALE_3;
    n.slope = n.slope * SIMPLEX_SCALE_3;
    return n;
}

Noise4 simplexNoise(ivec4 cell, vec4 place, ivec4 period, uint seed)
{
    vec4 skewed = vec4(place.x + place.y + place.z + place.w) - place;
    vec4 base = floor(skewed);
    vec4 f = skewed - base;
    vec4 order = vec4(float(f.x >= f.y) + float(f.x >= f.z) + float(f.x >= f.w),
                      float(f.y > f.x) + float(f.y >= f.z) + float(f.y >= f.w),
                      float(f.z > f.x) + float(f.z > f.y) + float(f.z >= f.w),
                      float(f.w > f.x) + float(f.w > f.y) + float(f.w > f.z));
    Noise4 n;
    n.value = 0.0;
    n.slope = vec4(0.0);
    for (int i = 0; i < 5; ++i) {
        float last = 4.0 - float(i);
        vec4 s = base + vec4(float(order.x >= last), float(order.y >= last), float(order.z >= last),
                             float(order.w >= last));
        vec4 thrice = vec4(s.x + s.y + s.z + s.w) - 3.0 * s;
        ivec4 thirds = 3 * cell + ivec4(int(thrice.x), int(thrice.y), int(thrice.z), int(thrice.w));
        uint bits = noiseBits(noiseWrap(thirds, 3 * period), seed);
        Noise4 part = simplexPart(noiseDirection4(bits), place - thrice * 0.33333333333333331);
        n.value += part.value;
        n.slope += part.slope;
    }
    n.value *= SIMPLEX_SCALE_4;
    n.slope = n.slope * SIMPLEX_SCALE_4;
    return n;
}
