// Solid that morphs from a torus into a mug and back: one body with one hole at every moment.
//
// A mixture of the two distance fields would show the mug's thin wall only in the last few percent. Instead this
// follows the deformation that topologists draw. The tube swells on one side into a solid cup while the rest of the
// ring shrinks to its handle; then the top sinks in and leaves the wall standing. The hole of the torus becomes the
// hole of the handle and never closes; its axis stays parallel to z.
//
// All shapes in between are unions and subtractions of 1-Lipschitz fields, hence a bound, 1-Lipschitz for every morph.
// At morph 0 the field is `sdfTorus` itself (exact); at 1, `sdfMug`.
//
// Frame: y up. The torus stands upright around the z axis, its center at the origin. During the morph, the solid is
// moved so that it stays on the same ground, y = -(majorRadius + minorRadius), and centered on x = z = 0. A linear
// morph already looks eased, because its phases are.
//
// GLSL 4.50 and C++ (exhibits/sdf_morph/torus_mug_cpu.h).

#ifndef __cplusplus
#include "lib/bindings.glsl"
#include "sdf_morph/torus_mug_shape_block.glsl"
#include "lib/numerics.glsl"
#include "lib/sdf.glsl"
#include "lib/sdf_operators.glsl"
#endif

// Lowest point of the shape, relative to the body's center.
float torusMugBottom(TorusMugShape s)
{
    return min(s.ringCenter.y - s.ringRadius - s.ringStretch - s.ringTube,
               min(-s.bodyHalfHeight, s.footHeight - s.footTube));
}

// Height of the foot's bead under the rounded bottom, sunk by `sunk` times its radius into the body.
float torusMugFootHeight(TorusMugShape s, float sunk)
{
    float below = min(s.bodyRoundingBelow, min(s.bodyRadius, s.bodyHalfHeight));
    float over = clamp(s.footRadius - (s.bodyRadius - below), 0.0, below);
    return below - safeSqrt((below - over) * (below + over)) + sunk * s.footTube - s.bodyHalfHeight;
}

// Translation that puts the shape on the ground and centers it.
vec3 torusMugStand(TorusMugShape s, float ground)
{
    float reach = s.ringRadius + s.ringTube;
    float left = min(s.ringCenter.x - reach, -s.bodyRadius);
    float right = max(s.ringCenter.x + reach, s.bodyRadius);
    return vec3(-0.5 * (left + right), ground - torusMugBottom(s), 0.0);
}

// Shape of the torus, with a cup hidden in the left of its tube.
TorusMugShape torusShape(TorusMug m)
{
    TorusMugShape s;
    s.morph = 0.0;
    s.bodyRadius = 0.5 * m.minorRadius;
    s.bodyHalfHeight = 0.5 * m.minorRadius;
    s.bodyRoundingAbove = s.bodyHalfHeight;
    s.bodyRoundingBelow = s.bodyHalfHeight;
    s.cavityRadius = 0.3 * m.mugRadius;
    s.cavityBottom = 0.5 * m.mugHeight + 2.0 * m.wallThickness + m.majorRadius + m.minorRadius;
    s.cavityRounding = s.cavityRadius;
    s.footRadius = 0.0;
    s.footHeight = 0.0;
    s.footTube = 0.0;
    s.ringCenter = vec2(m.majorRadius, 0.0);
    s.ringRadius = m.majorRadius;
    s.ringTube = m.minorRadius;
    s.ringStretch = 0.0;
    s.joint = 0.0;
    s.lip = m.wallThickness;
    s.bodyCenter = vec3(-m.majorRadius, 0.0, 0.0);
    return s;
}

// Shape of the mug.
TorusMugShape mugShape(TorusMug m)
{
    TorusMugShape s;
    float wall = min(m.wallThickness, m.mugRadius);
    s.morph = 1.0;
    s.footTube = 0.3 * wall;
    s.bodyRadius = m.mugRadius;
    s.bodyHalfHeight = 0.5 * m.mugHeight - 0.35 * s.footTube;
    s.bodyRoundingAbove = 0.5 * wall;
    s.bodyRoundingBelow = 0.36 * m.mugRadius;
    s.cavityRadius = m.mugRadius - wall;
    s.cavityBottom = 1.2 * wall - s.bodyHalfHeight;
    s.cavityRounding = max(s.bodyRoundingBelow - wall, 0.0);
    s.footRadius = 0.66 * m.mugRadius;
    s.footHeight = torusMugFootHeight(s, 0.3);
    s.ringTube = 0.5 * m.handleThickness;
    s.ringRadius = m.handleRadius;
    s.ringStretch = 0.3 * m.handleRadius;
    s.ringCenter = vec2(m.mugRadius + 0.5 * m.handleRadius, 0.04 * m.mugHeight);
    s.joint = m.blend;
    s.lip = wall;
    s.bodyCenter = torusMugStand(s, -(m.majorRadius + m.minorRadius));
    return s;
}

// Shape for `m.morph`, in three overlapping phases, each exactly 0 at morph 0 and exactly 1 at morph 1: the cup swells,
// the ring contracts, the cup is hollowed.
TorusMugShape torusMugShape(TorusMug m)
{
    float t = clamp(m.morph, 0.0, 1.0);
    TorusMugShape a = torusShape(m);
    TorusMugShape b = mugShape(m);
    if (t == 0.0) return a;
    if (t == 1.0) return b;

    float stretch = smoothStep(0.0, 0.5, t);  // The swelling runs along the tube first, then outward.
    float swell = smoothStep(0.0, 0.62, t);
    float draw = smoothStep(0.0, 0.8, t);
    float hollow = smoothStep(0.22, 1.0, t);
    float polish = smoothStep(0.55, 1.0, t);  // Edges become crisp only towards the end.
    float soft = 4.0 * t * (1.0 - t);         // Blends are wider during the morph.

    TorusMugShape s;
    s.morph = t;
    s.bodyRadius = lerpExact(a.bodyRadius, b.bodyRadius, swell);
    s.bodyHalfHeight = lerpExact(a.bodyHalfHeight, b.bodyHalfHeight, 0.5 * (stretch + swell));
    float blob = min(s.bodyRadius, s.bodyHalfHeight);
    s.bodyRoundingAbove = lerpExact(blob, b.bodyRoundingAbove, polish);
    s.bodyRoundingBelow = lerpExact(blob, b.bodyRoundingBelow, polish);
    s.cavityRadius = lerpExact(a.cavityRadius, b.cavityRadius, hollow);
    s.cavityBottom = lerpExact(a.cavityBottom, b.cavityBottom, hollow);
    s.cavityRounding = lerpExact(s.cavityRadius, b.cavityRounding, polish);
    s.footRadius = lerpExact(a.footRadius, b.footRadius, swell);
    s.footTube = lerpExact(a.footTube, b.footTube, polish);
    s.footHeight = torusMugFootHeight(s, lerpExact(2.0, 0.3, polish));
    s.ringCenter.x = lerpExact(a.ringCenter.x, b.ringCenter.x, draw);
    s.ringCenter.y = lerpExact(a.ringCenter.y, b.ringCenter.y, draw);
    s.ringRadius = lerpExact(a.ringRadius, b.ringRadius, draw);
    s.ringTube = lerpExact(a.ringTube, b.ringTube, draw);
    s.ringStretch = lerpExact(a.ringStretch, b.ringStretch, draw);
    s.joint = lerpExact(a.joint, b.joint, smoothStep(0.0, 0.3, t)) * (1.0 + 2.0 * soft);
    s.lip = lerpExact(a.lip, b.lip, hollow) * (1.0 + 2.0 * soft);
    s.bodyCenter = torusMugStand(s, -(m.majorRadius + m.minorRadius));
    return s;
}

// Cup, handle and foot of a shape; bound. `q` is relative to the body's center.
float sdfCupWithHandle(vec3 q, TorusMugShape s)
{
    vec2 profile = vec2(length(vec2(q.x, q.z)), q.y);
    vec2 halfSize = vec2(s.bodyRadius, s.bodyHalfHeight);
    float body = sdfRoundRectangle(profile, halfSize, s.bodyRoundingAbove, s.bodyRoundingBelow);
    float foot = length(profile - vec2(s.footRadius, s.footHeight)) - s.footTube;
    body = sdfSmoothUnion(body, foot, s.footTube);

    vec2 r = vec2(q.x, q.y) - s.ringCenter;
    float y = r.y - clamp(r.y, -s.ringStretch, s.ringStretch);
    float ring = length(vec2(length(vec2(r.x, y)) - s.ringRadius, q.z)) - s.ringTube;
    float solid = sdfSmoothUnion(body, ring, s.joint);

    // The cavity is open above: only walls, floor and the rounding between them matter.
    float rounding = min(s.cavityRounding, s.cavityRadius);
    vec2 c = vec2(profile.x - s.cavityRadius + rounding, s.cavityBottom + rounding - profile.y);
    float cavity = length(max(c, vec2(0.0))) + min(max(c.x, c.y), 0.0) - rounding;
    return sdfSmoothSubtraction(solid, cavity, s.lip);
}

// Exact. The torus at morph 0.
float sdfUprightTorus(vec3 p, TorusMug m)
{
    return sdfTorus(vec3(p.x, p.z, p.y), m.majorRadius, m.minorRadius);
}

// Bound. The mug at morph 1.
float sdfMug(vec3 p, TorusMug m)
{
    TorusMugShape s = mugShape(m);
    return sdfCupWithHandle(p - s.bodyCenter, s);
}

// Bound (exact at morph 0). `shape` comes from torusMugShape.
float sdfTorusMug(vec3 p, TorusMugShape shape)
{
    if (shape.morph <= 0.0) return sdfTorus(vec3(p.x, p.z, p.y), shape.ringRadius, shape.ringTube);
    return sdfCupWithHandle(p - shape.bodyCenter, shape);
}

// Box around the shape: center and half size. All of the solid lies inside.
struct TorusMugBox {
    vec3 center;
    vec3 halfSize;
};

TorusMugBox torusMugBox(TorusMugShape s)
{
    float bulge = 0.25 * s.joint;  // The most that a smooth union adds.
    float reach = s.ringRadius + s.ringTube;
    float top = max(s.ringCenter.y + reach + s.ringStretch, s.bodyHalfHeight);
    float bottom = torusMugBottom(s);
    float halfWidth = 0.5 * (max(s.ringCenter.x + reach, s.bodyRadius) - min(s.ringCenter.x - reach, -s.bodyRadius));
    TorusMugBox box;
    box.halfSize = vec3(halfWidth, 0.5 * (top - bottom), max(s.ringTube, s.bodyRadius)) + vec3(bulge);
    box.center = vec3(0.0, s.bodyCenter.y + 0.5 * (top + bottom), 0.0);
    return box;
}

// The same for all morphs: bounds of the mesh when the morph is animated.
TorusMugBox torusMugBoxOverMorph(TorusMug m)
{
    TorusMugShape a = torusShape(m);
    TorusMugShape b = mugShape(m);
    float bulge = 0.75 * m.blend;  // The widest joint is three times the blend.
    float reach = max(a.ringRadius + a.ringTube, b.ringRadius + b.ringTube);
    float height = 2.0 * max(reach + b.ringStretch + 0.5 * b.ringCenter.y, b.bodyHalfHeight + b.footTube);
    float width = max(a.ringCenter.x, b.ringCenter.x) + reach + max(reach, b.bodyRadius);
    TorusMugBox box;
    float depth = max(a.ringTube, max(b.ringTube, b.bodyRadius));
    box.halfSize = vec3(max(reach, 0.5 * width), 0.5 * height, depth) + vec3(bulge);
    box.center = vec3(0.0, 0.5 * height - (m.majorRadius + m.minorRadius), 0.0);
    return box;
}
