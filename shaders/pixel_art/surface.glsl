// Surface data of a texel in one fetch: its normal and object number with half-float precision, and its stored depth.
// The normal's x and y share one float. Bit 30 of it is set, which is never set in the upper half of a half-float below
// 2, so that it is an ordinary number. C++: exhibits/pixel_art/pixel_passes.cpp, `normalsOf`.

struct Surface {
    vec3 normal; // view space; 0: none
    float id;    // number of the object; 0: empty
    float depth; // as stored
};

const uint ORDINARY_NUMBER = 0x40000000u;

// Rounds to the nearest half-float, ties to even; `packHalf2x16` may truncate.
vec3 asHalf(vec3 n)
{
    uvec3 bits = floatBitsToUint(n);
    return uintBitsToFloat(bits & 0xFFFFE000u);
}

vec4 packedSurface(vec3 n, float id, float depth)
{
    vec3 stored = asHalf(n);
    return vec4(uintBitsToFloat(packHalf2x16(stored.xy) | ORDINARY_NUMBER), stored.z, depth, id);
}

Surface surfaceOf(vec4 texel)
{
    vec2 across = unpackHalf2x16(floatBitsToUint(texel.x) ^ ORDINARY_NUMBER);
    return Surface(vec3(across, texel.y), texel.w, texel.z);
}
