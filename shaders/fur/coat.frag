// Which strand, if any, the eye meets between this shell and the next one inwards. Permutations: FIN,
// CLUMPS, CURLS, SHADOW (depth alone), WRITE_NORMAL.
#include "lib/frame.glsl"
#include "fur/body.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBody body;
};

in vec3 skin;
in vec3 skinNormal;
in vec3 strandWay;
in vec3 seenAlong;
in float curvature;
#ifdef FIN
in float height;
const float gap = 0.0;
#else
flat in float height;
flat in float gap;
#endif

#ifndef SHADOW
layout(location = 0) out vec4 found;  // xy: world normal, octahedral; z: height; w: number of the body
layout(location = 1) out vec4 tinted; // rgb: square root of the color; a: strand's own number, 0 to 1
#ifdef WRITE_NORMAL
layout(location = 2) out vec4 normalOut;
#endif
#endif

vec2 octahedral(vec3 n)
{
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return n.z >= 0.0 ? p : (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
}

#if defined(CLUMPS) || defined(CURLS)
// Like sin(pi x), from parabolas: it is asked for nine times per sample.
vec3 wave(vec3 x)
{
    vec3 t = x - 2.0 * floor(x * 0.5 + 0.5);
    return 4.0 * t * (1.0 - abs(t));
}

vec3 tuftField(vec3 p)
{
    return wave(p + 0.5 * wave(p.yzx * 0.71 + vec3(0.1, 0.6, 1.3)) + 0.41 * wave(p.zxy * 0.53 + vec3(0.7, 0.2, 1.7)));
}
#endif

void main()
{
    vec3 n = normalize(skinNormal);
    bool bare = height <= 0.0;
    uint seed = uint(body.shells.z);
    float strandLength = body.coat.x;
    float cellSize = body.coat.y;
    float distance_ = length(seenAlong);
    vec3 v = seenAlong / distance_;

    vec3 way = normalize(strandWay);
    float rise = max(dot(way, n), 0.12);
    float into = dot(v, n);
    // Along the ray, per metre: skin passed under it, and height lost; the skin bends away below it.
    float shrink = 1.0 / (body.pull.w * max(1.0 + curvature * height * strandLength * rise, 0.25));
    vec3 passing = (v - way * (into / rise)) * shrink;
    float falling = into / (rise * strandLength);
    float bulge = 0.5 * max(curvature, 0.0) * dot(v - n * into, v - n * into) / strandLength;

    int steps = 1;
    float far = 0.0;
#ifndef FIN
    if (body.shells.y > 1.5 && gap > 0.0) {
        float a = max(-falling, 1e-4);
        float root = a * a - 4.0 * bulge * gap;
        far = root > 0.0 ? 2.0 * gap / (a + sqrt(root)) : min(a / max(bulge, 1e-6), 2.0 * gap / a);
        far = min(far, 14.0 * cellSize / max(length(passing), 1e-3));
        steps = clamp(int(ceil(far * length(passing) * 2.2 / cellSize)), 1, int(body.shells.y));
    }
#endif

#if defined(CLUMPS) || defined(CURLS)
    // Tufts (whose curls turn together): a smooth field with sinks. Its steepest slope is 1, so that nothing folds while clump < 1.
    float waves = 2.0 / (cellSize * parameters.clumpSize * 1.3);
    vec3 tuft = tuftField(skin * waves);
    tuft = (tuft - n * dot(n, tuft)) / (4.0 * waves);
#endif
    float widest = body.coat.z;
    // A strand thinner than half a pixel is drawn half a pixel wide, but not every such strand.
    float pixel = 0.5 * frame.timing.w * distance_;
#ifdef SHADOW
    pixel = 0.0;
#endif
    float shown = min(widest / max(pixel, 1e-9), 1.0);

    bool hit = bare;
    float h = height;
    Strand strand;
    strand.offset = vec3(0.0);
    strand.rank = 0.0;
    strand.tint = 0.5;
    float radius = widest;
    for (int i = 0; i < steps; ++i) {
        float t = far * float(i) / float(steps);
        float at = height + falling * t + bulge * t * t;
        vec3 q = skin + passing * t;
#ifdef CLUMPS
        q += tuft * (parameters.clump * at);
#endif
#ifdef CURLS
        float phase = tuft.x * (4.0 * waves) + 6.2831853 * parameters.curlTurns * at;
        vec3 side = perpendicularTo(n);
        q += (side * cos(phase) + cross(n, side) * sin(phase)) * (parameters.curl * at * strandLength);
#endif
        Strand s = strandAt(q, n, cellSize, 0.8, seed);
        float end = mix(body.coat.w, 1.0, s.rank);
        float r = max(widest * strandTaper(at, end, parameters.strandRoundness), at < end ? pixel : 0.0);
        if (!hit && s.rooted && s.tint < shown && dot(s.offset, s.offset) < r * r) {
            hit = true;
            h = at;
            strand = s;
            radius = r;
        }
        if (hit) break;
    }
    if (!hit) discard;

#ifndef SHADOW
    vec3 color = mix(body.rootColor.rgb, body.tipColor.rgb, powPositive(h, parameters.gradient));
    color *= 1.0 + parameters.colorVariation * (strand.rank - 0.5);
    // A strand is round: its sides face aside.
    vec3 facing = normalize(n + strand.offset * (0.8 / max(radius, 1e-6)) + way * 0.35);
    facing = normalize(transpose(mat3(body.bodyFromWorld)) * facing);
    found = vec4(octahedral(facing), max(h, 0.0), body.rootColor.w);
    tinted = vec4(sqrt(clamp(color, 0.0, 1.0)), strand.tint);
#ifdef WRITE_NORMAL
    normalOut = vec4(facing, 1.0);
#endif
#endif
}
