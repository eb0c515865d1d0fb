// Traces one ray per pixel into the world behind a portal. The depth is that of the opening; with ALONE, that of the
// hit. Permutations: ALONE, WRITE_NORMAL, WRITE_EVALUATIONS, WRITE_ALBEDO. The including shader defines
// PORTAL_DISPLAY_LIGHT if it returns display colors.
#include "lib/display_light.glsl"

layout(location = 0) out vec4 radiance;
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#ifdef WRITE_EVALUATIONS
layout(location = WRITE_EVALUATIONS) out vec4 evaluationsOut;
#endif
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

void main()
{
    if (portal.side != 0.0) {
        // Both halves compute exactly the same number, so that each pixel belongs to one of them.
        precise float right = dot(cross(portal.dividerAt - frame.eye, portal.dividerUp), frameRay(gl_FragCoord.xy));
        if ((right >= 0.0) != (portal.side > 0.0)) discard;
    }
    PortalRay ray = portalRay(gl_FragCoord.xy);
    PortalSeen seen = portalSeen(ray);
    radiance = vec4(clamp(seen.radiance * portal.radianceScale, vec3(0.0), vec3(6e4)), 1.0);
#ifdef PORTAL_DISPLAY_LIGHT
    radiance.a = DISPLAY_LIGHT;
#endif
#ifdef WRITE_NORMAL
    vec3 n = dot(seen.normal, seen.normal) > 0.5 ? normalize(seen.normal * mat3(portal.workFromWorld)) : portal.plane.xyz;
    normalOut = vec4(n, 1.0);
#endif
#ifdef WRITE_EVALUATIONS
    evaluationsOut = vec4(seen.evaluations, 0.0, 0.0, 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(seen.albedo, 1.0);
#endif
#ifdef ALONE
    // Depth along the view axis. It is never 0, which marks empty pixels.
    float perDepth = length(frameRay(gl_FragCoord.xy)) * portal.workPerMeter;
    gl_FragDepth = clamp(frame.nearPlane * perDepth / max(seen.distance, 1e-6), 1e-12, 1.0);
#endif
}
