// Camera rays through a portal, in the space of the world behind it. A shader includes this file, defines
//
//     PortalSeen portalSeen(PortalRay ray)
//
// and then includes kit/portal/main.glsl.
#include "lib/bindings.glsl"
#include "lib/frame.glsl"
#include "lib/light_uniform.glsl"  // Without maps, because the hall's light does not reach the world behind it.
#include "kit/portal/portal_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PortalBlock portal;
};

struct PortalRay {
    vec3 origin;      // the eye; lengths in meters of the world behind the portal
    vec3 direction;   // unit
    float start;      // distance to the opening: closer surfaces are not visible
    float footprint;  // width of a pixel at distance 1
    vec2 pixel;       // position in the whole picture
};

struct PortalSeen {
    vec3 radiance;      // radiance times exposure: 1 is bright; with PORTAL_DISPLAY_LIGHT, display light, 0 to 1
    vec3 normal;        // unit, in the world behind the portal; 0 if no surface was hit
    float distance;     // distance from the eye; at least 1e20 if nothing was hit
    float evaluations;  // number of evaluations, as the shader counts them
    vec3 albedo;        // base color of the surface; 0 if it has none
};

PortalRay portalRay(vec2 fragCoord)
{
    PortalRay r;
    vec3 world = frameRay(fragCoord);
    vec3 d = mat3(portal.workFromWorld) * world;
    r.direction = normalize(d);
    r.origin = (portal.workFromWorld * vec4(frame.eye, 1.0)).xyz;
    float perDepth = length(world);
    r.start = frame.nearPlane * perDepth * portal.workPerMeter;
#ifndef ALONE
    float towards = dot(portal.plane.xyz, world);
    float away = dot(portal.plane, vec4(frame.eye, 1.0));
    if (towards < 0.0) r.start = max(away / -towards * perDepth * portal.workPerMeter, 0.0);
#endif
    r.footprint = frame.pixelAngle / perDepth;
    r.pixel = framePixel(fragCoord);
    return r;
}
