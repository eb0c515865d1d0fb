// Finds the strand that the camera ray hits between the midpoints to the next outer and the next inner shell.
// Permutations: FIN and BY_ANGLE as in coat.vert, CLUMPS, CURLS, SHADOW (depth only), WRITE_NORMAL.
#include "lib/frame.glsl"
#include "fur/body.glsl"
#include "fur/found.glsl"
#include "fur/walk.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBody body;
};

in vec3 skin;
in vec3 skinNormal;
in vec3 coatNormal;
in vec3 strandWay;
in float curvature;
in vec3 place;
flat in vec3 eye;
#if defined(FIN) || defined(BY_ANGLE)
in float height;
#else
flat in float height;
flat in float above;
flat in float below;
in vec3 strandTurn;
#endif

#ifndef SHADOW
layout(location = 0) out vec4 found;  // packed by fur/found.glsl
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#endif

// `shrink`: scale of lengths across the strands here relative to the skin at rest.
CoatStrands strandsSeen(float distance_, float shrink)
{
    CoatStrands c;
    c.cellSize = body.cellSize;
    c.leastLength = body.leastLength;
    c.widest = body.strandRadius / body.cellSize;
    c.girths = parameters.thicknessVariation;
    c.roundness = parameters.strandRoundness;
    c.soft = parameters.tipSoftness;
    // Separate strands stay inside their cells, which would cut them off. Where strands overlap, the cut is not
    // visible.
    c.jitter = mix(clamp(1.0 - 2.0 * c.widest, 0.3, 0.8), 0.8, smoothStep(0.45, 0.65, c.widest));
    c.tuft = parameters.clumpSize;
    c.clump = 0.0;
    c.curl = 0.0;
    c.curlTurns = 0.0;
#ifdef SHADOW
    c.pixel = 0.0;
    c.shuffle = 0.0;
#else
    c.pixel = 0.5 * frame.pixelAngle * distance_ * shrink / body.cellSize;
    // Other strands in every supersample, so that the average thickness is right. The golden ratio spreads them evenly.
    c.shuffle = 0.618033989 * float(frame.sampleIndex & 1023);
#endif
#ifdef CLUMPS
    c.clump = parameters.clump;
#endif
#ifdef CURLS
    c.curl = parameters.curl * body.strandLength / body.cellSize;
    c.curlTurns = parameters.curlTurns;
#endif
    return c;
}

// Returns root and height along the ray of unit direction `v`. FIN and BY_ANGLE do not traverse between shells.
CoatRay rayHere(vec3 n, vec3 v)
{
    ShellPoint s;
    s.skin = skin;
    s.normal = n;
    s.way = strandWay;
    s.height = height;
    s.placeX = dFdx(place);
    s.placeY = dFdy(place);
    s.skinX = dFdx(skin);
    s.skinY = dFdy(skin);
    s.normalX = dFdx(skinNormal);
    s.normalY = dFdy(skinNormal);
    s.wayX = dFdx(strandWay);
    s.wayY = dFdy(strandWay);
#if defined(FIN) || defined(BY_ANGLE)
    s.turn = vec3(0.0);
#else
    s.turn = strandTurn / max(above + below, 1e-6);
#endif
    return coatRay(s, v, max(body.strandLength, 1e-6));
}

// Returns the interval of the ray that this shell covers, meters.
vec2 stretchHere(CoatRay ray, float distance_)
{
#if defined(FIN) || defined(BY_ANGLE)
    return vec2(0.0);
#else
    if (body.samplesBetween <= 1) return vec2(0.0);
    // The next shell is assumed to be a little deeper: the space between may be searched twice, but never missed.
    vec2 stretch = coatStretch(ray, above, below, 2.3 * below);
    float most = 14.0 * body.cellSize / max(length(ray.passing), 1e-3);
    return vec2(max(stretch.x, -min(most, 0.99 * distance_)), min(stretch.y, most));
#endif
}

#ifdef CURLS
// Direction of a curled strand.
vec3 curled(CoatRay ray, CoatStrands c, vec3 n, MetStrand met, float shrink)
{
    vec3 p = ray.skin + (ray.passing + ray.bending * met.t) * met.t;
    vec3 field = tuftField(p * tuftWaves(c));
    float phase = (field - n * dot(n, field)).x + 6.2831853 * c.curlTurns * met.height;
    vec3 side = perpendicularTo(n);
    vec3 around = cross(n, side);
    vec3 out_ = side * cos(phase) + around * sin(phase);
    vec3 on = around * cos(phase) - side * sin(phase);
    return safeNormalize(strandWay - (out_ + on * (6.2831853 * c.curlTurns * met.height)) * (parameters.curl / shrink), n);
}
#endif

void main()
{
    vec3 n = normalize(skinNormal);
    vec3 seenAlong = place - eye;
    float distance_ = length(seenAlong);
    vec3 v = seenAlong / distance_;
    vec3 way = safeNormalize(strandWay, n);
    float rise = max(dot(way, n), 0.12);
    float shrink = 1.0 / (body.skinScale * max(1.0 + curvature * height * body.strandLength * rise, 0.25));

    CoatStrands strands = strandsSeen(distance_, shrink);
    StrandLattice lattice = strandLattice(n, body.seed);
    CoatRay ray = rayHere(n, v);
    // Strands of length 0 are bare skin, which needs no search.
    bool bald = body.strandLength <= 0.0;
    MetStrand met = walkStrands(ray, strands, lattice, n, stretchHere(ray, distance_), bald ? 0 : body.samplesBetween);
    if (!met.met && height > 0.0) discard;

#ifndef SHADOW
    FoundStrand seen;
    seen.along = way;
#ifdef CURLS
    if (met.met) seen.along = curled(ray, strands, n, met, shrink);
#endif
    seen.coatNormal = normalize(coatNormal);
    seen.height = met.height;
    seen.body = body.number;
    seen.viewDepth = (1.0 + met.t / distance_) / gl_FragCoord.w;
    // A strand thinner than two pixels is shaded neither as round nor with an individual rank.
    float known = bald ? 0.0 : clamp(0.5 * met.radius / max(strands.pixel, 1e-6), 0.0, 1.0);
    seen.rank = 0.5 + (met.strand.rank - 0.5) * known;
    vec3 outwards = strandOffset(lattice, met.strand, known / max(met.radius, 1e-6));
    seen.across = clamp(dot(outwards, safeNormalize(cross(way, v), vec3(0.0))), -1.0, 1.0);
    found = packedStrand(seen);
#ifdef WRITE_NORMAL
    vec3 normal = met.met ? n + outwards * 0.8 + way * 0.35 : n;
    normalOut = vec4(normalize(transpose(mat3(body.bodyFromWorld)) * normal), 1.0);
#endif
#endif
}
