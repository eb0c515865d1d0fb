// Rays of the eye that look through an opening, in the world beyond. A shader includes this file, defines
//
//     PortalSeen portalSeen(PortalRay ray)
//
// and then includes kit/portal/main.glsl.
#include "lib/bindings.glsl"
#include "lib/frame.glsl"
#include "lib/light_block.glsl"
#include "kit/portal/portal_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PortalBlock portal;
};

// Of the hall: its maps are not bound, for its light does not reach the world beyond.
layout(std140, binding = BLOCK_LIGHT) uniform Light {
    LightBlock light;
};

struct PortalRay {
    vec3 origin;      // the eye; lengths in meters of the world beyond
    vec3 direction;   // unit
    float start;      // distance to the opening: what is nearer is not seen
    float footprint;  // width of a pixel at distance 1
    vec2 pixel;       // of the whole picture
};

struct PortalSeen {
    vec3 radiance;      // as the film sees it: 1 is bright; with PORTAL_DISPLAY_LIGHT, display light, 0 to 1
    vec3 normal;        // unit, in the world beyond; 0 where nothing solid is seen
    float distance;     // from the eye; at least 1e20 where nothing is seen
    float evaluations;  // of whatever the shader counts
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
