// Strands of a coat: roots, thickness and bending. Lengths in meters on the skin at rest; heights along a strand from 0
// (skin) to 1 (tip of the longest).
//
// Roots lie on a lattice, one per cell, in the coordinate plane that the surface faces most (Lagae and Dutre 2005 hash
// cells the same way). A cell seen at an angle covers more surface. So cells are dropped at random where the surface
// faces its plane directly: the density is the same everywhere, on any mesh, without poles or seams.
//
// GLSL 4.50 and C++ (exhibits/fur/strand_cpu.h).

const int STRAND_MATRIX_MIX = 0;
const int STRAND_NLERP = 1;
const int STRAND_SLERP = 2;

struct Strand {
    vec3 offset;        // from the root to the point, in the surface's tangent plane
    float rank;         // [0, 1), determines the strand's length
    float tint;         // [0, 1), determines its color and other variation
    bool rooted;        // false: the cell contains no strand
};

// Lattice of the roots near a point of the skin, in the form that a ray through many cells needs.
struct StrandLattice {
    int axis;           // axis of the plane's normal
    vec2 slope;         // slope of the surface relative to the plane
    float facing;       // 1 if the surface faces the plane, at least 1/sqrt(3)
    uint layer;         // the two sides of a body have separate lattices
};

// A strand relative to its lattice: lengths in cells.
struct RootedStrand {
    vec2 offset;        // on the plane, from the root
    float along;        // along the plane's normal, so that the offset stays in the surface's tangent plane
    float rank;
    float tint;
    float girth;        // [0, 1), determines its thickness
    bool rooted;
};

// Size of cells that give `density` strands per square meter, with one strand in each kept cell.
float strandCellSize(float density)
{
    return inversesqrt(1.7320508075688772 * density);
}

// Returns the lattice for the skin's unit normal `n`.
StrandLattice strandLattice(vec3 n, uint seed)
{
    vec3 a = abs(n);
    StrandLattice l;
    l.axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    l.slope = l.axis == 0 ? vec2(n.y, n.z) / n.x : l.axis == 1 ? vec2(n.z, n.x) / n.y : vec2(n.x, n.y) / n.z;
    l.facing = l.axis == 0 ? a.x : l.axis == 1 ? a.y : a.z;
    bool behind = l.axis == 0 ? n.x < 0.0 : l.axis == 1 ? n.y < 0.0 : n.z < 0.0;
    l.layer = seed + uint(2 * l.axis + (behind ? 1 : 0));
    return l;
}

// Returns the two coordinates of `v` in the lattice's plane.
vec2 onLattice(StrandLattice l, vec3 v)
{
    return l.axis == 0 ? vec2(v.y, v.z) : l.axis == 1 ? vec2(v.z, v.x) : vec2(v.x, v.y);
}

// Returns the strand of a cell, given by its lower corner. `offset` is the position of its root relative to the cell's
// center. `jitter` 0 to 1: how far roots deviate from the center.
RootedStrand strandOfCell(StrandLattice l, vec2 cell, float jitter)
{
    uvec3 bits = pcg3d(uvec3(uint(int(cell.x)), uint(int(cell.y)), l.layer));
    RootedStrand s;
    s.offset = (vec2(unitFromBits(bits.x), unitFromBits(bits.y)) - 0.5) * jitter;
    s.along = 0.0;
    s.rank = unitFromBits(bits.z);
    // The low halves of words whose high halves give the root's place and the rank. Their correlation is not visible.
    s.tint = float(bits.x & 65535u) * (1.0 / 65536.0);
    s.girth = float(bits.z & 65535u) * (1.0 / 65536.0);
    s.rooted = float(bits.y & 65535u) * (1.0 / 65536.0) * l.facing < 0.5773502691896258;
    return s;
}

// Returns the strand of the cell that contains `q`, relative to `q`. `q` is on the lattice's plane, in cells.
RootedStrand strandInCell(StrandLattice l, vec2 q, float jitter)
{
    vec2 cell = floor(q);
    RootedStrand s = strandOfCell(l, cell, jitter);
    s.offset = q - cell - 0.5 - s.offset;
    s.along = -(s.offset.x * l.slope.x + s.offset.y * l.slope.y);
    return s;
}

// Returns the vector from the root to the point, meters.
vec3 strandOffset(StrandLattice l, RootedStrand s, float cellSize)
{
    vec3 cells = l.axis == 0 ? vec3(s.along, s.offset.x, s.offset.y)
               : l.axis == 1 ? vec3(s.offset.y, s.along, s.offset.x) : vec3(s.offset.x, s.offset.y, s.along);
    return cells * cellSize;
}

// Returns the strand of the cell that contains `q`. `q`: on the skin, `n`: unit normal there.
Strand strandAt(vec3 q, vec3 n, float cellSize, float jitter, uint seed)
{
    StrandLattice l = strandLattice(n, seed);
    RootedStrand found = strandInCell(l, onLattice(l, q) / cellSize, jitter);
    Strand s;
    s.offset = strandOffset(l, found, cellSize);
    s.rank = found.rank;
    s.tint = found.tint;
    s.rooted = found.rooted;
    return s;
}

// Radius at height `h`, relative to that at the root, of a strand that ends at `end`. `roundness` 0 gives a cone,
// towards 1 a cylinder with a blunt tip. 0 beyond the tip.
float strandTaper(float h, float end, float roundness)
{
    if (!(h < end)) return 0.0;
    return powPositive(1.0 - h / end, 1.0 - roundness);
}

// Half Lambert: 1 where a surface faces the light, 1/4 beyond the terminator (Mitchell, McTaggart and Green 2006,
// "Shading in Valve's Source Engine", with the cosine clamped).
float halfLambert(float cosine)
{
    float facing = max(cosine, 0.0) * 0.5 + 0.5;
    return facing * facing;
}

// Share of the ambient light at height `h` of a coat: 0 at the root, 1 at the tip, raised by `bias`. A larger
// `attenuation` extends the dark part upwards.
float coatOcclusion(float h, float attenuation, float bias)
{
    return clamp(powPositive(h, attenuation) + bias, 0.0, 1.0);
}

// Angle between unit vectors, accurate near 0 and pi, unlike the arc cosine.
float angleBetween(vec3 a, vec3 b)
{
    return 2.0 * angleOf(length(a - b), length(a + b));
}

// Returns a unit vector perpendicular to unit `n`; deterministic.
vec3 perpendicularTo(vec3 n)
{
    return abs(n.x) < 0.6 ? safeNormalize(cross(n, vec3(1.0, 0.0, 0.0)), vec3(0.0, 1.0, 0.0))
                          : safeNormalize(cross(n, vec3(0.0, 1.0, 0.0)), vec3(0.0, 0.0, 1.0));
}

// Direction of a strand that leaves the skin along `root` and ends along `tip` (unit vectors), after share `k` (0 to 1)
// of the rotation. The mix shortens the vector, down to 0 at 180 degrees. nlerp keeps the length but not the angular
// speed; slerp (Shoemake 1985) keeps both. At 180 degrees slerp and nlerp choose one way of many, always the same.
vec3 strandDirection(vec3 root, vec3 tip, float k, int model)
{
    vec3 mixed = root * (1.0 - k) + tip * k;
    if (model == STRAND_MATRIX_MIX) return mixed;
    if (model == STRAND_NLERP) return safeNormalize(mixed, perpendicularTo(root));
    float theta = angleBetween(root, tip);
    if (theta < 1.0e-3) return safeNormalize(mixed, root);
    vec3 across = safeNormalize(tip - root * dot(root, tip), perpendicularTo(root));
    return root * cos(k * theta) + across * sin(k * theta);
}

// Point at height `h` of a strand of length 1, relative to its root: the integral of its direction, by 4-point
// Gauss-Legendre quadrature. `curvature`: how late it bends; the share of the rotation at height h is h^curvature.
vec3 strandPoint(vec3 root, vec3 tip, float h, float curvature, int model)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        float x = i == 0 ? 0.0694318442029737
                : i == 1 ? 0.3300094782075719 : i == 2 ? 0.6699905217924281 : 0.9305681557970263;
        float w = i == 0 || i == 3 ? 0.1739274225687269 : 0.3260725774312731;
        sum += strandDirection(root, tip, powPositive(h * x, curvature), model) * w;
    }
    return sum * h;
}

// Rotates `v` by a unit quaternion (x, y, z, w).
vec3 turned(vec4 q, vec3 v)
{
    vec3 axis = vec3(q.x, q.y, q.z);
    vec3 t = cross(axis, v) * 2.0;
    return v + t * q.w + cross(axis, t);
}

// Tip direction of a strand pressed against a plane that is `gap` strand lengths away from its root: rotated until the
// tip is no deeper. `away`: the plane's unit normal on the free side.
vec3 strandPressed(vec3 root, vec3 tip, vec3 away, float gap)
{
    float deepest = clamp(gap, 0.0, 1.0);
    float depth = -dot(tip, away);
    if (depth <= deepest) return tip;
    vec3 along = tip + away * depth;
    vec3 outwards = root - away * dot(root, away);
    vec3 side = safeNormalize(along + outwards * 0.5, perpendicularTo(away));
    return side * safeSqrt(1.0 - deepest * deepest) - away * deepest;
}
