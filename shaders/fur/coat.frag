// Which strand, if any, the eye meets between this shell and the next one inwards. Permutations: FIN and
// BY_ANGLE as in coat.vert, CLUMPS, CURLS, SHADOW (depth alone), WRITE_NORMAL.
#include "lib/frame.glsl"
#include "fur/body.glsl"
#include "fur/found.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBody body;
};

in vec3 skin;
in vec3 skinNormal;
in vec3 coatNormal;
in vec3 strandWay;
in vec3 seenAlong;
in float curvature;
#if defined(FIN) || defined(BY_ANGLE)
in float height;
const float gap = 0.0;
#else
flat in float height;
flat in float gap;
#endif

#ifndef SHADOW
layout(location = 0) out vec4 found;  // as packed by fur/found.glsl
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#endif

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
    uint seed = body.seed;
    float strandLength = body.strandLength;
    float cellSize = body.cellSize;
    float distance_ = length(seenAlong);
    vec3 v = seenAlong / distance_;

    vec3 way = normalize(strandWay);
    float rise = max(dot(way, n), 0.12);
    float into = dot(v, n);
    // Derivatives along the ray, per meter: of the position on the skin, and of the height above it, over curved skin.
    float shrink = 1.0 / (body.skinScale * max(1.0 + curvature * height * strandLength * rise, 0.25));
    vec3 passing = (v - way * (into / rise)) * shrink;
    float falling = into / (rise * strandLength);
    float bulge = 0.5 * max(curvature, 0.0) * dot(v - n * into, v - n * into) / strandLength;

    int steps = 1;
    float far = 0.0;
#if !defined(FIN) && !defined(BY_ANGLE)
    if (body.samplesBetween > 1 && gap > 0.0) {
        float a = max(-falling, 1e-4);
        float root = a * a - 4.0 * bulge * gap;
        far = root > 0.0 ? 2.0 * gap / (a + sqrt(root)) : min(a / max(bulge, 1e-6), 2.0 * gap / a);
        far = min(far, 14.0 * cellSize / max(length(passing), 1e-3));
        // Half a cell at a time, or less, where strands are thinner than that and stand far apart.
        float stride = min(cellSize / 2.2, 0.85 * max(body.strandRadius, 0.5 * frame.pixelAngle * distance_));
        steps = clamp(int(ceil(far * length(passing) / stride)), 1, body.samplesBetween);
    }
#endif

#if defined(CLUMPS) || defined(CURLS)
    // Tufts (whose curls turn together): a smooth field with sinks. Its steepest slope is 1, so that nothing folds while clump < 1.
    float waves = 2.0 / (cellSize * parameters.clumpSize * 1.3);
    vec3 tuft = tuftField(skin * waves);
    tuft = (tuft - n * dot(n, tuft)) / (4.0 * waves);
#endif
    float widest = body.strandRadius / cellSize;
    float pixel = 0.5 * frame.pixelAngle * distance_ * shrink / cellSize;
#ifdef SHADOW
    pixel = 0.0;
#endif

    // The ray on the lattice, in cells: what the loop does not do for every sample is done here, once.
    StrandLattice lattice = strandLattice(n, seed);
    vec2 start = onLattice(lattice, skin) / cellSize;
    vec2 pace = onLattice(lattice, passing) / cellSize;
#ifdef CLUMPS
    vec2 drawn = onLattice(lattice, tuft) * (parameters.clump / cellSize);
#endif
#ifdef CURLS
    vec3 side = perpendicularTo(n);
    vec2 curlSide = onLattice(lattice, side) * (parameters.curl * strandLength / cellSize);
    vec2 curlAcross = onLattice(lattice, cross(n, side)) * (parameters.curl * strandLength / cellSize);
    float turned_ = tuft.x * (4.0 * waves);
#endif
    bool hit = bare;
    float h = height;
    RootedStrand strand;
    strand.offset = vec2(0.0);
    strand.along = 0.0;
    strand.rank = 0.0;
    strand.tint = 0.0;
    strand.girth = 0.0;
    float radius = widest;
    for (int i = 0; i < steps; ++i) {
        float t = far * float(i) / float(steps);
        float at = height + falling * t + bulge * t * t;
        vec2 q = start + pace * t;
#ifdef CLUMPS
        q += drawn * at;
#endif
#ifdef CURLS
        float phase = turned_ + 6.2831853 * parameters.curlTurns * at;
        q += (curlSide * cos(phase) + curlAcross * sin(phase)) * at;
#endif
        RootedStrand s = strandInCell(lattice, q, 0.8);
        float end = mix(body.leastLength, 1.0, s.rank);
        float own = widest * (1.0 - parameters.thicknessVariation * s.girth);
        // A strand thinner than half a pixel is drawn half a pixel wide, but not every such strand.
        float shown = min(own / max(pixel, 1e-9), 1.0);
        float r = max(own * strandTaper(at, end, parameters.strandRoundness), at < end ? pixel : 0.0);
        if (!hit && s.rooted && s.tint < shown && dot(s.offset, s.offset) + s.along * s.along < r * r) {
            hit = true;
            h = at;
            strand = s;
            radius = r;
        }
        if (hit) break;
    }
    if (!hit) discard;

#ifndef SHADOW
    FoundStrand seen;
    // A strand is round: its sides face aside.
    seen.normal = normalize(n + strandOffset(lattice, strand, 0.8 / max(radius, 1e-6)) + way * 0.35);
    seen.coatNormal = normalize(coatNormal);
    seen.height = h;
    seen.rank = strand.rank;
    seen.body = body.number;
    seen.viewDepth = 1.0 / gl_FragCoord.w;
    found = packedStrand(seen);
#ifdef WRITE_NORMAL
    normalOut = vec4(normalize(transpose(mat3(body.bodyFromWorld)) * seen.normal), 1.0);
#endif
#endif
}
