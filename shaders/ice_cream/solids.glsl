// Solids of an ice cream and their union. Each solid is evaluated only where it affects the result.
//
// The including code supplies `shape` (IceCreamShape), `fieldPart`, `solids` (counts the solids evaluated), `levelHere`
// and `unlisted`. For the sprinkles it supplies sprinkleClear(cell), sprinkleFirst(cell), sprinkleEnd(cell),
// sprinkleStart(i) with the number of a color, and sprinkleFinish(i). In C++ this file is the body of a class:
// exhibits/ice_cream/ice_cream_cpu.h.
//
// They define two functions of a point. The level defines the shape; its twisted layers have a slope above 1. The
// distance is a bound for marching, smaller than the level wherever a twist requires that. A solid is skipped only if a
// bound on its distance shows that it affects neither. Cheap upper bounds come first, so that the solids need no order:
// drivers that execute both sides of every branch evaluate each solid once.

// The level without candies, in two halves: only the cream is steep. A half that was skipped is a bound.
struct IceCreamCore {
    float wafer;
    float cream;
    bool waferIsBound;
    bool creamIsBound;
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

// Exact. Part of a ball around (0, bowl.y, 0) between two heights, which may both be below its center.
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
    // Seen from the center, the point lies between the two edges.
    bool abreast = q.y * lowEdge.x >= lowEdge.y * q.x && q.y * highEdge.x <= highEdge.y * q.x;
    if (abreast) return ball;
    return sqrt(min(squaredLength(q - lowEdge), squaredLength(q - highEdge)));
}

// Exact. Rings are evenly spaced along the side of the foot, so the nearest one is found directly.
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

// Exact. Bars are evenly spaced around the axis, each in a plane through it, so the nearest one has the nearest angle.
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

// Level of the foot with its relief. `best` is the level of the rest of the wafer.
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
    // The relief rises above the foot's surface by no more than its own thickness.
    if (hasPart(PART_FOOT) && foot - max(shape.ringTube, shape.barRadius) - blends >= best) return foot;
    float ring = rings ? ringDistance(profile) : 1.0e9;
    float bar = bars ? barDistance(p) : 1.0e9;
    float relief = rings && bars ? sdfSmoothUnion(ring, bar, shape.reliefBlend) : min(ring, bar);
    float level = hasPart(PART_FOOT) ? sdfSmoothUnion(relief, foot, shape.footBlend) : relief;
    if (level < best) fieldPart = foot < min(ring, bar) ? PART_FOOT : (ring < bar ? PART_RINGS : PART_BARS);
    return level;
}

// Upper bound on the distance to foot, collar and bowl, from cylinders inside them. A hundredth of a millimeter is
// added, or rounding would skip a solid whose two bounds coincide.
float waferAtMost(vec2 profile)
{
    float most = 1.0e9;
    if (hasPart(PART_FOOT)) {
        vec4 within = vec4(min(shape.foot.x, shape.foot.y), 0.5 * shape.foot.z, 0.5 * shape.foot.z, 0.0);
        most = hullDistance(profile, within);
    }
    if (hasPart(PART_COLLAR)) {
        vec4 within = vec4(min(shape.collar.x, shape.collar.y), 0.5 * (shape.collar.z + shape.collar.w),
                           0.5 * (shape.collar.w - shape.collar.z), 0.0);
        most = min(most, hullDistance(profile, within));
    }
    if (hasPart(PART_BOWL)) {
        float low = shape.bowl.z - shape.bowl.y;
        vec4 within = vec4(safeSqrt(shape.bowl.x * shape.bowl.x - low * low), 0.5 * (shape.bowl.z + shape.bowl.w),
                           0.5 * (shape.bowl.w - shape.bowl.z), 0.0);
        most = min(most, hullDistance(profile, within));
    }
    return most + 1.0e-5;
}

// Value of the field for the wafer; `most` is the upper bound from waferAtMost. Foot, collar and bowl stand on each
// other: the vertical gap to each bounds its distance.
float waferLevel(vec3 p, vec2 profile, float most)
{
    float level = 1.0e9;
    if (hasPart(PART_BOWL) && max(shape.bowl.z - p.y, p.y - shape.bowl.w) <= most) {
        level = bowlDistance(profile, shape.bowl);
        fieldPart = PART_BOWL;
    }
    if (hasPart(PART_COLLAR) && max(shape.collar.z - p.y, p.y - shape.collar.w) <= min(level, most)) {
        float collar = frustumDistance(p, shape.collar.z, shape.collar.w, shape.collar.x, shape.collar.y);
        if (collar < level) fieldPart = PART_COLLAR;
        level = min(level, collar);
    }
    float relief = max(shape.ringTube, shape.barRadius) + 0.25 * (shape.footBlend + shape.reliefBlend);
    if ((shape.parts & 25) != 0 && p.y - shape.foot.z - relief <= min(level, most))
        level = min(level, footLevel(p, profile, level));
    return level;
}

// ---- Cream ---------------------------------------------------------------------------------------

// Exact. The first cone of a layer.
float lobeDistance(CreamLayer layer, vec3 p)
{
    solids += 1;
    vec3 v = p - layer.foot;
    float along = dot(v, layer.axis);
    float away = length(v - layer.axis * along);
    return sdfCappedCone(vec3(away, along - layer.halfHeight, 0.0), layer.halfHeight, layer.radius, 0.0) - layer.corner;
}

// Union of the two nearest cones of a layer, in its untwisted space; `angle` is that of the point around the axis.
// Cones are visited in the order of their bounding balls around the axis. If the next ball is too far to contain one of
// the two nearest cones, so are the rest.
float layerLevel(CreamLayer layer, vec3 p, float angle)
{
    float turn = 2.0 * PI / float(layer.lobes);
    float twisted = layer.twist * p.y;
    float turns = (angle - twisted - layer.ballAngle) / turn;
    float start = floor(turns + 0.5);
    float side = turns < start ? -1.0 : 1.0;
    float nearest = 1.0e9;
    float second = 1.0e9;
    for (int k = 0; k < layer.lobes; ++k) {
        float steps = (k & 1) != 0 ? side * float((k + 1) / 2) : -side * float(k / 2);
        float a = twisted + turn * (start + steps);
        float c = cos(a);
        float s = sin(a);
        vec3 q = vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
        if (length(q - layer.ball) - layer.ballRadius >= min(second, nearest + layer.blend)) break;
        float d = lobeDistance(layer, q);
        second = min(second, max(nearest, d));
        nearest = min(nearest, d);
    }
    return sdfSmoothUnion(nearest, second, layer.blend);
}

// Upper bound on the level of a layer: the way through the axis to the middle of a cone at this height.
float layerAtMost(CreamLayer layer, vec2 profile)
{
    float length_ = 2.0 * layer.halfHeight;
    float rise = layer.axis.y * length_;
    float t = abs(rise) > 1.0e-6 ? clamp((profile.y - layer.foot.y) / rise, 0.0, 1.0) * length_ : 0.0;
    vec3 middle = layer.foot + layer.axis * t;
    return length(vec2(profile.x + length(vec2(middle.x, middle.z)), profile.y - middle.y));
}

// Union of the layers; `most` is an upper bound on the level of the other solids. A twist rotates around the axis, so
// that every hull stays in place.
float creamLevel(vec3 p, vec2 profile, vec2 hulls, float most)
{
    float angle = angleOf(p.z, p.x);
    float level = 1.0e9;
    float upper = hasPart(PART_CREAM + 1) ? layerAtMost(shape.layers[1], profile) : 1.0e9;
    if (hulls.x < min(most, upper) + shape.layerBlend) {
        level = layerLevel(shape.layers[0], p, angle);
        fieldPart = PART_CREAM;
    }
    if (hulls.y < level + shape.layerBlend && hulls.y < 1.0e8) {
        float d = layerLevel(shape.layers[1], p, angle);
        if (d < level) fieldPart = PART_CREAM + 1;
        level = sdfSmoothUnion(level, d, shape.layerBlend);
    }
    return level;
}

// Upper bound on the slope of the cream at this radius: the largest singular value of a twist's derivative, a shear by
// twist times radius.
float twistSlope(float radius)
{
    float x = 0.5 * shape.steepest * min(radius, shape.outermost);
    return x + sqrt(1.0 + x * x);
}

// ---- Together ------------------------------------------------------------------------------------

IceCreamCore iceCreamCore(vec3 p)
{
    vec2 profile = vec2(length(vec2(p.x, p.z)), p.y);
    vec2 hulls = vec2(hasPart(PART_CREAM) ? hullDistance(profile, shape.layers[0].hull) : 1.0e9,
                      hasPart(PART_CREAM + 1) ? hullDistance(profile, shape.layers[1].hull) : 1.0e9);
    IceCreamCore core;
    core.wafer = (shape.parts & 31) != 0 ? hullDistance(profile, shape.waferHull) : 1.0e9;
    core.cream = min(hulls.x, hulls.y);
    core.waferIsBound = true;
    core.creamIsBound = true;
    float most = waferAtMost(profile);
    if (core.cream < most + shape.waferBlend && core.cream < 1.0e8) {
        core.cream = creamLevel(p, profile, hulls, most + shape.waferBlend + 0.25 * shape.layerBlend);
        core.creamIsBound = false;
    }
    int part = fieldPart;
    if (core.wafer < (core.creamIsBound ? 1.0e8 : core.cream + shape.waferBlend)) {
        core.wafer = waferLevel(p, profile, most);
        core.waferIsBound = false;
    }
    if (!core.creamIsBound && core.cream <= core.wafer) fieldPart = part;
    return core;
}

float coreLevel(IceCreamCore core)
{
    return sdfSmoothUnion(core.wafer, core.cream, shape.waferBlend);
}

// Returns the radius of a ball around p that contains no surface of the core. The wafer is 1-Lipschitz; the cream's
// slope depends on its twist. The result is the largest of several bounds, each of which is valid everywhere: the first
// is the largest where wafer and cream blend, one of the others elsewhere.
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

// Exact. One of the candies, a rounded box.
float candyDistance(int i, vec3 p)
{
    solids += 1;
    vec3 v = p - shape.candies[i].center;
    vec3 x = shape.candies[i].axisX;
    vec3 y = shape.candies[i].axisY;
    vec3 q = vec3(dot(v, x), dot(v, y), dot(v, cross(x, y)));
    return sdfRoundBox(q, shape.candies[i].halfSize, shape.candies[i].corner);
}

// Unites `d` with the sprinkles nearby: capsules in a grid. A cell lists those that come near it, and a lower bound on
// the distance of all others, which becomes `unlisted`. The outermost cells list none.
float withSprinkles(vec3 p, float d)
{
    vec3 high = shape.gridLow + shape.gridCell * vec3(shape.gridCells);
    vec3 inside = clamp(p, shape.gridLow, high);
    float outside = length(p - inside);
    unlisted = outside;
    if (outside >= d) return d;
    vec3 last = vec3(shape.gridCells) - vec3(1.0);
    ivec3 at = ivec3(clamp(floor((inside - shape.gridLow) / shape.gridCell), vec3(0.0), last));
    int cell = (at.z * shape.gridCells.y + at.y) * shape.gridCells.x + at.x;
    unlisted = max(sprinkleClear(cell) - outside, outside);
    float all = d;
    for (int i = sprinkleFirst(cell); i < sprinkleEnd(cell); ++i) {
        solids += 1;
        vec4 start = sprinkleStart(i);
        vec4 finish = sprinkleFinish(i);
        vec3 a = vec3(start.x, start.y, start.z);
        vec3 b = vec3(finish.x, finish.y, finish.z);
        float one = sdfCapsule(p, a, b, shape.sprinkleRadius);
        if (one < all) fieldPart = PART_SPRINKLE + int(start.w);
        all = min(all, one);
    }
    return all;
}

// Unites `d` with the objects on the cream and under the wafer: candies, sprinkles, plinth.
float withToppings(vec3 p, float d)
{
    int near = 0;  // Bits of the candies that may be closer.
    for (int i = 0; i < CANDIES; ++i) {
        vec3 v = p - shape.candies[i].center;
        float reach = d + shape.candies[i].reach;
        if (reach > 0.0 && dot(v, v) < reach * reach) near |= 1 << i;
    }
    near &= shape.parts >> PART_CANDY;
    while (near != 0) {
        int i = findLSB(near);
        near &= near - 1;
        float candy = candyDistance(i, p);
        if (candy < d) fieldPart = PART_CANDY + i;
        d = min(d, candy);
    }
    if (hasPart(PART_SPRINKLES) && shape.gridCells.x > 0) d = withSprinkles(p, d);
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
    return withToppings(p, coreLevel(iceCreamCore(p)));
}

// Returns the distance; stores the level in `levelHere`.
float iceCreamDistance(vec3 p)
{
    IceCreamCore core = iceCreamCore(p);
    float level = coreLevel(core);
    unlisted = 1.0e9;
    levelHere = withToppings(p, level);
    float d = min(coreDistance(core, p), unlisted);
    return levelHere < level ? min(d, levelHere) : d;
}
