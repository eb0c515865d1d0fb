// Shapes of scene files that lib/sdf.glsl does not have: signed distance in meters, negative inside. "Exact" and
// "bound" are as there; everything is 1-Lipschitz. Sizes are not negative.
//
// The shapes are those of Inigo Quilez's collection ("Distance functions", 2008 to 2023), derived here on the half or
// the profile in which each is simplest. The ellipsoid is not from it.
//
// GLSL 4.50 and C++ (exhibits/sdf_scenes/scene_functions_cpu.h).

#ifndef __cplusplus
#include "lib/numerics.glsl"
#include "lib/sdf.glsl"
#endif

// Coordinates relative to the segment ab: distance from its line, then position along it, 0 in the middle.
vec2 sceneAlong(vec3 p, vec3 a, vec3 b)
{
    vec3 axis = safeNormalize(b - a, vec3(0.0, 1.0, 0.0));
    vec3 q = p - 0.5 * (a + b);
    float along = dot(q, axis);
    return vec2(length(q - axis * along), along);
}

// Exact. Frustum from a to b.
float sceneCappedCone(vec3 p, vec3 a, vec3 b, float radiusA, float radiusB)
{
    vec2 q = sceneAlong(p, a, b);
    return sdfCappedCone(vec3(q.x, q.y, 0.0), 0.5 * length(b - a), radiusA, radiusB);
}

// Exact. Convex hull of two balls.
float sceneRoundCone(vec3 p, vec3 a, vec3 b, float radiusA, float radiusB)
{
    vec2 q = sceneAlong(p, a, b);
    float height = length(b - a);
    return sdfRoundCone(vec3(q.x, q.y + 0.5 * height, 0.0), radiusA, radiusB, height);
}

// Exact. Infinite cone with its tip at the origin, opening downward; `halfAngle` from 0 to pi / 2.
float sceneInfiniteCone(vec3 p, float halfAngle)
{
    vec2 q = vec2(length(vec2(p.x, p.z)), -p.y);
    vec2 side = vec2(sin(halfAngle), cos(halfAngle));
    if (dot(q, side) < 0.0) return length(q);
    return q.x * side.y - q.y * side.x;
}

// Exact. Pyramid with a square base of this side on y = 0 and its tip at `height`.
float scenePyramid(vec3 p, float baseSize, float height)
{
    float r = 0.5 * baseSize;
    float x = max(abs(p.x), abs(p.z));  // Symmetry: the face toward +x is the nearest one.
    float z = min(abs(p.x), abs(p.z));
    float slant = length(vec2(r, height));
    vec2 out2 = vec2(height, r) / slant;               // Normal of the face, in x and y.
    vec2 up2 = vec2(-r, height) / slant;               // Up the face.
    vec2 fromEdge = vec2(x - r, p.y);
    float above = dot(fromEdge, out2);
    vec2 q = vec2(z, dot(fromEdge, up2));              // In the plane of the face: corners (r, 0) and (0, slant).
    float toEdge = sdfCapsule(vec3(q.x, q.y, 0.0), vec3(r, 0.0, 0.0), vec3(0.0, slant, 0.0), 0.0);
    float toFoot = length(vec2(max(q.x - r, 0.0), q.y));
    bool onFace = q.y >= 0.0 && q.x * slant <= r * (slant - q.y);
    float inFace = onFace ? 0.0 : min(toEdge, toFoot);
    float face = length(vec2(above, inFace));
    float base = length(vec3(max(x - r, 0.0), p.y, max(z - r, 0.0)));
    float nearest = min(face, base);
    return p.y > 0.0 && above < 0.0 ? -nearest : nearest;
}

// Exact. Vesica: arcs from a to b, rotated around ab, with `radius` in the middle. A radius of half the length or more
// gives the ball around both.
float sceneVesica(vec3 p, vec3 a, vec3 b, float radius)
{
    vec2 q = abs(sceneAlong(p, a, b));
    float tip = 0.5 * length(b - a);
    if (radius >= tip) return length(q) - tip;
    // Distance of the arc's center, on the far side of the axis.
    float middle = 0.5 * (tip - radius) * (tip + radius) / max(radius, SDF_SMALLEST);
    if (q.y * middle >= tip * (q.x + middle)) return length(q - vec2(0.0, tip));
    return length(vec2(q.x + middle, q.y)) - middle - radius;
}

// Exact. Rhombus in the xz plane with these diagonals, extruded along y.
float sceneRhombus(vec3 p, float alongX, float alongZ, float height)
{
    vec3 q = abs(p);
    float x = 0.5 * alongX;
    float z = 0.5 * alongZ;
    float side = sdfCapsule(vec3(q.x, q.z, 0.0), vec3(x, 0.0, 0.0), vec3(0.0, z, 0.0), 0.0);
    float profile = q.x * z + q.z * x < x * z ? -side : side;
    vec2 d = vec2(profile, q.y - 0.5 * height);
    return length(max(d, vec2(0.0))) + min(max(d.x, d.y), 0.0);
}

// Exact. Spherical shell of this thickness, open above y = `cut`, with a round rim; |cut| is clamped to the radius.
float sceneCutHollowSphere(vec3 p, float radius, float cut, float thickness)
{
    float h = clamp(cut, -radius, radius);
    float rim = sqrt((radius - h) * (radius + h));
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float middle = h * q.x < rim * q.y ? length(q - vec2(rim, h)) : abs(length(q) - radius);
    return middle - 0.5 * thickness;
}

// Exact outside. Ball minus a second ball, `offset` above. If they do not touch, it is the first ball.
float sceneDeathStar(vec3 p, float radius, float holeRadius, float offset)
{
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float ball = length(q) - radius;
    if (offset >= radius + holeRadius) return ball;
    float hole = holeRadius - length(q - vec2(0.0, offset));
    float height = 0.5 * (radius * radius - holeRadius * holeRadius + offset * offset) / max(offset, SDF_SMALLEST);
    float rim = safeSqrt(radius * radius - height * height);
    // Points above the lines from the two centers to the rim are closest to the rim.
    if (rim > 0.0 && q.y * rim - q.x * height > offset * max(rim - q.x, 0.0)) return length(q - vec2(rim, height));
    return max(ball, hole);
}

// Unsigned, exact. Quadrilateral sheet: the triangles abc and acd.
float sceneQuad(vec3 p, vec3 a, vec3 b, vec3 c, vec3 d)
{
    return min(sdfTriangle(p, a, b, c), sdfTriangle(p, a, c, d));
}

// Exact. The foot of the perpendicular on the surface is r_i^2 p_i / (u + r_i^2 - m^2), m the smallest radius, where
// |r_i p_i / (u + r_i^2 - m^2)| is 1. One over that length is concave in u. So Newton's iteration converges
// monotonically from any u at which one component alone is already 1 (More and Sorensen 1983, "Computing a trust region
// step").
float sceneEllipsoid(vec3 p, vec3 radii)
{
    vec3 r = max(radii, vec3(SDF_SMALLEST));
    float least = min(r.x, min(r.y, r.z));
    vec3 q = max(abs(p), r * 1.0e-6);  // Moved off the planes of symmetry, where the nearest point may lie elsewhere.
    vec3 rq = r * q;
    vec3 above = (r - vec3(least)) * (r + vec3(least));
    vec3 starts = rq - above;
    float u = max(starts.x, max(starts.y, starts.z));
    for (int i = 0; i < 24; ++i) {
        vec3 below = vec3(u) + above;
        vec3 s = rq / below;
        float squared = dot(s, s);
        float excess = sqrt(squared) - 1.0;
        u += squared * excess / dot(s * s, vec3(1.0) / below);
        if (excess < 1.0e-5) break;  // Each step squares the remaining error.
    }
    vec3 below = vec3(u) + above;
    return (u - least * least) * length(q / below);
}
