// Draws the sand around the ice cream, and the black beyond it: a plane, intersected without a march. Permutation:
// WRITE_NORMAL.
#include "kit/sdf/ray.glsl"
#include "kit/sdf/shade.glsl"
#include "kit/sdf/shading.glsl"

layout(location = 0) out vec4 radiance;
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif
layout(depth_any) out float gl_FragDepth;

// Visibility of the sun at a point of the ground. A ray hits nothing if it passes the box at a distance of more than
// half the sun's width there.
float groundVisibility(vec3 p, vec3 toSun)
{
    if (parameters.shadowMethod == shadowMethod_none) return 1.0;
    float width = tan(0.5 * parameters.sunWidth);
    float farthest = length(max(abs(object.boxLow - p), abs(object.boxHigh - p)));
    vec2 span = rayBox(p, toSun, object.boxLow - vec3(width * farthest), object.boxHigh + vec3(width * farthest));
    if (span.x >= span.y) return 1.0;
    return fieldVisibility(p, toSun, max(span.x, 0.004), span.y);
}

void main()
{
    evaluations = 0;
    LocalRay ray = localRay(gl_FragCoord.xy);
    float t = -ray.origin.y / ray.direction.y;
    bool below = ray.direction.y < 0.0 && ray.origin.y > 0.0;
    // Beyond this distance the fog is complete; depth 0 belongs to the sky.
    float farthest = 1.0e4;
    gl_FragDepth = max(frame.nearPlane / ((below ? min(t, farthest) : farthest) / ray.perDepth), 1.0e-9);
    radiance = vec4(0.0, 0.0, 0.0, 1.0);
    vec3 n = vec3(0.0, 1.0, 0.0);
#ifdef WRITE_NORMAL
    normalOut = vec4(worldNormalOf(n), 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(0.0, 0.0, 0.0, 1.0);
#endif
    if (!below || t >= farthest) return;
    vec3 p = ray.origin + ray.direction * t;
    Surface s;
    s.position = p;
    s.normal = n;
    s.baseColor = shape.stage < STAGE_COLORS ? vec3(0.5) : parameters.groundColor;
#ifdef WRITE_ALBEDO
    albedoOut = vec4(s.baseColor, 1.0);
#endif
    s.metalness = 0.0;
    s.roughness = 0.9;
    s.specular = 0.0;
    s.ambient = vec3(0.0);
    // Occlusion by the body, near its box only. The ground occludes nothing of itself: a sample is as far from it as it
    // is high.
    bool near = length(max(max(object.boxLow - p, p - object.boxHigh), vec3(0.0))) < 0.6;
    s.occlusion = near ? referenceOcclusion(p, n) : 1.0;
    s.specular = shape.stage < STAGE_SPECULAR ? 0.0 : 0.5;
    vec3 color = referenceFogged(referenceReflected(s, -ray.direction, groundVisibility(p + n * 1.0e-4, referenceSun())), t);
    radiance = vec4(min(color, vec3(6e4)), 1.0);
}
