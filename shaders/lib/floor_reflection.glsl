// Reflections in a polished floor at y = 0: the share of the reflected lobe that objects on the floor, and the window,
// take up. GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/standing_shape_block.glsl"
#endif

// Share of a reflected lobe on the near side of a straight edge. `inside`: distance of the lobe's center from the edge
// on that side. `width`: microfacet alpha times the spread of the lobe there. In slopes, the GGX distribution over one
// direction is (1 + (m / alpha)^2)^(-3/2), up to a factor (Walter et al. 2007, "Microfacet Models for Refraction
// through Rough Surfaces", integrated over the other direction). Its integral has this closed form.
float lobeShare(float inside, float width)
{
    float w = max(width, 1.0e-5);
    return 0.5 + 0.5 * inside * inversesqrt(inside * inside + w * w);
}

// Azimuth of a direction (x, z), 0 to 1 for a full turn. Uses the sum of the components instead of their length, which
// is cheaper and still monotonic.
float azimuthTurn(vec2 direction)
{
    float p = direction.y / max(abs(direction.x) + abs(direction.y), 1.0e-12);
    return 0.25 * (1.0 + (direction.x >= 0.0 ? p : 2.0 - p));
}

// Reflected lobe of a floor at y = 0: position, direction and width.
struct MirrorLobe {
    vec2 place;   // reflecting point: x and z, meters
    vec2 ahead;   // direction of the reflected ray in x and z, unit
    float rise;   // meters that it rises for each meter ahead
    float slope;  // twice the microfacets' alpha: a tilted facet turns the ray by twice its angle
};

// Part of the lobe that a shape takes up.
struct MirroredShape {
    float share;   // share of the lobe, 0 to 1
    float ahead;   // distance from the place to the shape along the floor, meters
    vec2 outwards; // outward normal of its side there, x and z, unit
};

// Half the lobe's width to the sides at `height`, meters. A facet that tilts sideways turns a grazing ray less.
float lobeWidthAside(MirrorLobe lobe, float height)
{
    return lobe.slope * max(height, 0.0) + 2.0e-3;
}

// Half the lobe's width upwards, as a difference of the tangent.
float lobeWidthUp(MirrorLobe lobe)
{
    return lobe.slope * (1.0 + lobe.rise * lobe.rise);
}

// Sides and top of a shape are treated as independent straight edges.
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
        // A ray that misses passes the corner between the two sides.
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

// Part of the lobe that a window takes up.
struct MirroredWindow {
    float share;   // share of the lobe that meets its panes, without bars, 0 to 1
    vec2 place;    // center of the lobe in the plane of the panes: x and y, meters
    vec2 width;    // half the lobe's width there
};

// `window` and `windowZ` are those of FloorMirrorBlock.
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
    // The panes are seen at an angle sideways; vertically they are seen from the front at any height.
    found.place = vec2(x, y);
    found.width = vec2(lobeWidthAside(lobe, y) / -lobe.ahead.y, lobeWidthUp(lobe) * toPanes);

    // The reveal widens into the room; but seen from the floor, the sill hides the lowest part of the panes.
    float sill = window.z * (windowZ.y - lobe.place.y) / min(windowZ.x - lobe.place.y, -1.0e-3);
    float radius = 0.5 * (window.y - window.x);
    float above = clamp(y - (window.w - radius), 0.0, radius);
    float halfWidth = safeSqrt(radius * radius - above * above);
    float across = x - 0.5 * (window.x + window.y);
    float open = max(lobeShare(halfWidth - across, found.width.x) - lobeShare(-halfWidth - across, found.width.x), 0.0);
    found.share = open * max(lobeShare(window.w - y, found.width.y) - lobeShare(sill - y, found.width.y), 0.0);
    return found;
}

// Share of a lobe that meets a bar. `bar` has its center and half width along one axis; `place` is the lobe's center on
// that axis.
float mirroredBar(vec2 bar, float place, float width)
{
    return lobeShare(bar.x + bar.y - place, width) - lobeShare(bar.x - bar.y - place, width);
}

// Share of the lobe that leaves through a round opening above. `oculus`: its center, and its radius.
float mirroredOculus(vec4 oculus, MirrorLobe lobe)
{
    if (oculus.w <= 0.0 || lobe.rise < 0.2) return 0.0;
    float ahead = oculus.y / lobe.rise;
    vec2 offset = lobe.place + lobe.ahead * ahead - vec2(oculus.x, oculus.z);
    float distance = max(length(offset), 1.0e-4);
    // Width of the lobe towards the nearest point of the edge.
    float along = dot(offset, lobe.ahead) / distance;
    float aside = (lobe.ahead.x * offset.y - lobe.ahead.y * offset.x) / distance;
    float widthAlong = lobeWidthUp(lobe) * ahead / lobe.rise;
    float width = length(vec2(along * widthAlong, aside * lobeWidthAside(lobe, oculus.y)));
    return lobeShare(oculus.w - distance, width);
}
