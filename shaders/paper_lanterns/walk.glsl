// Traversal of the lattice of lanterns by a ray. GLSL 4.50 and C++ (exhibits/paper_lanterns/paper_lanterns_cpu.h). The
// including file provides lantern.glsl, `Lantern lanternAt(ivec2 cell)`, which reads the result of `lanternOfCell`, and
//
//     LanternWalk withPoint(LanternWalk, LanternRay, Lantern, float near)
//     LanternWalk withAir(LanternWalk, LanternRay, Lantern, float near)
//
// These add a lantern that is only a glowing point, and the light of a lantern in the air. `near` is the distance along
// the ray of its closest approach to the lantern's axis.
//
// The ray passes rows of cells across its main direction. It moves sideways by at most one cell while it crosses a row.
// So it can only touch the two cells whose centers are nearest to it there. Each lantern stays within its cell, and is
// marched only inside its own bounds. So no step is too long, whatever the neighbors are.

struct LanternRay {
    vec3 origin;
    vec3 direction;  // unit
    float from;
    float to;
    vec2 width;      // width of its cone at the origin, across and up, ...
    vec2 spread;     // ... and its growth per meter
};

struct LanternWalk {
    float distance;   // distance to the nearest solid lantern; beyond the ray's end: none
    int part;
    Lantern lantern;  // that lantern
    vec3 local;       // hit point in its own space
    vec3 glow;        // radiance of the glowing points in front of it
    float left;       // transmittance of these points
    float cells;      // number of cells searched
    float end;        // distance along the ray up to which lanterns were searched
};

#ifndef __cplusplus
LanternWalk withPoint(LanternWalk walk, LanternRay ray, Lantern l, float near);
LanternWalk withAir(LanternWalk walk, LanternRay ray, Lantern l, float near);
#endif

vec2 coneWidth(LanternRay ray, float t)
{
    return ray.width + ray.spread * max(t, 0.0);
}

// Distance along the ray of its closest approach to a lantern's axis.
float nearestApproach(LanternRay ray, Lantern l)
{
    vec2 d = vec2(ray.direction.x, ray.direction.z);
    return dot(vec2(l.place.x - ray.origin.x, l.place.z - ray.origin.z), d) / max(dot(d, d), 1.0e-9);
}

// Marches a ray within the bounds of one lantern.
LanternWalk withSolid(LanternWalk before, LanternRay ray, Lantern l)
{
    LanternWalk walk = before;
    mat3 axes = lakeFromLantern(l);
    vec3 o = (ray.origin - l.place) * axes;
    vec3 d = ray.direction * axes;
    float near = max(nearestApproach(ray, l), ray.from);
    vec2 widths = coneWidth(ray, near);
    float margin = lake.tolerance * min(widths.x, widths.y) + 1.0e-4;
    vec2 span = lanternSpan(o, d, margin);
    float t = max(span.x, ray.from);
    float end = min(span.y, walk.distance);
    // Within the tolerance a ray may still pass by. It continues with at least half of that, or half of the thinnest
    // part, until it touches or reaches the step limit.
    float touch = 0.05 * margin + 1.0e-4;
    float thinnest = min(min(lake.paperHalf, lake.baseHalfHeight), min(lake.ringRadius, lake.postRadius));
    float least = 0.25 * min(margin, thinnest);
    for (int i = 0; i < lake.stepLimit && t < end; ++i) {
        LanternPoint f = lanternField(o + d * t);
        if (f.distance < (i + 1 < lake.stepLimit ? touch : margin)) {
            walk.distance = t;
            walk.part = f.part;
            walk.lantern = l;
            walk.local = o + d * t;
            break;
        }
        t += max(f.distance, least);
    }
    return walk;
}

LanternWalk withLantern(LanternWalk before, LanternRay ray, Lantern l)
{
    LanternWalk walk = before;
    walk.cells += 1.0;
    if (l.light < 0.0) return walk;
    float approach = nearestApproach(ray, l);
    vec2 widths = coneWidth(ray, clamp(approach, ray.from, walk.distance));
    walk = withAir(walk, ray, l, approach);
    if (max(widths.x, widths.y) > lake.pointWidth) return withPoint(walk, ray, l, approach);
    return withSolid(walk, ray, l);
}

// The released lantern.
Lantern releasedLantern()
{
    Lantern l;
    l.place = vec3(lake.released.x, lake.released.y, lake.released.z);
    l.tilt = vec2(lake.releasedPose.x, lake.releasedPose.y);
    l.turn = lake.releasedPose.z;
    l.light = lake.released.w;
    l.hue = lake.releasedPose.w;
    l.glow = lake.releasedGlow;
    return l;
}

// Interval in which o + d t is at most `limit`: first and last t.
vec2 belowSpan(float o, float d, float limit)
{
    if (abs(d) < 1.0e-12) return o <= limit ? vec2(-1.0e9, 1.0e9) : vec2(1.0, -1.0);
    float t = (limit - o) / d;
    return d > 0.0 ? vec2(-1.0e9, t) : vec2(t, 1.0e9);
}

// Interval of a ray in which its cone may hit lanterns of the lattice; none if first > last.
vec2 latticeSpan(LanternRay ray)
{
    vec2 size = vec2(float(lake.cells.x), float(lake.cells.y)) * lake.cell;
    vec2 x = slabSpan(ray.origin.x, ray.direction.x, lake.corner.x, lake.corner.x + size.x);
    vec2 z = slabSpan(ray.origin.z, ray.direction.z, lake.corner.y - size.y, lake.corner.y);
    float grown = 0.5 * ray.width.y;
    float grows = 0.5 * ray.spread.y;
    vec2 under = belowSpan(ray.origin.y - grown, ray.direction.y - grows, lake.high);
    vec2 over = belowSpan(-ray.origin.y - grown, -ray.direction.y - grows, -lake.low);
    return vec2(max(max(max(x.x, z.x), max(under.x, over.x)), ray.from),
                min(min(min(x.y, z.y), min(under.y, over.y)), ray.to));
}

// Row by row traversal: the cells of a row whose centers are nearest to the ray.
struct LatticeLine {
    bool alongX;   // rows are crossed along x; otherwise along z
    float origin;  // in cells, along the direction of the rows and across it; both grow with the cell's number
    float across;
    float ahead;   // cells per meter of the ray
    float aside;
    int first;     // first row on the ray's path
    int stride;    // step from row to row, 1 or -1
};

LatticeLine latticeLine(LanternRay ray, float from)
{
    LatticeLine line;
    vec3 o = ray.origin;
    vec3 d = ray.direction;
    vec2 start = vec2(o.x - lake.corner.x, lake.corner.y - o.z) / lake.cell;
    vec2 way = vec2(d.x, -d.z) / lake.cell;
    line.alongX = abs(way.x) > abs(way.y);
    line.origin = line.alongX ? start.x : start.y;
    line.across = line.alongX ? start.y : start.x;
    line.ahead = line.alongX ? way.x : way.y;
    line.aside = line.alongX ? way.y : way.x;
    if (abs(line.ahead) < 1.0e-7) line.ahead = 1.0e-7;
    line.stride = line.ahead > 0.0 ? 1 : -1;
    int rows = line.alongX ? lake.cells.x : lake.cells.y;
    line.first = clamp(int(floor(line.origin + line.ahead * from)), 0, rows - 1);
    return line;
}

ivec2 lineCell(LatticeLine line, int row, int which)
{
    float t = (float(row) + 0.5 - line.origin) / line.ahead;
    int low = int(floor(clamp(line.across + line.aside * t, -1.0e6, 1.0e6) - 0.5 * float(lake.looks - 1)));
    // The cell on the side that the ray comes from is first.
    int column = low + (line.aside >= 0.0 ? which : lake.looks - 1 - which);
    return line.alongX ? ivec2(row, column) : ivec2(column, row);
}

bool inLattice(ivec2 cell)
{
    return cell.x >= 0 && cell.y >= 0 && cell.x < lake.cells.x && cell.y < lake.cells.y;
}

LanternWalk nothingMet(LanternRay ray)
{
    LanternWalk walk;
    walk.distance = ray.to;
    walk.part = PART_NONE;
    walk.lantern = releasedLantern();
    walk.local = vec3(0.0);
    walk.glow = vec3(0.0);
    walk.left = 1.0;
    walk.cells = 0.0;
    walk.end = ray.to;
    return walk;
}

// Finds all lanterns along a ray, the nearest first.
LanternWalk walkLanterns(LanternRay ray)
{
    LanternWalk walk = nothingMet(ray);
    vec2 span = latticeSpan(ray);
    LatticeLine line = latticeLine(ray, span.x);
    int rows = line.alongX ? lake.cells.x : lake.cells.y;
    // Lanterns that light the air are also searched in the rows before and behind.
    int further = lake.looks > 2 ? 1 : 0;
    line.first -= further * line.stride;
    int looks = span.x < span.y ? lake.looks * (min(lake.rowLimit, rows) + 2 * further) : 0;
    int row = line.first;
    int which = 0;
    // The released lantern is tested first.
    for (int i = lake.released.w < 0.0 ? 0 : -1; i < looks; ++i) {
        Lantern l = releasedLantern();
        if (i >= 0) {
            int reached = row - further * line.stride;
            float entry = (float(reached) + (line.stride > 0 ? 0.0 : 1.0) - line.origin) / line.ahead;
            if (entry > min(span.y, walk.distance) || walk.left < 0.004) break;
            vec2 widths = coneWidth(ray, entry);
            if (widths.x * widths.y > lake.meanWidth * lake.meanWidth) {
                walk.end = max(entry, ray.from);
                return walk;
            }
            ivec2 cell = lineCell(line, row, which);
            l.light = -1.0;
            if (inLattice(cell)) l = lanternAt(cell);
            which = which + 1 < lake.looks ? which + 1 : 0;
            row += which == 0 ? line.stride : 0;
        }
        walk = withLantern(walk, ray, l);
    }
    float last = float(line.first + (min(lake.rowLimit, rows) + further) * line.stride) + (line.stride > 0 ? 0.0 : 1.0);
    walk.end = span.x < span.y ? min((last - line.origin) / line.ahead, span.y) : ray.from;
    return walk;
}

// Traversal of the reference: steps by the least distance to the lanterns of some cells around each point, ignoring
// lanterns beyond them. `kind` is REPEAT_OWN_CELL, REPEAT_2X2 or REPEAT_3X3. Used as a control, and to show the
// reference.
LanternWalk walkNeighbors(LanternRay ray, int kind, int steps)
{
    LanternWalk walk = nothingMet(ray);
    if (lake.released.w >= 0.0) walk = withSolid(walk, ray, walk.lantern);
    LanternWalk first = walk;
    vec2 y = slabSpan(ray.origin.y, ray.direction.y, lake.low, lake.high);
    float t = max(y.x, ray.from);
    int looks = kind == REPEAT_OWN_CELL ? 1 : (kind == REPEAT_2X2 ? 4 : 9);
    for (int i = 0; i < steps && t < min(y.y, first.distance); ++i) {
        vec3 p = ray.origin + ray.direction * t;
        vec2 g = vec2(p.x - lake.corner.x, lake.corner.y - p.z) / lake.cell;
        ivec2 own = ivec2(int(floor(clamp(g.x, -1.0e6, 1.0e6))), int(floor(clamp(g.y, -1.0e6, 1.0e6))));
        ivec2 towards = ivec2(g.x - float(own.x) < 0.5 ? -1 : 1, g.y - float(own.y) < 0.5 ? -1 : 1);
        // Without a lantern nearby, a step reaches at most the next cells.
        float nearest = lake.cell;
        float margin = lake.tolerance * ray.spread.x * t + 1.0e-4;
        for (int j = 0; j < looks; ++j) {
            ivec2 cell = own + (kind == REPEAT_3X3 ? ivec2(j % 3 - 1, j / 3 - 1) : ivec2(j & 1, j >> 1) * towards);
            Lantern l = lanternAt(inLattice(cell) ? cell : ivec2(0));
            if (!inLattice(cell) || l.light < 0.0) continue;
            vec3 local = (p - l.place) * lakeFromLantern(l);
            LanternPoint f = lanternField(local);
            if (f.distance >= nearest) continue;
            nearest = f.distance;
            walk.part = f.part;
            walk.lantern = l;
            walk.local = local;
        }
        walk.cells += float(looks);
        if (nearest < margin) {
            walk.distance = t;
            return walk;
        }
        t += nearest;
    }
    return first;
}
