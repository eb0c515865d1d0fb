// Draws a scene behind the portal: its field is generated, the rest is here. Permutations: REFERENCE_SHADING; LIGHTS, SHADOWS
// (a method), OCCLUSION (a method), MIRRORS, GLASS, GLOWS, LAMPS, PANORAMA, if the scene has any; HEAT_MAP,
// COUNT_SHAPES (instead of evaluations).
#define COPY_BLOCKS
#if defined(REFERENCE_SHADING) || defined(HEAT_MAP)
#define PORTAL_DISPLAY_LIGHT
#endif
#include "kit/portal/portal.glsl"
#include "lib/numerics.glsl"
#include "lib/hash.glsl"
#include "lib/heat_color.glsl"
#include "kit/sdf/shadow_methods.glsl"
#include "sdf_scenes/generated_field.glsl"

#define OCCLUSION_REFERENCE 0
#define OCCLUSION_TAPS 2
#define OCCLUSION_HEMISPHERE 3
#define OCCLUSION_CONES 4

int evaluations = 0;  // Calls of the field for this pixel.
#if defined(LOOP_LIMIT) && defined(SHADOWS)
#if SHADOWS == SHADOW_METHOD_AREA
#define BOUNDED
#endif
#endif
#if defined(LOOP_LIMIT) && defined(OCCLUSION)
#if OCCLUSION == OCCLUSION_HEMISPHERE
#define BOUNDED
#endif
#endif
#ifdef BOUNDED
// A driver that ends all loops of a group of pixels after so many iterations would leave the rest of their picture
// black. Of many rays, fewer are taken before that: pixels differ, so a group needs a few times the iterations of one.
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
