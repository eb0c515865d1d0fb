// What the shells leave of a strand for the pass that lights it: four floats for a pixel, each a whole number below
// 2^24 but the last. Nothing found: all 0.
//   x: the strand's normal, y: that of the coat, body space; z: height, rank and number of the body;
//   w: distance along the view axis, meters

struct FoundStrand {
    vec3 normal;
    vec3 coatNormal;
    float height;    // 0 to 1, in steps of 1/4095
    float rank;      // 0 to 1, in steps of 1/256
    int body;        // from 1; 0: nothing
    float viewDepth;
};

// Unit vectors as points of an octahedron, unfolded (Meyer et al. 2010, "On Floating-Point Normal Vectors"), 12 bits
// each way: within 0.05 degrees.
float packedNormal(vec3 n)
{
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    vec2 q = floor((p * 0.5 + 0.5) * 4095.0 + 0.5);
    return q.x + 4096.0 * q.y;
}

vec3 unpackedNormal(float packed_)
{
    float high = floor(packed_ / 4096.0);
    vec2 p = vec2(packed_ - 4096.0 * high, high) * (2.0 / 4095.0) - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return normalize(n);
}

vec4 packedStrand(FoundStrand s)
{
    float marks = float(s.body) + 4.0 * floor(clamp(s.rank, 0.0, 0.999) * 256.0) + 1024.0 * floor(clamp(s.height, 0.0, 1.0) * 4095.0 + 0.5);
    return vec4(packedNormal(s.normal), packedNormal(s.coatNormal), marks, s.viewDepth);
}

FoundStrand unpackedStrand(vec4 packed_)
{
    float high = floor(packed_.z / 1024.0);
    float low = packed_.z - 1024.0 * high;
    FoundStrand s;
    s.normal = unpackedNormal(packed_.x);
    s.coatNormal = unpackedNormal(packed_.y);
    s.height = high / 4095.0;
    s.rank = (floor(low / 4.0) + 0.5) / 256.0;
    s.body = int(low - 4.0 * floor(low / 4.0) + 0.5);
    s.viewDepth = packed_.w;
    return s;
}
