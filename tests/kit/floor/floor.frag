// A floor of white and black squares, one unit wide, at y = -1.
#include "kit/portal/portal.glsl"

PortalSeen portalSeen(PortalRay ray)
{
    PortalSeen seen;
    seen.radiance = vec3(0.0, 0.0, 0.5);
    seen.normal = vec3(0.0);
    seen.distance = 1e20;
    seen.evaluations = 1.0;
    float t = ray.direction.y < 0.0 ? (-1.0 - ray.origin.y) / ray.direction.y : -1.0;
    if (t <= ray.start) return seen;
    vec3 p = ray.origin + ray.direction * t;
    float square = mod(floor(p.x) + floor(p.z), 2.0);
    seen.radiance = vec3(square, parameters.green, 0.0);
    seen.normal = vec3(0.0, 1.0, 0.0);
    seen.distance = t;
    return seen;
}

#include "kit/portal/main.glsl"
