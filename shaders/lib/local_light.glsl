// One local light: a point, or a sphere of uniform radiance. Its irradiance on a surface, and the coordinates of its
// shadow map lookup. GLSL 4.50 and C++ (render/glsl/cpu.h).
#ifndef __cplusplus
#include "lib/bindings.glsl"
#include "lib/local_lights_block.glsl"
#include "lib/numerics.glsl"
#endif

// Smooth falloff to 0 at `range`, near 1 below half of it. Karis 2013, "Real Shading in Unreal Engine 4".
float localWindow(float distance, float range)
{
    if (range <= 0.0) return 1.0;
    float ratio = distance / range;
    float inside = max(1.0 - ratio * ratio * ratio * ratio, 0.0);
    return inside * inside;
}

// Cone falloff at `away` from the light, before it is limited to 0 to 1 and squared, times `distance`: the length of
// `away`.
float localConeMargin(LocalLightEntry lamp, vec3 away, float distance)
{
    return lamp.coneScale * dot(lamp.axis, away) - distance * (lamp.coneScale * lamp.coneCosine - 1.0);
}

// Share of a light's intensity in this direction from it (unit): smooth from 1 to 0 at the edge of its cone.
float localCone(LocalLightEntry lamp, vec3 fromLight)
{
    float share = clamp(localConeMargin(lamp, fromLight, 1.0), 0.0, 1.0);
    return share * share;
}

// Product of range and cone falloff at a place: 0 where its light cannot reach.
float localReach(LocalLightEntry lamp, vec3 place)
{
    vec3 away = place - lamp.position;
    float distance = safeSqrt(dot(away, away));
    if (distance <= 0.0) return 0.0;
    return localWindow(distance, lamp.range) * localCone(lamp, away / distance);
}

// Whether that product is above 0. It costs a fraction.
bool localReaches(LocalLightEntry lamp, vec3 place)
{
    vec3 away = place - lamp.position;
    float squared = dot(away, away);
    bool inCone = localConeMargin(lamp, away, safeSqrt(squared)) > 0.0;
    return inCone && (lamp.range <= 0.0 || squared < lamp.range * lamp.range);
}

// Form factor of a sphere seen from a surface: irradiance over pi times its radiance, 0 to 1. `cosine` is between the
// normal and the direction to its center, `distance` to its center. Part of the sphere may lie below the surface's
// horizon. Snyder 1996, "Area Light Sources for Real-Time Graphics", in the form of Quilez, "Sphere - Occlusion". 1
// inside the sphere.
float sphereFormFactor(float cosine, float distance, float radius)
{
    if (distance <= radius) return 1.0;
    float h2 = distance / radius * (distance / radius);
    float c = clamp(cosine, -1.0, 1.0);
    float below = 1.0 - h2 * c * c;   // Above 0: the horizon intersects the sphere.
    if (below <= 0.0) return c > 0.0 ? c / h2 : 0.0;
    float sine = safeSqrt(1.0 - c * c);
    float root = safeSqrt(h2 - 1.0);
    float horizon = clamp(-c * root / sine, -1.0, 1.0);
    return ((c * safeAcos(horizon) - safeSqrt(below) * root) / h2 + atan(safeSqrt(below), root)) / PI;
}

// Irradiance on a surface at `place` with unit `normal`, without shadow.
vec3 localIrradiance(LocalLightEntry lamp, vec3 place, vec3 normal)
{
    vec3 towards = lamp.position - place;
    float squared = dot(towards, towards);
    float distance = safeSqrt(squared);
    float reach = localReach(lamp, place);
    if (reach <= 0.0) return vec3(0.0);
    float cosine = dot(towards, normal) / distance;
    // A sphere as small as this equals a point in float32.
    bool isPoint = lamp.radius < 1.0e-3 * distance;
    float geometry = max(cosine, 0.0) / squared;
    if (!isPoint) geometry = sphereFormFactor(cosine, distance, lamp.radius) / (lamp.radius * lamp.radius);
    if (lamp.nearest > 0.0) geometry = min(geometry, 1.0 / (lamp.nearest * lamp.nearest));
    return lamp.intensity * (geometry * reach);
}

// Index of the shadow map, among the six of a light, that contains this direction from it. OpenGL's order of cube
// faces.
int localShadowFace(vec3 fromLight)
{
    vec3 size = abs(fromLight);
    if (size.x >= size.y && size.x >= size.z) return fromLight.x > 0.0 ? 0 : 1;
    if (size.y >= size.z) return fromLight.y > 0.0 ? 2 : 3;
    return fromLight.z > 0.0 ? 4 : 5;
}

// Coordinates in that map: xy texture coordinates, z reversed depth. render/scene/cube_views.h gives the views that
// draw the maps.
vec3 localShadowPosition(vec3 fromLight, float nearPlane)
{
    int face = localShadowFace(fromLight);
    vec3 d = fromLight;
    vec2 p = vec2(-d.z, -d.y);
    float ahead = d.x;
    if (face == 1) { p = vec2(d.z, -d.y); ahead = -d.x; }
    if (face == 2) { p = vec2(d.x, d.z); ahead = d.y; }
    if (face == 3) { p = vec2(d.x, -d.z); ahead = -d.y; }
    if (face == 4) { p = vec2(d.x, -d.y); ahead = d.z; }
    if (face == 5) { p = vec2(-d.x, -d.y); ahead = -d.z; }
    ahead = max(ahead, 1.0e-6);
    return vec3(p / ahead * 0.5 + 0.5, nearPlane / ahead);
}
