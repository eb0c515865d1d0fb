// Things that stand on a floor at y = 0: how much of the sky above it they take away, and how much of what a polished
// floor mirrors. GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/local_light.glsl"
#include "lib/standing_block.glsl"
#endif

// Number of corners of a shape's outline on the floor. A cylinder is a prism of as much area.
int outlineCorners(StandingShape shape)
{
    return shape.kind == STANDING_BOX ? 4 : 16;
}

// One of them, against the floor's x and z, relative to the shape's center.
vec2 outlineCorner(StandingShape shape, int index)
{
    if (shape.kind == STANDING_BOX) {
        float along = index < 2 ? shape.halfSize.x : -shape.halfSize.x;
        float across = index == 0 || index == 3 ? shape.halfSize.y : -shape.halfSize.y;
        return shape.axis * along + vec2(-shape.axis.y, shape.axis.x) * across;
    }
    float angle = -2.0 * PI * float(index) / 16.0;
    float radius = shape.halfSize.x * 1.01292;  // sqrt(2 pi / (16 sin(2 pi / 16)))
    return vec2(cos(angle), sin(angle)) * radius;
}

// What an edge from a to b adds to Lambert's sum for a floor that faces up; both relative to the point of the floor.
float edgeFactor(vec3 a, vec3 b)
{
    vec3 c = cross(a, b);
    float sine = length(c);
    return sine > 1.0e-12 ? c.y / sine * atan(sine, dot(a, b)) : 0.0;
}

// Share of the light of an even sky that the shape keeps from a point (x, z) of the floor beside or below it, 0 to 1.
// Lambert 1760, "Photometria", for the outline of a prism as the point sees it: of an edge of its base that faces the
// point one sees the upper end, of the others the lower. Upright edges add nothing, because the floor's normal lies in
// their plane, and nothing is below the horizon.
float standingFormFactor(StandingShape shape, vec2 place)
{
    if (shape.kind == STANDING_SPHERE) {
        vec3 towards = vec3(shape.center.x - place.x, shape.center.y, shape.center.z - place.y);
        float distance = length(towards);
        return sphereFormFactor(towards.y / max(distance, 1.0e-6), distance, shape.halfSize.x);
    }
    vec2 center = vec2(shape.center.x - place.x, shape.center.z - place.y);
    float low = max(shape.center.y - shape.halfHeight, 0.0);
    float high = max(shape.center.y + shape.halfHeight, 0.0);
    int corners = outlineCorners(shape);
    float sum = 0.0;
    vec2 a = center + outlineCorner(shape, corners - 1);
    for (int i = 0; i < corners; ++i) {
        vec2 b = center + outlineCorner(shape, i);
        float level = a.y * b.x - a.x * b.y < 0.0 ? high : low;
        sum += edgeFactor(vec3(a.x, level, a.y), vec3(b.x, level, b.y));
        a = b;
    }
    return clamp(sum / (2.0 * PI), 0.0, 1.0);
}

// Meters from a point of the floor to the shape's outline; negative within.
float outlineDistance(StandingShape shape, vec2 place)
{
    vec2 p = place - vec2(shape.center.x, shape.center.z);
    if (shape.kind != STANDING_BOX) return length(p) - shape.halfSize.x;
    vec2 q = abs(vec2(dot(p, shape.axis), dot(p, vec2(-shape.axis.y, shape.axis.x)))) - shape.halfSize;
    return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}

// The point itself, or where it lies below what stands on the floor, the nearest point beside it: what filters the map
// must not mix the darkness under a plinth into the floor before it.
vec2 besideOutline(StandingShape shape, vec2 place)
{
    const float beside = 1.0e-3;
    float inside = outlineDistance(shape, place);
    if (inside >= beside || shape.kind == STANDING_SPHERE || shape.center.y - shape.halfHeight > 0.01) return place;
    vec2 p = place - vec2(shape.center.x, shape.center.z);
    if (shape.kind != STANDING_BOX) {
        float radius = length(p);
        return place + (radius > 0.0 ? p / radius : vec2(1.0, 0.0)) * (beside - inside + 0.013 * shape.halfSize.x);
    }
    vec2 across = vec2(-shape.axis.y, shape.axis.x);
    vec2 local = vec2(dot(p, shape.axis), dot(p, across));
    vec2 q = abs(local) - shape.halfSize;
    vec2 away = q.x > q.y ? shape.axis * (local.x < 0.0 ? -1.0 : 1.0) : across * (local.y < 0.0 ? -1.0 : 1.0);
    return place + away * (beside - inside);
}

// Share of the ambient light that the shape takes from a point of the floor, as its strength and reach say.
float contactShadow(StandingShape shape, vec2 place)
{
    float fade = 1.0 - smoothStep(0.5 * shape.reach, shape.reach, outlineDistance(shape, place));
    if (fade * shape.strength <= 0.0) return 0.0;
    return fade * shape.strength * standingFormFactor(shape, besideOutline(shape, place));
}

// Share of a mirrored lobe on the near side of a straight edge. `inside`: how far the middle of the lobe is on that
// side; `width`: alpha of the microfacets as the lobe has spread it there. In slopes, the GGX distribution over one
// direction is (1 + (m / alpha)^2)^(-3/2), up to a factor (Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces", integrated over the other): its integral is closed.
float lobeShare(float inside, float width)
{
    float w = max(width, 1.0e-5);
    return 0.5 + 0.5 * inside * inversesqrt(inside * inside + w * w);
}

// Azimuth of a direction (x, z), 0 to 1 all round, by the sum of the components in place of their length: cheap, and as
// good for telling one from another.
float azimuthTurn(vec2 direction)
{
    float p = direction.y / max(abs(direction.x) + abs(direction.y), 1.0e-12);
    return 0.25 * (1.0 + (direction.x >= 0.0 ? p : 2.0 - p));
}

// The lobe of a floor at y = 0: where it is mirrored, and how wide.
struct MirrorLobe {
    vec2 place;   // x and z, meters
    vec2 ahead;   // of the mirrored ray in x and z, unit
    float rise;   // meters that it rises for each meter ahead
    float slope;  // twice the microfacets' alpha: a facet that leans turns the ray twice as far
};

// What the lobe meets of a shape.
struct MirroredShape {
    float share;   // of the lobe, 0 to 1
    float ahead;   // meters from the place to it, on the floor
    vec2 outwards; // of its side there, x and z, unit
};

// Half the lobe's width to the sides where it has risen to `height`, meters: a facet that leans to the side turns a
// grazing ray less.
float lobeWidthAside(MirrorLobe lobe, float height)
{
    return lobe.slope * max(height, 0.0) + 2.0e-3;
}

// The same upwards, as difference of the tangent.
float lobeWidthUp(MirrorLobe lobe)
{
    return lobe.slope * (1.0 + lobe.rise * lobe.rise);
}

// Sides and top of a shape are edges of the lobe, each taken alone.
MirroredShape mirroredShape(StandingShape shape, MirrorLobe lobe)
{
    MirroredShape found;
    vec2 center = vec2(shape.center.x - lobe.place.x, shape.center.z - lobe.place.y);
    float aside = lobe.ahead.x * center.y - lobe.ahead.y * center.x;
    float middle = dot(lobe.ahead, center);
    float nearest, farthest, halfWidth;
    if (shape.kind == STANDING_BOX) {
        vec2 across = vec2(-shape.axis.y, shape.axis.x);
        vec2 direction = vec2(dot(lobe.ahead, shape.axis), dot(lobe.ahead, across));
        direction.x = abs(direction.x) < 1.0e-4 ? 1.0e-4 : direction.x;
        direction.y = abs(direction.y) < 1.0e-4 ? 1.0e-4 : direction.y;
        vec2 to = vec2(dot(center, shape.axis), dot(center, across)) / direction;
        vec2 half2 = shape.halfSize / abs(direction);
        vec2 enters = to - half2;
        vec2 leaves = to + half2;
        nearest = max(enters.x, enters.y);
        farthest = min(leaves.x, leaves.y);
        // A ray that misses passes the corner between the two.
        if (nearest > farthest) nearest = farthest = 0.5 * (nearest + farthest);
        halfWidth = shape.halfSize.x * abs(direction.y) + shape.halfSize.y * abs(direction.x);
        found.outwards = enters.x > enters.y ? shape.axis * -sign(direction.x) : across * -sign(direction.y);
    } else {
        float radius = shape.halfSize.x;
        halfWidth = radius;
        if (shape.kind == STANDING_SPHERE) {
            float up = (lobe.rise * middle - shape.center.y) / radius;
            halfWidth = radius * safeSqrt(1.0 - up * up);
        }
        float chord = safeSqrt(halfWidth * halfWidth - aside * aside);
        nearest = middle - chord;
        farthest = middle + chord;
        found.outwards = -lobe.ahead;
    }
    found.ahead = max(nearest, 1.0e-3);
    found.share = 0.0;
    if (farthest <= 0.0) return found;
    float low = shape.center.y - shape.halfHeight;
    float high = shape.center.y + shape.halfHeight;
    float width = lobeWidthAside(lobe, min(lobe.rise * found.ahead, high));
    float across2 = lobeShare(halfWidth - aside, width) - lobeShare(-halfWidth - aside, width);
    float widthUp = lobeWidthUp(lobe);
    float upwards = lobeShare(high / found.ahead - lobe.rise, widthUp);
    if (low > 0.01) upwards -= lobeShare(low / max(farthest, 1.0e-3) - lobe.rise, widthUp);
    found.share = clamp(across2 * upwards, 0.0, 1.0);
    return found;
}

// What the lobe meets of a window.
struct MirroredWindow {
    float share;   // of the lobe that meets its panes, bars left out, 0 to 1
    vec2 place;    // the middle of the lobe in the plane of the panes: x and y, meters
    vec2 width;    // half of it there
};

// `window`, `windowZ`: as FloorMirrorBlock has them.
MirroredWindow mirroredWindow(vec4 window, vec2 windowZ, MirrorLobe lobe)
{
    MirroredWindow found;
    found.share = 0.0;
    found.place = vec2(0.0);
    found.width = vec2(1.0);
    float toPanes = (windowZ.y - lobe.place.y) / min(lobe.ahead.y, -0.02);
    if (!(window.x < window.y) || lobe.ahead.y >= -0.02 || toPanes <= 0.0) return found;
    float x = lobe.place.x + lobe.ahead.x * toPanes;
    float y = lobe.rise * toPanes;
    // The panes are seen at an angle from the side, and from the front however high they are.
    found.place = vec2(x, y);
    found.width = vec2(lobeWidthAside(lobe, y) / -lobe.ahead.y, lobeWidthUp(lobe) * toPanes);

    // The reveal widens into the room; but the sill, seen from the floor, hides the feet of the panes.
    float sill = window.z * (windowZ.y - lobe.place.y) / min(windowZ.x - lobe.place.y, -1.0e-3);
    float radius = 0.5 * (window.y - window.x);
    float above = clamp(y - (window.w - radius), 0.0, radius);
    float halfWidth = safeSqrt(radius * radius - above * above);
    float across = x - 0.5 * (window.x + window.y);
    float open = max(lobeShare(halfWidth - across, found.width.x) - lobeShare(-halfWidth - across, found.width.x), 0.0);
    found.share = open * max(lobeShare(window.w - y, found.width.y) - lobeShare(sill - y, found.width.y), 0.0);
    return found;
}

// Share of a lobe that meets a bar: `bar` has its middle and half its width along one axis, on which the lobe's middle
// is at `place`.
float mirroredBar(vec2 bar, float place, float width)
{
    return lobeShare(bar.x + bar.y - place, width) - lobeShare(bar.x - bar.y - place, width);
}

// Share of the lobe that leaves through a round opening above: its center, and its radius.
float mirroredOculus(vec4 oculus, MirrorLobe lobe)
{
    if (oculus.w <= 0.0 || lobe.rise < 0.2) return 0.0;
    float ahead = oculus.y / lobe.rise;
    vec2 offset = lobe.place + lobe.ahead * ahead - vec2(oculus.x, oculus.z);
    float distance = max(length(offset), 1.0e-4);
    // As wide as the lobe is towards the nearest point of the edge.
    float along = dot(offset, lobe.ahead) / distance;
    float aside = (lobe.ahead.x * offset.y - lobe.ahead.y * offset.x) / distance;
    float widthAlong = lobeWidthUp(lobe) * ahead / lobe.rise;
    float width = length(vec2(along * widthAlong, aside * lobeWidthAside(lobe, oculus.y)));
    return lobeShare(oculus.w - distance, width);
}
