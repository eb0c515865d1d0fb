// Integer hashing: the only source of randomness in shaders. Hashes based on sin repeat (only 425 distinct values at
// 4096 lattice points near 1e6) and differ between drivers; these are the same everywhere.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).

// Bijective hash of 32 bits.
// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3): pcg.
uint pcg(uint v)
{
    uint state = v * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Hash of three words; each result depends on all three. Same source: pcg3d.
uvec3 pcg3d(uvec3 v)
{
    uvec3 w = v * 1664525u + 1013904223u;
    w.x += w.y * w.z;
    w.y += w.z * w.x;
    w.z += w.x * w.y;
    w = w ^ (w >> 16u);
    w.x += w.y * w.z;
    w.y += w.z * w.x;
    w.z += w.x * w.y;
    return w;
}

// Hash of four words; each result depends on all four. Same source: pcg4d.
uvec4 pcg4d(uvec4 v)
{
    uvec4 w = v * 1664525u + 1013904223u;
    w.x += w.y * w.w;
    w.y += w.z * w.x;
    w.z += w.x * w.y;
    w.w += w.y * w.z;
    w = w ^ (w >> 16u);
    w.x += w.y * w.w;
    w.y += w.z * w.x;
    w.z += w.x * w.y;
    w.w += w.y * w.z;
    return w;
}

// Converts the top 24 bits to a number in [0, 1). Every value is exact in float32 and none rounds to 1.
float unitFromBits(uint bits)
{
    return float(bits >> 8u) * (1.0 / 16777216.0);
}

// Hash of a lattice cell (signed integers). Neighbors stay distinct across zero and past 2^24.
uvec3 hashCell(ivec3 cell, uint seed)
{
    return pcg3d(uvec3(uint(cell.x), uint(cell.y), uint(cell.z)) ^ uvec3(seed, pcg(seed), pcg(seed ^ 2654435769u)));
}
