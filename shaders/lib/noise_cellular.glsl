// Cellular noise (Worley 1996, "A Cellular Texture Basis Function") in two, three and four dimensions: one random point
// in each cell, and the distance to the nearest. Distances above 1 count as 1, so that a search of the neighboring
// cells is exact: other points are farther than that. Points, periods and seeds are those of lib/noise.glsl.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/noise.glsl"
#endif

// `value` is 1 at a cell's point and falls to -1 at a distance of 1, so that it lies in [-1, 1] as for the other
// noises.
Noise2 cellularNoise(ivec2 cell, vec2 place, ivec2 period, uint seed)
{
    ivec2 first = noiseWrap(cell - 1, period);
    ivec2 middle = noiseNext(first, period);
    ivec2 last = noiseNext(middle, period);
    float nearest = 1.0;
    vec2 away = vec2(0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 neighbor = ivec2(i % 3, i / 3) - 1;
        ivec2 c = noiseCorner(noiseCorner(middle, last, max(neighbor, 0)), first, max(-neighbor, 0));
        uvec3 bits = hashCell(ivec3(c.x, c.y, 0), seed);
        vec2 d = place - (vec2(neighbor) + vec2(unitFromBits(bits.x), unitFromBits(bits.y)));
        if (dot(d, d) < nearest) {
            nearest = dot(d, d);
            away = d;
        }
    }
    float distance = sqrt(nearest);
    Noise2 n;
    n.value = 1.0 - 2.0 * distance;
    n.slope = distance > 0.0 ? away * (-2.0 / distance) : vec2(0.0);
    return n;
}

// Search of the cells around a place for the nearest point.
struct CellSearch3 {
    vec3 place;
    ivec3 first;   // cells on one side, in the middle and on the other side
    ivec3 middle;
    ivec3 last;
    uint seed;
    float nearest;  // squared distance
    vec3 away;      // from the nearest point to the place
};

CellSearch3 withCell(CellSearch3 before, ivec3 neighbor)
{
    CellSearch3 s = before;
    ivec3 c = noiseCorner(noiseCorner(s.middle, s.last, max(neighbor, 0)), s.first, max(-neighbor, 0));
    uvec3 bits = hashCell(c, s.seed);
    vec3 d = s.place - (vec3(neighbor) + vec3(unitFromBits(bits.x), unitFromBits(bits.y), unitFromBits(bits.z)));
    if (dot(d, d) < s.nearest) {
        s.nearest = dot(d, d);
        s.away = d;
    }
    return s;
}

#ifdef LOOP_LIMIT
CellSearch3 withRow(CellSearch3 s, int y, int z)
{
    return withCell(withCell(withCell(s, ivec3(-1, y, z)), ivec3(0, y, z)), ivec3(1, y, z));
}

CellSearch3 withLayer(CellSearch3 s, int z)
{
    return withRow(withRow(withRow(s, -1, z), 0, z), 1, z);
}
#endif

Noise3 cellularNoise(ivec3 cell, vec3 place, ivec3 period, uint seed)
{
    CellSearch3 s;
    s.place = place;
    s.first = noiseWrap(cell - 1, period);
    s.middle = noiseNext(s.first, period);
    s.last = noiseNext(s.middle, period);
    s.seed = seed;
    s.nearest = 1.0;
    s.away = vec3(0.0);
#ifdef LOOP_LIMIT
    // As in gradientNoise.
    s = withLayer(withLayer(withLayer(s, -1), 0), 1);
#else
    for (int i = 0; i < 27; ++i) s = withCell(s, ivec3(i % 3, (i / 3) % 3, i / 9) - 1);
#endif
    float distance = sqrt(s.nearest);
    Noise3 n;
    n.value = 1.0 - 2.0 * distance;
    n.slope = distance > 0.0 ? s.away * (-2.0 / distance) : vec3(0.0);
    return n;
}

Noise4 cellularNoise(ivec4 cell, vec4 place, ivec4 period, uint seed)
{
    ivec4 first = noiseWrap(cell - 1, period);
    ivec4 middle = noiseNext(first, period);
    ivec4 last = noiseNext(middle, period);
    float nearest = 1.0;
    vec4 away = vec4(0.0);
    uvec4 s = uvec4(seed, pcg(seed), pcg(seed ^ 2654435769u), pcg(seed ^ 1640531527u));
    for (int i = 0; i < 81; ++i) {
        ivec4 neighbor = ivec4(i % 3, (i / 3) % 3, (i / 9) % 3, i / 27) - 1;
        ivec4 c = noiseCorner(noiseCorner(middle, last, max(neighbor, 0)), first, max(-neighbor, 0));
        uvec4 bits = pcg4d(uvec4(uint(c.x), uint(c.y), uint(c.z), uint(c.w)) ^ s);
        vec4 point = vec4(unitFromBits(bits.x), unitFromBits(bits.y), unitFromBits(bits.z), unitFromBits(bits.w));
        vec4 d = place - (vec4(neighbor) + point);
        if (dot(d, d) < nearest) {
            nearest = dot(d, d);
            away = d;
        }
    }
    float distance = sqrt(nearest);
    Noise4 n;
    n.value = 1.0 - 2.0 * distance;
    n.slope = distance > 0.0 ? away * (-2.0 / distance) : vec4(0.0);
    return n;
}
