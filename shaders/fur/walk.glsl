// Traversal of a coat by a ray, between the midpoints to the next outer and the next inner shell, and the first strand
// that it hits. On the lattice of the roots (fur/strand.glsl) all strands are straight and vertical; the ray is curved
// instead. Heights along a strand from 0 (skin) to 1 (tip of the longest).
//
// GLSL 4.50 and C++ (exhibits/fur/strand_cpu.h).

// A point of a shell, body space, with its derivatives along two directions, X and Y, over the shell.
struct ShellPoint {
    vec3 skin;      // root of the strand, meters, skin at rest
    vec3 normal;    // unit, of the skin
    vec3 way;       // derivative of the place by height, strand lengths
    vec3 turn;      // derivative of `way` by height
    float height;
    vec3 placeX, placeY;    // derivatives along X and Y: of the place in meters, and of the values above
    vec3 skinX, skinY;
    vec3 normalX, normalY;
    vec3 wayX, wayY;
};

// Root and height along a ray, t meters after it hits a shell: the root `skin + passing t + bending t^2` at the height
// `height + falling t + bulge t^2`.
struct CoatRay {
    vec3 skin;
    vec3 passing;
    vec3 bending;
    float height;
    float falling;
    float bulge;
};

// Common properties of the strands of a coat. Lengths in cells of the lattice except the first.
struct CoatStrands {
    float cellSize;     // meters
    float leastLength;  // shortest strand relative to the longest, 0 to 1
    float widest;       // radius of the thickest strand at its root
    float girths;       // share by which others may be thinner
    float roundness;    // that of strandTaper
    float pixel;        // half the width of a pixel: thinner strands are drawn this wide, but only a part of them
    float soft;         // share of a strand's length at its tip that fades out, 0 to 1
    float shuffle;      // any number: selects the parts of strands that are drawn
    float jitter;       // that of strandOfCell
    float clump;        // 0 to below 1: how far strands converge towards their tips
    float tuft;         // cells along a side of a tuft
    float curl;         // radius of the curls
    float curlTurns;
};

struct MetStrand {
    bool met;
    RootedStrand strand;
    float radius;   // cells
    float height;
    float t;        // meters along the ray
};

// Second-order expansion in t, from the shell's first derivatives alone. Within a triangle of the shells it neglects
// only the change of `turn`. Between triangles the surface bulges by the curvature of its normals. `v`: the ray, unit.
CoatRay coatRay(ShellPoint s, vec3 v, float strandLength)
{
    CoatRay ray;
    ray.skin = s.skin;
    ray.height = s.height;
    vec3 facet = cross(s.placeX, s.placeY);
    float area = max(dot(facet, facet), 1.0e-36);
    vec3 up = facet * (inversesqrt(area) * (dot(facet, s.normal) < 0.0 ? -1.0 : 1.0));
    float rise = max(dot(s.way, up), 0.12);
    float into = dot(v, up) / rise;
    vec3 aside = v - s.way * into;
    float x = dot(cross(aside, s.placeY), facet) / area;
    float y = dot(cross(s.placeX, aside), facet) / area;
    ray.passing = s.skinX * x + s.skinY * y;
    ray.falling = into / strandLength;
    // Second-order remainder of the first-order expansion after t meters: strands bend on their way in, and spread
    // sideways.
    vec3 left = (s.turn * (0.5 * into / strandLength) + s.wayX * x + s.wayY * y) * into;
    float lifted = dot(left, up) / rise;
    vec3 shifted = s.way * lifted - left;
    ray.bending = s.skinX * (dot(cross(shifted, s.placeY), facet) / area) +
                  s.skinY * (dot(cross(s.placeX, shifted), facet) / area);
    ray.bulge = (0.5 * max(dot(s.normalX * x + s.normalY * y, aside), 0.0) / rise - lifted) / strandLength;
    return ray;
}

// Interval along the ray, meters, that belongs to this shell. It enters `above` over the shell and leaves `below` under
// it. A ray that turns back before it hits the next shell, `gap` under this one, continues until it is outside again.
vec2 coatStretch(CoatRay ray, float above, float below, float gap)
{
    float a = max(-ray.falling, 1.0e-4);
    float start = -2.0 * above / (a + safeSqrt(a * a + 4.0 * ray.bulge * above));
    float deepest = a * a - 4.0 * ray.bulge * gap;
    if (deepest > 0.0 || gap <= 0.0) return vec2(start, 2.0 * below / (a + safeSqrt(a * a - 4.0 * ray.bulge * below)));
    return vec2(start, 0.5 * (a + sqrt(a * a + 4.0 * ray.bulge * above)) / ray.bulge);
}

// Approximates sin(pi x) by parabolas.
vec3 tuftWave(vec3 x)
{
    vec3 t = x - floor(x * 0.5 + 0.5) * 2.0;
    return t * (vec3(1.0) - abs(t)) * 4.0;
}

// Field of directions along which strands converge: smooth, with sinks, of slope at most 1, so that nothing folds.
vec3 tuftField(vec3 p)
{
    return tuftWave(p + tuftWave(vec3(p.y, p.z, p.x) * 0.71 + vec3(0.1, 0.6, 1.3)) * 0.5 +
                    tuftWave(vec3(p.z, p.x, p.y) * 0.53 + vec3(0.7, 0.2, 1.7)) * 0.41);
}

// Radians of the tuft field's waves per meter of skin.
float tuftWaves(CoatStrands c)
{
    return 2.0 / (c.cellSize * c.tuft * 1.3);
}

// Root of the strand that the ray passes after t meters, in cells of the lattice.
vec2 rootPassed(CoatRay ray, CoatStrands c, StrandLattice l, vec3 n, float t)
{
    vec3 p = ray.skin + (ray.passing + ray.bending * t) * t;
    vec2 q = onLattice(l, p) / c.cellSize;
    if (c.clump <= 0.0 && c.curl <= 0.0) return q;
    float at = ray.height + (ray.falling + ray.bulge * t) * t;
    float waves = tuftWaves(c);
    vec3 field = tuftField(p * waves);
    vec3 tuft = field - n * dot(n, field);
    if (c.clump > 0.0) q += onLattice(l, tuft) * (0.25 / waves / c.cellSize * c.clump * at);
    if (c.curl > 0.0) {
        // Curls of one tuft rotate together.
        float phase = tuft.x + 6.2831853 * c.curlTurns * at;
        vec3 side = perpendicularTo(n);
        q += onLattice(l, side * cos(phase) + cross(n, side) * sin(phase)) * (c.curl * at);
    }
    return q;
}

// Squared radius (cells) by strandTaper, of a strand with radius `own` at its root and share `left` of its length left
// to the tip.
float squaredRadius(CoatStrands c, float left, float own)
{
    return own * own * pow(clamp(left, 1.0e-8, 1.0), 2.0 - 2.0 * c.roundness);
}

// Height up to which a strand of length `end` is drawn in this supersample; 0: not at all. `own`: its radius at the
// root; `draw`: its random number, 0 to 1. A strand thinner than half a pixel is drawn in a share of the supersamples,
// and a soft tip ends earlier in some of them than in others. The mean is a thin strand, and a tip that fades out.
float drawnHeight(CoatStrands c, float end, float own, float draw)
{
    return draw * c.pixel < own ? end * (1.0 - draw * c.soft) : 0.0;
}

// Position on a straight segment of the ray, 0 to 1, where a strand is hit first; 2: never. `offset`: from the strand
// to the segment's start, cells; `pace`: to its end; `from`, `to`: heights; `end`: of the strand; `top`: the height up
// to which it is drawn; `own`: its radius at the root. The squared radius is assumed to be linear over the segment,
// which gives a quadratic equation.
float strandEntry(CoatStrands c, StrandLattice l, vec2 offset, vec2 pace, vec2 heights, float end, float top, float own)
{
    float from = heights.x;
    float to = heights.y;
    // Part of the segment below the drawn tip.
    float sinks = to - from;
    float tip = clamp((top - from) / (abs(sinks) > 1.0e-6 ? sinks : 1.0e-6), 0.0, 1.0);
    float first = from < top ? 0.0 : tip;
    float last = to < top ? 1.0 : tip;
    // Radii at both ends relative to the lower one: x^e is approximately ((1 - e) + (1 + e) x) / ((1 + e) + (1 - e) x),
    // exact for e = 0 and 1 (Pade approximant at x = 1).
    float low = end - (from + sinks * (sinks < 0.0 ? last : first));
    float high = end - (from + sinks * (sinks < 0.0 ? first : last));
    float e = 2.0 - 2.0 * c.roundness;
    float thick = squaredRadius(c, low / end, own);
    float share = ((1.0 - e) * low + (1.0 + e) * high) / max((1.0 + e) * low + (1.0 - e) * high, 1.0e-6);
    float thin = thick * max(share, 0.0);
    float least = c.pixel * c.pixel;
    float wide = max(sinks < 0.0 ? thin : thick, least);
    float narrow = max(sinks < 0.0 ? thick : thin, least);
    vec2 o = offset + pace * first;
    float aside = dot(o, l.slope);
    float drift = dot(pace, l.slope);
    float apart = dot(o, o) + aside * aside - wide;
    float across = dot(pace, pace) + drift * drift;
    float nearing = 0.5 * (narrow - wide) / max(last - first, 1.0e-6) - (dot(o, pace) + aside * drift);
    float root = nearing * nearing - across * apart;
    float entry = apart <= 0.0 ? first : first + apart / max(nearing + safeSqrt(root), 1.0e-6);
    bool meets = apart <= 0.0 || (nearing > 0.0 && root >= 0.0);
    return meets && min(from, to) < top && entry <= last ? entry : 2.0;
}

// Finds the first strand that the ray hits between t = stretch.x and stretch.y, within at most `cells` cells. Its path
// over the lattice is approximated by the parabola through three exact points, and followed from cell to cell (after
// Amanatides and Woo 1987, "A Fast Voxel Traversal Algorithm for Ray Tracing"), straight within each.
MetStrand walkStrands(CoatRay ray, CoatStrands c, StrandLattice l, vec3 n, vec2 stretch, int cells)
{
    float span = stretch.y - stretch.x;
    vec2 start = rootPassed(ray, c, l, n, stretch.x);
    vec2 slope = vec2(0.0);
    vec2 bend = vec2(0.0);
    if (cells > 1) {
        vec2 middle = rootPassed(ray, c, l, n, stretch.x + 0.5 * span);
        vec2 end = rootPassed(ray, c, l, n, stretch.y);
        slope = middle * 4.0 - start * 3.0 - end;
        bend = (start + end - middle * 2.0) * 2.0;
    }
    float high = ray.height + (ray.falling + ray.bulge * stretch.x) * stretch.x;
    float falling = (ray.falling + 2.0 * ray.bulge * stretch.x) * span;
    float bulge = ray.bulge * span * span;

    float u = 0.0;
    vec2 q = start;
    float h = high;
    float met = 2.0;
    vec2 cell = floor(start);
    for (int i = 0; i < cells; ++i) {
        // Advance to just behind the nearest side of the cell.
        vec2 way = slope + bend * (2.0 * u);
        vec2 base = floor(q);
        vec2 room = vec2(way.x < 0.0 ? q.x - base.x : base.x + 1.0 - q.x,
                         way.y < 0.0 ? q.y - base.y : base.y + 1.0 - q.y);
        vec2 need = (room + 0.001) / max(abs(way), vec2(1.0e-6));
        float w = min(u + min(need.x, need.y), 1.0);
        vec2 next = start + (slope + bend * w) * w;
        float deep = high + (falling + bulge * w) * w;
        cell = floor((q + next) * 0.5);
        RootedStrand s = strandOfCell(l, cell, c.jitter);
        float own = c.widest * (1.0 - c.girths * s.girth);
        float reach = mix(c.leastLength, 1.0, s.rank);
        float top = drawnHeight(c, reach, own, fractBelowOne(s.tint + c.shuffle));
        float entry = strandEntry(c, l, q - cell - 0.5 - s.offset, next - q, vec2(h, deep), reach, top, own);
        if (s.rooted && top > 0.0) met = entry <= 1.0 ? mix(u, w, entry) : 2.0;
        if (met <= 1.0 || w >= 1.0) break;
        u = w;
        q = next;
        h = deep;
    }

    MetStrand found;
    found.met = met <= 1.0;
    found.strand.offset = vec2(0.0);
    found.strand.along = 0.0;
    found.strand.rank = 0.0;
    found.strand.tint = 0.0;
    found.strand.girth = 0.0;
    found.strand.rooted = false;
    found.radius = 1.0;
    found.height = 0.0;
    found.t = 0.0;
    if (met <= 1.0) {
        found.strand = strandOfCell(l, cell, c.jitter);
        found.strand.offset = start + (slope + bend * met) * met - cell - 0.5 - found.strand.offset;
        found.strand.along = -dot(found.strand.offset, l.slope);
        found.height = high + (falling + bulge * met) * met;
        float own = c.widest * (1.0 - c.girths * found.strand.girth);
        float left = 1.0 - found.height / mix(c.leastLength, 1.0, found.strand.rank);
        found.radius = max(sqrt(squaredRadius(c, left, own)), c.pixel);
        found.t = stretch.x + span * met;
    }
    return found;
}
