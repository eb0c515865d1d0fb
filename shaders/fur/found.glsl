// Strand data that the shells pass to the lighting pass: four floats per pixel, each an integer below 2^24 except the
// last. All 0 if nothing was found.
//   x: the strand's direction, y: the normal of the coat, body space; z: height, rank (random number that sets the
//   length and color of the strand), place across and number of the body; w: distance along the view axis, meters
#include "lib/octahedron.glsl"

struct FoundStrand {
    vec3 along;      // direction of the strand, from root to tip
    vec3 coatNormal;
    float height;    // 0 to 1, in steps of 1/1023; 0: bare skin
    float rank;      // random number of the strand, 0 to 1, in steps of 1/64
    float across;    // in strand radii from its center along cross(along, ray): -1 to 1, in steps of 2/63
    int body;        // from 1; 0: nothing
    float viewDepth;
};

// Packs a unit vector, 12 bits per coordinate of octahedronPoint: accurate to 0.05 degrees.
float packedNormal(vec3 n)
{
    vec2 q = floor((octahedronPoint(n) * 0.5 + 0.5) * 4095.0 + 0.5);
    return q.x + 4096.0 * q.y;
}

vec3 unpackedNormal(float packed_)
{
    float high = floor(packed_ / 4096.0);
    return octahedronDirection(vec2(packed_ - 4096.0 * high, high) * (2.0 / 4095.0) - 1.0);
}

vec4 packedStrand(FoundStrand s)
{
    uint across = uint(clamp(s.across * 0.5 + 0.5, 0.0, 1.0) * 63.0 + 0.5);
    uint rank = uint(clamp(s.rank, 0.0, 0.999) * 64.0);
    // Height 0 is reserved for the skin.
    uint height = s.height > 0.0 ? uint(clamp(s.height * 1023.0 + 0.5, 1.0, 1023.0)) : 0u;
    uint marks = uint(s.body) + 4u * (across + 64u * (rank + 64u * height));
    return vec4(packedNormal(s.along), packedNormal(s.coatNormal), float(marks), s.viewDepth);
}

FoundStrand unpackedStrand(vec4 packed_)
{
    uint marks = uint(packed_.z);
    FoundStrand s;
    s.along = unpackedNormal(packed_.x);
    s.coatNormal = unpackedNormal(packed_.y);
    s.height = float(marks >> 14u) / 1023.0;
    s.rank = (float((marks >> 8u) & 63u) + 0.5) / 64.0;
    s.across = float((marks >> 2u) & 63u) * (2.0 / 63.0) - 1.0;
    s.body = int(marks & 3u);
    s.viewDepth = packed_.w;
    return s;
}
