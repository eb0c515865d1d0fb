// Lights of a scene, and their occlusion at a point.

// SHADOWS is one of the kit's methods, or that of the reference.
#define SHADOWS_REFERENCE 6
#ifdef SHADOWS
#if SHADOWS != SHADOWS_REFERENCE
#define SHADOW_METHOD SHADOWS
#include "kit/sdf/shadow_method.glsl"
#endif
#endif

// Random number for each pixel and supersample, 0 to 1.
float pixelNumber(uint salt)
{
    uvec2 pixel = uvec2(framePixel(gl_FragCoord.xy));
    return unitFromBits(pcg(pcg(pixel.x + 65536u * pixel.y) + 747796405u * uint(frame.sampleIndex) + salt));
}

#ifdef LIGHTS
struct SceneLight {
    vec3 direction;  // towards the light, unit
    vec3 arriving;   // irradiance over pi on a plane that faces it
    float distance;  // distance to it
    float width;     // tangent of half its apparent angle
};

SceneLight sceneLight(int i, vec3 p)
{
    SceneLight l;
    vec4 place = stage.lightPlace[i];
    vec4 color = stage.lightColor[i];
    if (int(place.w) == SCENE_SUN) {
        l.direction = place.xyz;
        l.arriving = color.rgb;
        l.distance = stage.farthest;
        l.width = color.w;
        return l;
    }
    vec3 away = place.xyz - p;
    float squared = max(dot(away, away), 1e-6);
    l.distance = sqrt(squared);
    l.direction = safeNormalize(away, vec3(0.0, 1.0, 0.0));
#ifdef REFERENCE_SHADING
    l.arriving = color.rgb;
#else
    // The distance is clamped to the lamp's own size.
    l.arriving = color.rgb / max(squared, parameters.lampSize * parameters.lampSize + 1e-4);
#endif
    l.width = parameters.lampSize / l.distance;
#ifdef LAMPS
    if (int(place.w) == SCENE_AREA) {
        vec3 across = stage.lightAcross[i].xyz;
        vec3 along = stage.lightAlong[i].xyz;
        vec3 facing = cross(across, along);
        float half_ = sqrt(length(facing));
        // Treated as a disk of its area (Snyder 1996): at any distance no brighter than a sky of its radiance.
        float area = 4.0 * length(facing);
        float shown = max(-dot(l.direction, safeNormalize(facing, vec3(0.0, 1.0, 0.0))), 0.0);
        l.arriving = color.rgb * (area * shown / (PI * squared + area));
        l.width = half_ * 1.1 / l.distance;
    }
#endif
    return l;
}

#ifdef SHADOWS
// Visibility of a light past the scene's shapes from `p`, a point next to a surface.
float sceneVisibility(vec3 p, SceneLight l, uint salt)
{
    float width = l.width;
    float tMin = 0.002;
#if SHADOWS == SHADOWS_REFERENCE
    width = stage.softShadows > 0.0 ? 1.0 / stage.softShadows : 1e-4;
    tMin = 0.1;
#endif
#ifdef SCENE_NEAR
    float plane = scenePlaneAhead(p, l.direction, SCENE_PLANES);
    if (plane >= 0.0 && plane < l.distance) return 0.0;
#endif
    // Outside of the box the field is only a bound.
    vec2 span = rayBox(p, l.direction, stage.boxLow, stage.boxHigh);
    float tMax = min(l.distance, span.y);
#if SHADOWS == SHADOW_METHOD_AREA
    span = coneBox(p, l.direction, width, stage.boxLow, stage.boxHigh);
#endif
    tMin = max(tMin, span.x);
    int steps = min(parameters.stepLimit, 128);
#if SHADOWS != SHADOWS_REFERENCE
    Shadow s = shadowByMethod(p, l.direction, width, tMin, tMax, steps, parameters.shadowRays, 2.0 * PI * pixelNumber(salt));
#else
    // Method of the reference: the narrowest clearance k d / t from 0.1 on, smoothed, and hard for k = 0. Unlike the
    // reference, shapes behind the light cast no shadow.
    Shadow s = shadowClassic(p, l.direction, width, tMin, tMax, steps);
    s.visibility = stage.softShadows > 0.0 ? smoothStep(0.0, 1.0, s.visibility) : step(1e-3, s.visibility);
#endif
    evaluations += s.evaluations;
    return s.visibility;
}
#endif
#endif

#ifdef OCCLUSION
// Orthonormal basis around a direction: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
mat3 axesAround(vec3 n)
{
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

#if OCCLUSION == OCCLUSION_HEMISPHERE || OCCLUSION == OCCLUSION_REFERENCE
// Share of rays that hit something within the range; distant hits count less.
float hemisphereHidden(vec3 p, vec3 n, int rays, float range)
{
    mat3 axes = axesAround(n);
    float turn = pixelNumber(17u);
    float hidden = 0.0;
    int taken = 0;
    for (int k = 0; k < rays && (k == 0 || evaluations < mostEvaluations); ++k) {
        float share = (float(k) + 0.5) / float(rays);
#if OCCLUSION == OCCLUSION_REFERENCE
        // The angles of the reference are uniform in the polar angle, and the same for all pixels; here they are
        // rotated per pixel.
        float polar = 0.5 * PI * fract(float(k) * 0.754877666 + 0.5);
        float sine = sin(polar);
#else
        float sine = sqrt(share);
#endif
        float angle = 2.0 * PI * (float(k) * 0.618033989 + turn);
        vec3 d = axes * vec3(sine * cos(angle), sine * sin(angle), safeSqrt(1.0 - sine * sine));
        float t = 0.002;
        float blocked = 0.0;
        for (int i = 0; i < 48 && t < range; ++i) {
            float f = fieldDistance(p + d * t);
            evaluations += 1;
            if (f < 1e-3 * t + 1e-4) {
                blocked = range < 1e3 ? 1.0 - t * t / (range * range) : 1.0;
                break;
            }
            t += f;
        }
        hidden += blocked;
        taken = k + 1;
    }
    return hidden / float(max(taken, 1));
}
#endif

#if OCCLUSION == OCCLUSION_CONES
// Occlusion by six cones of 30 degrees that cover the hemisphere: one along the normal and five around it (Crassin et
// al. 2011, "Interactive Indirect Illumination Using Voxel Cone Tracing"), weighted by their cosine.
float conesHidden(vec3 p, vec3 n, float range)
{
    mat3 axes = axesAround(n);
    float open = 0.0;
    for (int k = 0; k < 6; ++k) {
        float angle = 2.0 * PI * (float(k) * 0.2 + 0.1);
        vec3 d = k == 0 ? n : axes * vec3(0.8660254 * cos(angle), 0.8660254 * sin(angle), 0.5);
        float clear = 1.0;
        float t = 0.02 * range;
        for (int i = 0; i < 7 && t < range; ++i) {
            float f = fieldDistance(p + d * t);
            evaluations += 1;
            float here = clamp(0.5 + 0.5 * f / (0.5773503 * t), 0.0, 1.0);
            clear = min(clear, mix(here, 1.0, t * t / (range * range)));
            t += max(f, 0.08 * range);
        }
        open += clear * (k == 0 ? 0.25 : 0.15);
    }
    return 1.0 - open;
}
#endif

// Share of the ambient light at a point that shapes block.
float sceneHidden(vec3 p, vec3 n)
{
#if OCCLUSION == OCCLUSION_TAPS
    evaluations += 5;
    return 1.0 - fieldOcclusion(p, n, parameters.occlusionRange);
#elif OCCLUSION == OCCLUSION_HEMISPHERE
    return hemisphereHidden(p, n, parameters.occlusionRays, parameters.occlusionRange);
#elif OCCLUSION == OCCLUSION_CONES
    return conesHidden(p, n, parameters.occlusionRange);
#else
    return hemisphereHidden(p + n * 0.1, n, 32, 1e4);
#endif
}
#endif
