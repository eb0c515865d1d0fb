// Draws a scene behind the portal: its field is generated, the rest is here. Permutations: REFERENCE_SHADING; LIGHTS, SHADOWS
// (a method), OCCLUSION (a method), MIRRORS, GLASS, GLOWS, LAMPS, PANORAMA, if the scene has any; HEAT_MAP,
// COUNT_SHAPES (instead of evaluations).
#if defined(REFERENCE_SHADING) || defined(HEAT_MAP)
#define PORTAL_DISPLAY_LIGHT
#endif
#include "kit/portal/portal.glsl"
#include "lib/numerics.glsl"
#include "lib/hash.glsl"
#include "lib/heat_color.glsl"
#include "sdf_scenes/generated_field.glsl"

int evaluations = 0;  // Calls of the field for this pixel.
#ifdef LOOP_LIMIT
// A driver that ends all loops of a group of pixels after so many iterations would leave the rest of their picture
// black. Fewer rays are taken before: pixels differ, so the group's iterations are a few times those of a pixel.
int mostEvaluations = LOOP_LIMIT / (8 * (1 + stage.loops));
#else
const int mostEvaluations = 2147483647;
#endif
#define FIELD_BUDGET (mostEvaluations - evaluations)

#include "lib/sphere_tracing.glsl"

#include "sdf_scenes/environment.glsl"
#include "sdf_scenes/hit.glsl"
#include "sdf_scenes/light.glsl"
#ifdef REFERENCE_SHADING
#include "sdf_scenes/reference_shading.glsl"
#else
#include "sdf_scenes/pbr_shading.glsl"
#endif

PortalSeen portalSeen(PortalRay ray)
{
    evaluations = 0;
    primitiveEvaluations = 0;
    SceneSeen found = sceneSeen(ray);
    PortalSeen seen;
    seen.radiance = found.radiance;
    seen.normal = found.normal;
    seen.distance = found.distance;
    seen.albedo = found.albedo;
#ifdef COUNT_SHAPES
    seen.evaluations = float(primitiveEvaluations);
#else
    seen.evaluations = float(evaluations);
#endif
#ifdef HEAT_MAP
    float count = parameters.heatMap == heatMap_steps ? float(found.steps) : float(evaluations);
    if (parameters.heatMap == heatMap_shapes) count = float(primitiveEvaluations);
    vec3 shown = heatColor(count / parameters.heatScale);
    if (parameters.heatMap == heatMap_normals) shown = found.normal * 0.5 + 0.5;
    seen.radiance = shown;
#endif
    return seen;
}

#include "kit/portal/main.glsl"
