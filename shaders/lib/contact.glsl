// Contact shadows: how much of the sky objects hide that stand on a floor at y = 0. GLSL 4.50 and C++
// (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/local_light.glsl"
#include "lib/standing_shape_block.glsl"
#endif

// Number of corners of a shape's outline on the floor. A cylinder is replaced by a prism of equal area.
int outlineCorners(StandingShape shape)
{
    return shape.kind == STANDING_BOX ? 4 : 16;
}

// Corner of the outline, in x and z, relative to the shape's center.
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

// Contribution of an edge from a to b to Lambert's sum for a floor that faces up; both relative to the point on the
// floor.
float edgeFactor(vec3 a, vec3 b)
{
    vec3 c = cross(a, b);
    float sine = length(c);
    return sine > 1.0e-12 ? c.y / sine * atan(sine, dot(a, b)) : 0.0;
}

// Share of the light of a uniform sky that the shape blocks at a point (x, z) of the floor beside or below it, 0 to 1.
// Lambert 1760, "Photometria", for the outline of a prism as seen from the point. If an edge of its base faces the
// point, its upper end is visible, otherwise the lower one. Vertical edges contribute nothing, because the floor's
// normal lies in their plane. Nothing lies below the horizon.
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

// Distance from a point of the floor to the shape's outline, meters; negative inside.
float outlineDistance(StandingShape shape, vec2 place)
{
    vec2 p = place - vec2(shape.center.x, shape.center.z);
    if (shape.kind != STANDING_BOX) return length(p) - shape.halfSize.x;
    vec2 q = abs(vec2(dot(p, shape.axis), dot(p, vec2(-shape.axis.y, shape.axis.x)))) - shape.halfSize;
    return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}

// Returns the point itself. A point below an object that stands on the floor is moved to the nearest point beside it.
// So filtering of the map does not mix the darkness under a plinth into the visible floor.
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

// Share of the ambient light that the shape blocks at a point of the floor, scaled by its strength and reach.
float contactShadow(StandingShape shape, vec2 place)
{
    float fade = 1.0 - smoothStep(0.5 * shape.reach, shape.reach, outlineDistance(shape, place));
    if (fade * shape.strength <= 0.0) return 0.0;
    return fade * shape.strength * standingFormFactor(shape, besideOutline(shape, place));
}
