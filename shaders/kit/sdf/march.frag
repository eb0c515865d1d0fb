// Sphere traces the object, one ray per pixel inside its bounding mesh, and writes the depth of the hit. Permutations:
// CONE_PREPASS (pixels along a side of its blocks), GLASS, BACKDROP (visible through glass), HEAT_MAP, WRITE_NORMAL,
// COUNT (writes evaluations, discards nothing), DEPTH_ONLY (no shading), OTHERS_SHADOWS, PIXEL_CENTERS, SHADOW_METHOD
// (the parameter's number), BOUNCES (if any are set), SUNLESS (no sunlight reaches it).
#define COPY_BLOCKS
#include "kit/sdf/ray.glsl"
#include "kit/sdf/shade.glsl"
#include "lib/heat_color.glsl"
#include "lib/display_light.glsl"
#include "kit/sdf/shading.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler2D coneStart;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif
#ifndef COUNT
layout(depth_any) out float gl_FragDepth;
#endif

// Returns the radiance that the exposure maps to the heat map's color.
vec3 heat(March march, Hit hit)
{
    vec3 shown;
    if (parameters.heatMap == heatMap_steps) shown = heatColor(float(march.steps) / parameters.heatScale);
    else if (parameters.heatMap == heatMap_evaluations) shown = heatColor(float(evaluations) / parameters.heatScale);
    else if (parameters.heatMap == heatMap_normals) shown = hit.worldNormal * 0.5 + 0.5;
    else shown = heatColor(0.5 + 0.5 * march.distance / max(4.0 * hit.tolerance, 1e-7));
    return shown / light.exposure;
}

void main()
{
    evaluations = 0;
    turnDisk(framePixel(gl_FragCoord.xy));
    LocalRay ray = localRay(gl_FragCoord.xy);
    float coneShare = 0.0;
#ifdef CONE_PREPASS
    vec4 cone = texelFetch(coneStart, ivec2((gl_FragCoord.xy + tileInBlock()) / BLOCK), 0);
    coneShare = cone.y / 64.0;
    ray.span.x = max(ray.span.x, cone.x);
#endif
    MarchSettings settings = tableSettings(ray.span.x, ray.span.y, ray.halfPixel);
    March march = sphereTrace(ray.origin, ray.direction, settings);
    evaluations += march.evaluations;

#ifdef COUNT
    if (march.hit) fieldRadiance(ray, findHit(ray.origin, ray.direction, march, settings), settings);
    radiance = vec4(float(evaluations) + coneShare, 0.0, 0.0, 0.0);
#else
    if (!march.hit) discard;
    // Distance along the view axis, then reversed depth.
    gl_FragDepth = frame.nearPlane / (march.t / ray.perDepth);
#ifndef DEPTH_ONLY
    Hit hit = findHit(ray.origin, ray.direction, march, settings);
    vec3 color = fieldRadiance(ray, hit, settings);
    radiance = vec4(min(color, vec3(6e4)), 1.0);  // Half floats end at 65504.
#ifdef HEAT_MAP
    radiance = vec4(heat(march, hit), DISPLAY_LIGHT);
#endif
#ifdef WRITE_NORMAL
    normalOut = vec4(hit.worldNormal, 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(fieldMaterial(hit.local).baseColor, 1.0);
#endif
#endif
#endif
}
