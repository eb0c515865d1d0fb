// Clouds before a sky, and below them a sea. Permutations: REFERENCE; INTERPOLATE (between the rays of clouds_half.frag),
// WITH_DISTANCE (which has written their distances); those of noise/cloud_march.glsl.
#define COPY_BLOCKS
#include "noise/work.glsl"
#include "noise/cloud_march.glsl"

// Sky, and below it a sea that mirrors it. The clouds' shadow on the sea is that of their cover.
vec3 behindClouds(PortalRay ray)
{
    vec3 d = ray.direction;
    if (d.y >= 0.0) return skyLight(d) + sunDisk(d, ray.footprint);
    float t = max((CLOUD_GROUND - ray.origin.y) / min(d.y, -1e-4), 0.0);
    vec3 p = ray.origin + d * t;
    // Gusts roughen the water in patches.
    float slopes = 0.012 + 0.05 * smoothstep(0.3, 0.7, noiseOfClouds(vec3(p.x, 900.0, p.z) + work.fineShift, 3.0 * CLOUD_FINE_REPEAT).x);
    vec3 up = vec3(0.0, 1.0, 0.0);
    float fresnel = schlick(clamp(-d.y + 0.55 * sqrt(slopes), 0.0, 1.0), 0.02);
    vec3 mirrored = normalize(vec3(d.x, -d.y + 0.9 * sqrt(slopes), d.z));
    vec3 above = p + work.sunDirection * ((0.3 * CLOUD_TOP - p.y) / max(work.sunDirection.y, 0.15));
    float sunny = 1.0 - 0.85 * smoothstep(0.35, 0.75, weatherAt(above));
    vec3 sun = sunLight() * sunny;
    vec3 color = vec3(0.012, 0.04, 0.055) * (skyAmbient(1.0) + sun * (max(work.sunDirection.y, 0.0) * 0.3183));
    vec3 met = p + mirrored * ((0.3 * CLOUD_TOP - p.y) / mirrored.y);
    float clouded = smoothstep(0.4, 0.8, weatherAt(met));
    vec3 cloud = skyAmbient(0.0) * 0.6 + sun * 0.05;
    color = mix(color, mix(skyLight(mirrored), cloud, 0.7 * clouded), fresnel);
    color += sun * (sunGlitter(up, -d, slopes) * max(work.sunDirection.y, 0.0));
    return throughAir(color, d, t, hazeReach());
}

#ifdef INTERPOLATE
#include "noise/cloud_interpolation.glsl"
#endif

PortalSeen ourClouds(PortalRay ray)
{
    PortalSeen seen = nothingSeen();
    vec3 behind = behindClouds(ray);
#ifdef INTERPOLATE
    CloudLight between;
    bool isSmooth = interpolatedClouds(behind, between);
    CloudLight clouds = marchedClouds(ray, !isSmooth);
    if (isSmooth) clouds = between;
    evaluations += 0.25 * evaluationsOfHalf();
#else
    CloudLight clouds = marchedClouds(ray, true);
#endif
    if (clouds.through < 0.5) seen.distance = clouds.distance;
    seen.radiance = clouds.light + behind * clouds.through;
    seen.evaluations = evaluations;
    return seen;
}

#ifdef REFERENCE
#include "noise/reference_clouds.glsl"
#endif

PortalSeen portalSeen(PortalRay ray)
{
#ifdef REFERENCE
    return referenceClouds(ray);
#else
    return ourClouds(ray);
#endif
}

#include "kit/portal/main.glsl"
