// The solids of an ice cream and their union, each evaluated only where it decides.
//
// What surrounds this file supplies `shape` (IceCreamShape), `fieldPart`, `solids` (counts the solids that were
// evaluated), and of the sprinkles sprinkleClear(cell), sprinkleFirst(cell), sprinkleEnd(cell), sprinkleStart(i) and
// sprinkleFinish(i), points with the number of a color. In C++ it is the body of a class: exhibits/ice_cream/ice_cream_cpu.h.
//
// Two functions of a point are made of them. The level is what the shape is defined by: its twisted layers are steeper
// than 1. The distance is a bound on the way to the surface, below the level wherever a twist makes that necessary.
// Every solid that is left out is one that a bound on its distance shows to change neither.

// The level and its pieces before candies are put on: kept apart, since only the cream is steep.
struct IceCreamCore {
    float wafer;  // Level of the wafer, or a bound on it where it changes nothing.
    float cream;  // The same of the cream.
    bool waferIsBound;
    bool creamIsBound;
    int part;
};

bool hasPart(int part)
{
    return ((shape.parts >> part) & 1) != 0;
}

// Exact. A cylinder around the y axis: radius, middle, half height.
float hullDistance(vec2 profile, vec4 hull)
{
    return sdfRectangle(profile - vec2(0.0, hull.y), vec2(hull.x, hull.z));
}

// ---- Wafer ---------------------------------------------------------------------------------------

// Exact. Frustum around the y axis between two heights.
float frustumDistance(vec3 p, float low, float high, float bottomRadius, float topRadius)
{
    solids += 1;
    return sdfCappedCone(p - vec3(0.0, 0.5 * (low + high), 0.0), 0.5 * (high - low), bottomRadius, topRadius);
}

// Exact. A ball around (0, bowl.y, 0) between two heights, both below its center or not.
float bowlDistance(vec2 profile, vec4 bowl)
{
    solids += 1;
    vec2 q = vec2(profile.x, profile.y - bowl.y);
    float low = bowl.z - bowl.y;
    float high = bowl.w - bowl.y;
    vec2 lowEdge = vec2(safeSqrt(bowl.x * bowl.x - low * low), low);
    vec2 highEdge = vec2(safeSqrt(bowl.x * bowl.x - high * high), high);
    float ball = length(q) - bowl.x;
    float inside = max(ball, max(low - q.y, q.y - high));
    if (inside <= 0.0) return inside;
    if (q.y < low && q.x <= lowEdge.x) return low - q.y;
    if (q.y > high && q.x <= highEdge.x) return q.y - high;
    // Seen from the center, between the two edges.
    bool abreast = q.y * lowEdge.x >= lowEdge.y * q.x && q.y * highEdge.x <= highEdge.y * q.x;
    if (abreast) return ball;
    return sqrt(min(squaredLength(q - lowEdge), squaredLength(q - highEdge)));
}

// Exact. Rings lie evenly along the side of the foot, so the nearest one is found without looking at the others.
float ringDistance(vec2 profile)
{
    solids += 1;
    vec2 bottom = vec2(shape.foot.x, 0.0);
    vec2 side = vec2(shape.foot.y, shape.foot.z) - bottom;
    float along = dot(profile - bottom, side) / max(dot(side, side), 1.0e-12);
    float count = float(shape.rings);
    float nearest = clamp(floor(along * (count + 1.0) + 0.5), 1.0, count) / (count + 1.0);
    return length(profile - bottom - side * nearest) - shape.ringTube;
}

// Exact. Bars stand evenly around the axis, each in a plane through it, so the nearest one is the one abreast.
float barDistance(vec3 p)
{
    solids += 1;
    float turn = 2.0 * PI / float(shape.bars);
    float angle = turn * floor(angleOf(p.z, p.x) / turn + 0.5);
    float c = cos(angle);
    float s = sin(angle);
    vec3 q = vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    return sdfCapsule(q, vec3(shape.foot.x, 0.0, 0.0), vec3(shape.foot.y, shape.foot.z, 0.0), shape.barRadius);
}

// The foot with its relief. `best` is what the rest of the wafer comes to.
float footLevel(vec3 p, vec2 profile, float best)
{
    float foot = hasPart(PART_FOOT) ? frustumDistance(p, 0.0, shape.foot.z, shape.foot.x, shape.foot.y) : 1.0e9;
    bool rings = hasPart(PART_RINGS) && shape.rings > 0;
    bool bars = hasPart(PART_BARS) && shape.bars > 0;
    if (!rings && !bars) {
        if (foot < best) fieldPart = PART_FOOT;
        return foot;
    }
    float blends = 0.25 * (shape.footBlend + shape.reliefBlend);
    // The relief stands out of the foot's surface by no more than its own thickness.
    if (hasPart(PART_FOOT) && foot - max(shape.ringTube, shape.barRadius) - blends >= best) return foot;
    float ring = rings ? ringDistance(profile) : 1.0e9;
    float bar = bars ? barDistance(p) : 1.0e9;
    float relief = rings && bars ? sdfSmoothUnion(ring, bar, shape.reliefBlend) : min(ring, bar);
    float level = hasPart(PART_FOOT) ? sdfSmoothUnion(relief, foot, shape.footBlend) : relief;
    if (level < best) fieldPart = foot < min(ring, bar) ? PART_FOOT : (ring < bar ? PART_RINGS : PART_BARS);
    return level;
}

// Foot, collar and bowl stand on one another: the one at the point's height first, the others where the gap to their
// own heights leaves them anything to say.
float waferLevel(vec3 p, vec2 profile)
{
    float best = 1.0e9;
    int first = p.y < shape.collar.z ? 0 : (p.y < shape.bowl.z ? 1 : 2);
    float relief = max(shape.ringTube, shape.barRadius) + 0.25 * (shape.footBlend + shape.reliefBlend);
    for (int k = 0; k < 3; ++k) {
        int piece = first + k < 3 ? first + k : first + k - 3;
        if (piece == 0) {
            if (p.y - shape.foot.z - relief < best) best = min(best, footLevel(p, profile, best));
        } else if (piece == 1) {
            if (hasPart(PART_COLLAR) && max(shape.collar.z - p.y, p.y - shape.collar.w) < best) {
                float collar = frustumDistance(p, shape.collar.z, shape.collar.w, shape.collar.x, shape.collar.y);
                if (collar < best) fieldPart = PART_COLLAR;
                best = min(best, collar);
            }
        } else if (hasPart(PART_BOWL) && max(shape.bowl.z - p.y, p.y - shape.bowl.w) < best) {
            float bowl = bowlDistance(profile, shape.bowl);
            if (bowl < best) fieldPart = PART_BOWL;
            best = min(best, bowl);
        }
    }
    return best;
}

// ---- Cream ---------------------------------------------------------------------------------------

// Exact. The first cone of a layer.
float lobeDistance(int layer, vec3 p)
{
    solids += 1;
    vec3 v = p - shape.layers[layer].foot;
    float along = dot(v, shape.layers[layer].axis);
    float away = length(v - shape.layers[layer].axis * along);
    return sdfCappedCone(vec3(away, along - shape.layers[layer].halfHeight, 0.0), shape.layers[layer].halfHeight,
                         shape.layers[layer].radius, 0.0) -
           shape.layers[layer].corner;
}

// Union of the two nearest cones of a layer, in its untwisted space. Cones are taken in the order in which balls that
// hold them lie around the axis; when the next ball is too far to hold one of the two nearest, the rest are.
float layerLevel(int layer, vec3 p)
{
    float twisted = shape.layers[layer].twist * p.y;
    float c = cos(twisted);
    float s = sin(twisted);
    vec3 q = vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    float blend = shape.layers[layer].blend;
    vec4 ball = shape.layers[layer].ball;
    float turn = 2.0 * PI / float(shape.layers[layer].lobes);
    float radius = length(vec2(q.x, q.z));
    float angle = (angleOf(q.z, q.x) - ball.z) / turn;
    float start = floor(angle + 0.5);
    float within = angle - start;
    float side = within < 0.0 ? -1.0 : 1.0;
    float nearest = 1.0e9;
    float second = 1.0e9;
    for (int k = 0; k < shape.layers[layer].lobes; ++k) {
        float steps = (k & 1) != 0 ? side * float((k + 1) / 2) : -side * float(k / 2);
        // Rounding of angles moves a ball by less than the last term.
        float apart = radius * radius + ball.x * ball.x - 2.0 * radius * ball.x * cos((within - steps) * turn) +
                      (q.y - ball.y) * (q.y - ball.y);
        if (safeSqrt(apart) - ball.w - 1.0e-3 >= min(second, nearest + blend)) break;
        float a = turn * (start + steps);
        float ca = cos(a);
        float sa = sin(a);
        float d = lobeDistance(layer, vec3(ca * q.x + sa * q.z, q.y, ca * q.z - sa * q.x));
        second = min(second, max(nearest, d));
        nearest = min(nearest, d);
    }
    return sdfSmoothUnion(nearest, second, blend);
}

// Union of the layers. A twist turns heights about the axis, so that it leaves every hull where it is.
float creamLevel(vec3 p, vec2 profile)
{
    float hulls[CREAM_LAYERS];
    for (int i = 0; i < CREAM_LAYERS; ++i)
        hulls[i] = hasPart(PART_CREAM + i) ? hullDistance(profile, shape.layers[i].hull) : 1.0e9;
    int first = hulls[0] <= hulls[1] ? 0 : 1;
    float level = 1.0e9;
    for (int k = 0; k < CREAM_LAYERS; ++k) {
        int layer = k == 0 ? first : 1 - first;
        if (!hasPart(PART_CREAM + layer) || hulls[layer] >= level + shape.layerBlend) continue;
        float d = layerLevel(layer, p);
        if (d < level) fieldPart = PART_CREAM + layer;
        level = sdfSmoothUnion(level, d, shape.layerBlend);
    }
    return level;
}

// How much steeper than 1 the cream is at most, at this radius: the largest singular value of a twist's derivative,
// a shear by twist times radius.
float twistSlope(float radius)
{
    float x = 0.5 * shape.steepest * min(radius, shape.outermost);
    return x + sqrt(1.0 + x * x);
}

// ---- Together ------------------------------------------------------------------------------------

IceCreamCore iceCreamCore(vec3 p)
{
    vec2 profile = vec2(length(vec2(p.x, p.z)), p.y);
    IceCreamCore core;
    bool anyWafer = (shape.parts & 31) != 0;
    bool anyCream = (shape.parts & 96) != 0;
    core.wafer = anyWafer ? hullDistance(profile, shape.waferHull) : 1.0e9;
    core.cream = 1.0e9;
    for (int i = 0; i < CREAM_LAYERS; ++i)
        if (hasPart(PART_CREAM + i)) core.cream = min(core.cream, hullDistance(profile, shape.layers[i].hull));
    core.waferIsBound = true;
    core.creamIsBound = true;
    core.part = PART_FOOT;
    bool creamFirst = core.cream < core.wafer;
    for (int k = 0; k < 2; ++k) {
        bool cream = (k == 0) == creamFirst;
        if (cream) {
            if (!anyCream || (k == 1 && core.cream >= core.wafer + shape.waferBlend)) continue;
            core.cream = creamLevel(p, profile);
            core.creamIsBound = false;
            if (k == 0 || core.cream < core.wafer) core.part = fieldPart;
        } else {
            if (!anyWafer || (k == 1 && core.wafer >= core.cream + shape.waferBlend)) continue;
            core.wafer = waferLevel(p, profile);
            core.waferIsBound = false;
            if (k == 0 || core.wafer < core.cream) core.part = fieldPart;
        }
    }
    return core;
}

float coreLevel(IceCreamCore core)
{
    return sdfSmoothUnion(core.wafer, core.cream, shape.waferBlend);
}

// A ball of this radius around p is free of the core, or inside it: wafer 1-Lipschitz, cream as steep as its twist.
// Each of the bounds holds by itself; where the two are blended the first is the best, elsewhere one of the others.
float coreDistance(IceCreamCore core, vec3 p)
{
    float blend = shape.waferBlend;
    float level = coreLevel(core);
    if (core.creamIsBound) return core.waferIsBound ? min(core.wafer, core.cream) : min(core.wafer, core.cream - blend);
    float radius = length(vec2(p.x, p.z));
    float slope = twistSlope(radius + abs(level) / twistSlope(radius));
    if (level <= 0.0) return level / slope;
    float creamSlope = twistSlope(radius + max(core.cream, 0.0) / twistSlope(radius));
    float apart = min(core.wafer, (core.cream - blend) / creamSlope);
    float aside = min(core.wafer - blend, core.cream / creamSlope);
    float beside = min(core.wafer, core.cream / creamSlope) - 0.25 * blend;
    return max(level / slope, max(apart, max(aside, beside)));
}

// Exact.
float candyDistance(int i, vec3 p)
{
    solids += 1;
    vec3 v = p - shape.candies[i].center;
    vec3 x = shape.candies[i].axisX;
    vec3 y = shape.candies[i].axisY;
    return sdfRoundBox(vec3(dot(v, x), dot(v, y), dot(v, cross(x, y))), shape.candies[i].halfSize, shape.candies[i].corner);
}

// `d` united with the sprinkles: capsules in a grid. A cell lists those that come near it, and says how far all others
// are at least; its outermost cells list none.
float withSprinkles(vec3 p, float d)
{
    vec3 high = shape.gridLow + shape.gridCell * vec3(shape.gridCells);
    vec3 inside = clamp(p, shape.gridLow, high);
    float outside = length(p - inside);
    if (outside >= d) return d;
    vec3 last = vec3(shape.gridCells) - vec3(1.0);
    ivec3 at = ivec3(clamp(floor((inside - shape.gridLow) / shape.gridCell), vec3(0.0), last));
    int cell = (at.z * shape.gridCells.y + at.y) * shape.gridCells.x + at.x;
    float all = min(d, max(sprinkleClear(cell) - outside, outside));
    for (int i = sprinkleFirst(cell); i < sprinkleEnd(cell); ++i) {
        solids += 1;
        vec4 start = sprinkleStart(i);
        vec4 finish = sprinkleFinish(i);
        float one = sdfCapsule(p, vec3(start.x, start.y, start.z), vec3(finish.x, finish.y, finish.z), shape.sprinkleRadius);
        if (one < all) fieldPart = PART_SPRINKLE + int(start.w);
        all = min(all, one);
    }
    return all;
}

// `d` united with what lies on the cream and under the wafer: candies, sprinkles, plinth.
float withToppings(vec3 p, float d)
{
    for (int i = 0; i < CANDIES; ++i) {
        if (!hasPart(PART_CANDY + i) || length(p - shape.candies[i].center) - shape.candies[i].reach >= d) continue;
        float candy = candyDistance(i, p);
        if (candy < d) fieldPart = PART_CANDY + i;
        d = min(d, candy);
    }
    if (hasPart(PART_SPRINKLES)) d = withSprinkles(p, d);
    if (hasPart(PART_PLINTH) && p.y < d) {
        solids += 1;
        vec3 q = p + vec3(0.0, 0.5 * shape.plinth.y, 0.0);
        float plinth = sdfRoundCylinder(q, shape.plinth.x, 0.5 * shape.plinth.y, shape.plinth.z);
        if (plinth < d) fieldPart = PART_PLINTH;
        d = min(d, plinth);
    }
    return d;
}

float iceCreamLevel(vec3 p)
{
    IceCreamCore core = iceCreamCore(p);
    fieldPart = core.part;
    return withToppings(p, coreLevel(core));
}

float iceCreamDistance(vec3 p)
{
    IceCreamCore core = iceCreamCore(p);
    fieldPart = core.part;
    return withToppings(p, coreDistance(core, p));
}
