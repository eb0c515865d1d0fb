// Signed distance to solids, in meters: negative inside, positive outside.
//
// Each function says what it returns:
//   exact   the Euclidean distance to the surface, everywhere unless a region is named;
//   bound   never farther than the surface; 1-Lipschitz unless a constant is given.
// Sizes are not negative (the parameters' ranges and loaders ensure that). A size of zero gives the point, segment or
// disk that the solid shrinks to, and every finite input gives a finite distance.
//
// The formulas are known ones, mostly collected by Inigo Quilez ("Distance functions", 2008 to 2023),
// here rederived on the symmetric quarter or the profile in which each solid is simplest.
//
// GLSL 4.50 and C++ at float64 and float32 (render/glsl/cpu.h): no swizzles beyond one component, no
// `inout`, literals with a point. Tests: tests/stability.

// Far beyond any scene, yet its square still fits float32. Sizes are clamped to it before they are squared.
const float SDF_LARGEST = 1.0e15;
// Minimum of radii that are divided by (a thousandth of a millimeter).
const float SDF_SMALLEST = 1.0e-6;

float squaredLength(vec2 v)
{
    return dot(v, v);
}

float squaredLength(vec3 v)
{
    return dot(v, v);
}

// ---- Profiles: two-dimensional, for extruding and revolving --------------------------------------

// Exact. Rectangle around the origin.
float sdfRectangle(vec2 p, vec2 halfSize)
{
    vec2 q = abs(p) - halfSize;
    return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}

// Exact. Rectangle with corners rounded by `above` for y > 0 and `below` elsewhere; both are clamped to the half size.
// `halfSize` is that of the outline.
float sdfRoundRectangle(vec2 p, vec2 halfSize, float above, float below)
{
    float rounding = min(p.y > 0.0 ? above : below, min(halfSize.x, halfSize.y));
    return sdfRectangle(p, halfSize - vec2(rounding)) - rounding;
}

// Exact. Equilateral triangle around its center, a corner up; `inradius` is the distance from the center to an edge.
float sdfTriangleProfile(vec2 p, float inradius)
{
    float root3 = 1.7320508075688772;
    float halfEdge = inradius * root3;
    float x = abs(p.x) - halfEdge;
    float y = p.y + inradius;
    if (x + root3 * y > 0.0) {  // Closer to a slanted edge: reflect it onto the base.
        float folded = 0.5 * (x - root3 * y);
        y = -0.5 * (root3 * x + y);
        x = folded;
    }
    x -= clamp(x, -2.0 * halfEdge, 0.0);
    return y < 0.0 ? length(vec2(x, y)) : -length(vec2(x, y));
}

// ---- Solids --------------------------------------------------------------------------------------

// Exact. Sphere around the origin.
float sdfSphere(vec3 p, float radius)
{
    return length(p) - radius;
}

// Exact. Half-space below the plane with unit `normal` at `height` along it.
float sdfPlane(vec3 p, vec3 normal, float height)
{
    return dot(p, normal) - height;
}

// Exact. A box seen from one corner: `q` is the position relative to the corner, positive outside.
float sdfBoxCorner(vec3 q)
{
    return length(max(q, vec3(0.0))) + min(max(q.x, max(q.y, q.z)), 0.0);
}

// Exact. Box around the origin.
float sdfBox(vec3 p, vec3 halfSize)
{
    return sdfBoxCorner(abs(p) - halfSize);
}

// Exact. `halfSize` is that of the outside; `rounding` is clamped to its smallest component.
float sdfRoundBox(vec3 p, vec3 halfSize, float rounding)
{
    float r = min(rounding, min(halfSize.x, min(halfSize.y, halfSize.z)));
    return sdfBox(p, halfSize - vec3(r)) - r;
}

// Exact outside. The twelve edges of a box as square beams `thickness` wide, inside `halfSize`.
float sdfBoxFrame(vec3 p, vec3 halfSize, float thickness)
{
    float e = 0.5 * thickness;
    vec3 outer = abs(p) - halfSize;
    vec3 beam = abs(outer + vec3(e)) - vec3(e);
    float alongX = sdfBoxCorner(vec3(outer.x, beam.y, beam.z));
    float alongY = sdfBoxCorner(vec3(beam.x, outer.y, beam.z));
    float alongZ = sdfBoxCorner(vec3(beam.x, beam.y, outer.z));
    return min(alongX, min(alongY, alongZ));
}

// Exact. Ring around the y axis: `majorRadius` to the middle of the tube, `minorRadius` of the tube.
float sdfTorus(vec3 p, float majorRadius, float minorRadius)
{
    float ring = length(vec2(p.x, p.z)) - majorRadius;
    return length(vec2(ring, p.y)) - minorRadius;
}

// Exact. Arc in the xy plane, symmetric about +y, with round ends. `halfOpening` is the angle from +y to
// an end: 0 leaves a ball, pi closes the ring.
float sdfCappedTorus(vec3 p, float halfOpening, float majorRadius, float minorRadius)
{
    vec2 q = vec2(abs(p.x), p.y);
    vec2 end = vec2(sin(halfOpening), cos(halfOpening));
    bool abreast = end.y * q.x < end.x * q.y || halfOpening >= 3.14159;
    float flatDistance = abreast ? length(q) - majorRadius : length(q - end * majorRadius);
    return length(vec2(flatDistance, p.z)) - minorRadius;
}

// Exact. Chain link in the xy plane: a ring around z drawn apart along y by `halfLength` each way.
float sdfLink(vec3 p, float halfLength, float majorRadius, float minorRadius)
{
    float y = max(abs(p.y) - halfLength, 0.0);
    return length(vec2(length(vec2(p.x, y)) - majorRadius, p.z)) - minorRadius;
}

// Exact. Infinite cylinder around the y axis.
float sdfInfiniteCylinder(vec3 p, float radius)
{
    return length(vec2(p.x, p.z)) - radius;
}

// Exact. Cylinder around the y axis.
float sdfCylinder(vec3 p, float radius, float halfHeight)
{
    return sdfRectangle(vec2(length(vec2(p.x, p.z)), p.y), vec2(radius, halfHeight));
}

// Exact. Around the y axis; sizes are those of the outside, `rounding` is clamped to the smaller of them.
float sdfRoundCylinder(vec3 p, float radius, float halfHeight, float rounding)
{
    return sdfRoundRectangle(vec2(length(vec2(p.x, p.z)), p.y), vec2(radius, halfHeight), rounding, rounding);
}

// Exact. All points within `radius` of the segment ab; a ball where a = b.
float sdfCapsule(vec3 p, vec3 a, vec3 b, float radius)
{
    vec3 ab = b - a;
    float squared = dot(ab, ab);
    float along = squared > 0.0 ? clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
    return length(p - a - ab * along) - radius;
}

// Exact. Frustum around the y axis, `bottomRadius` at -halfHeight and `topRadius` at +halfHeight.
float sdfCappedCone(vec3 p, float halfHeight, float bottomRadius, float topRadius)
{
    float h = min(halfHeight, SDF_LARGEST);
    float bottom = min(bottomRadius, SDF_LARGEST);
    float top = min(topRadius, SDF_LARGEST);
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    vec2 toCap = vec2(max(q.x - (q.y < 0.0 ? bottom : top), 0.0), abs(q.y) - h);
    vec2 side = vec2(top - bottom, 2.0 * h);
    vec2 fromBottom = q - vec2(bottom, -h);
    float squared = squaredLength(side);
    vec2 toSide = fromBottom - side * (squared > 0.0 ? clamp(dot(fromBottom, side) / squared, 0.0, 1.0) : 0.0);
    bool inside = toCap.y < 0.0 && fromBottom.x * side.y < fromBottom.y * side.x;
    float distance2 = min(squaredLength(toCap), squaredLength(toSide));
    return inside ? -sqrt(distance2) : sqrt(distance2);
}

// Exact. Cone around the y axis standing on y = 0 with its tip at `height`.
float sdfCone(vec3 p, float radius, float height)
{
    float middle = 0.5 * min(height, SDF_LARGEST);
    return sdfCappedCone(p - vec3(0.0, middle, 0.0), middle, radius, 0.0);
}

// Exact. Convex hull of two balls on the y axis: `bottomRadius` at the origin, `topRadius` at `height`.
// If one ball contains the other, it is that ball.
float sdfRoundCone(vec3 p, float bottomRadius, float topRadius, float height)
{
    float lean = bottomRadius - topRadius;
    if (height <= abs(lean)) {
        return lean > 0.0 ? length(p) - bottomRadius : length(p - vec3(0.0, height, 0.0)) - topRadius;
    }
    float s = lean / height;            // Sine of the angle between the side and the axis.
    float c = sqrt((1.0 - s) * (1.0 + s));
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float along = q.y * c - q.x * s;    // Position along the side, from the bottom ball's tangent point.
    if (along < 0.0) return length(q) - bottomRadius;
    if (along > c * height) return length(q - vec2(0.0, height)) - topRadius;
    return q.x * c + q.y * s - bottomRadius;
}

// Bound when traced from outside, but steep: at an aspect of 7 its slope reaches 15 outside, and inside it is unbounded
// near the center. So it must not be mixed, blended, used for pruning or traced from inside. Returns -(smallest radius)
// at the center. Quilez 2008, gradient-scaled implicit form.
float sdfEllipsoid(vec3 p, vec3 radii)
{
    vec3 r = max(radii, vec3(SDF_SMALLEST));
    vec3 scaled = p / r;
    float level = length(scaled);
    float slope = length(scaled / r);
    if (!(slope > 1.0e-12)) return -min(r.x, min(r.y, r.z));
    return level * (level - 1.0) / slope;
}

// Bound. Ellipsoid that may be mixed, blended and pruned; too small by up to the aspect ratio.
float sdfEllipsoidBound(vec3 p, vec3 radii)
{
    vec3 r = max(radii, vec3(SDF_SMALLEST));
    return (length(p / r) - 1.0) * min(r.x, min(r.y, r.z));
}

// Exact. |x| + |y| + |z| <= radius.
float sdfOctahedron(vec3 p, float radius)
{
    vec3 a = abs(p);
    float excess = a.x + a.y + a.z - radius;
    // The nearest point is on the face unless the foot of the perpendicular has a negative coordinate;
    // then it is on the edge opposite that coordinate.
    vec3 q = a;
    if (3.0 * a.x < excess) q = a;
    else if (3.0 * a.y < excess) q = vec3(a.y, a.z, a.x);
    else if (3.0 * a.z < excess) q = vec3(a.z, a.x, a.y);
    else return excess * 0.57735026918962576;
    float along = clamp(0.5 * (q.z - q.y + radius), 0.0, radius);
    return length(vec3(q.x, q.y - radius + along, q.z - along));
}

// Exact. Regular hexagon in the xy plane (flat sides up and down, `inradius` from center to side), extruded along z.
float sdfHexPrism(vec3 p, float inradius, float halfHeight)
{
    vec2 fold = vec2(-0.86602540378443865, 0.5);
    vec2 q = vec2(abs(p.x), abs(p.y));
    q = q - fold * (2.0 * min(dot(fold, q), 0.0));
    float halfEdge = inradius * 0.57735026918962576;
    float toSide = length(q - vec2(clamp(q.x, -halfEdge, halfEdge), inradius));
    vec2 d = vec2(q.y < inradius ? -toSide : toSide, abs(p.z) - halfHeight);
    return length(max(d, vec2(0.0))) + min(max(d.x, d.y), 0.0);
}

// Exact. Equilateral triangle in the xy plane, a corner up, extruded along z.
float sdfTriangularPrism(vec3 p, float inradius, float halfHeight)
{
    vec2 d = vec2(sdfTriangleProfile(vec2(p.x, p.y), inradius), abs(p.z) - halfHeight);
    return length(max(d, vec2(0.0))) + min(max(d.x, d.y), 0.0);
}

// Exact. Intersection of a ball of `radius` with the cone of half angle `halfAngle` (0 to pi) around +y: a scoop.
float sdfSolidAngle(vec3 p, float halfAngle, float radius)
{
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    if (halfAngle >= 3.14159) return length(q) - radius;
    vec2 edge = vec2(sin(halfAngle), cos(halfAngle));
    float ball = length(q) - radius;
    float toSide = length(q - edge * clamp(dot(q, edge), 0.0, radius));
    return max(ball, q.x * edge.y > q.y * edge.x ? toSide : -toSide);
}

// Exact. Ball with everything above y = `height` cut off; |height| is clamped to the radius.
float sdfCutSphere(vec3 p, float radius, float height)
{
    float h = clamp(height, -radius, radius);
    float rim = sqrt((radius - h) * (radius + h));
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float ball = length(q) - radius;
    float face = q.y - h;
    bool towardBall = q.x * h >= rim * q.y;
    if (towardBall && (ball > 0.0 || face <= 0.0)) return max(ball, face);
    return q.x <= rim ? face : length(q - vec2(rim, h));
}

// Unsigned, exact. The triangle abc without thickness; round it to give it thickness. A triangle without area is its
// longest edge.
float sdfTriangle(vec3 p, vec3 a, vec3 b, vec3 c)
{
    vec3 normal = cross(b - a, c - a);
    float area2 = dot(normal, normal);
    bool above = area2 > 0.0 && dot(cross(b - a, normal), p - a) <= 0.0 && dot(cross(c - b, normal), p - b) <= 0.0 &&
                 dot(cross(a - c, normal), p - c) <= 0.0;
    if (above) return abs(dot(normal, p - a)) * inversesqrt(area2);
    return min(sdfCapsule(p, a, b, 0.0), min(sdfCapsule(p, b, c, 0.0), sdfCapsule(p, c, a, 0.0)));
}
