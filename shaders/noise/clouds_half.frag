// Marches one ray through the clouds for every block of 2 x 2 pixels: at its center, on the grid of the whole picture.
// Alpha stays negative where a ray misses the opening. Permutations: ALONE; WITH_DISTANCE; those of
// noise/cloud_march.glsl.
#define COPY_BLOCKS
#include "noise/work.glsl"
#include "noise/cloud_march.glsl"

layout(location = 0) out vec4 lightOut;  // light; share of the light behind that is seen
#ifdef WITH_DISTANCE
layout(location = 1) out vec4 distanceOut;  // distance; lookups of noise
#endif

// Whether a ray meets the opening. Computed from the pixel, so that tiles agree with the whole picture.
bool meetsOpening(vec3 world)
{
#ifdef ALONE
    return true;
#else
    float towards = dot(portal.plane.xyz, world);
    float away = dot(portal.plane, vec4(frame.eye, 1.0));
    vec3 met = frame.eye + world * (away / max(-towards, 1e-9)) - portal.worldFromOpening[3].xyz;
    vec3 right = portal.worldFromOpening[0].xyz;
    vec3 up = portal.worldFromOpening[1].xyz;
    return towards < 0.0 && abs(dot(met, right)) <= dot(right, right) && abs(dot(met, up)) <= dot(up, up);
#endif
}

void main()
{
    vec2 center = 2.0 * gl_FragCoord.xy + work.halfOrigin;
    bool meets = meetsOpening(frameRay(center));
    PortalRay ray = portalRay(center);
    ray.pixel *= 0.5;  // Neighboring rays have neighboring values of the blue noise.
    CloudLight clouds = marchedClouds(ray, meets);
    lightOut = vec4(min(clouds.light, vec3(6e4)), meets ? clouds.through : -1.0);
#ifdef WITH_DISTANCE
    distanceOut = vec4(clouds.distance, evaluations, 0.0, 1.0);
#endif
}
