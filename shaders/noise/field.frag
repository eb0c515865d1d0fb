// Blobs of noise: marched with the bounds of field.glsl, lit by sun and sky, with light through thin parts, fading into
// bright air. Permutations: those of field.glsl, REFERENCE; COUNT_LOOKUPS, instead of evaluations; HALVED, steps of half
// the value; DERIVATIVE, for normals.
#define COPY_BLOCKS
#include "noise/work.glsl"
#include "noise/field.glsl"

const float FIELD_FARTHEST = 60.0;
const float LEAST_LOOKED_STRIDE = 0.002;  // cells: for shorter strides, evaluating the noise is faster

// Widened free space: positive around the entry of the ray, so that nothing is directly in front of the eye. As in the
// reference, but beginning farther away: tips of blobs near the eye would be flat ovals against the light.
float clearing(float t)
{
    return clamp(1.4 - t * CLEARING_SLOPE, 0.0, 1.0);
}

// Advances the ray through empty space by lookups alone, without evaluating noise.
float throughEmptySpace(PortalRay ray, float from, float farthest, bool wanted)
{
    float t = from;
#ifdef BAKED
    // A loop without steps is cheaper than a branch, whose both sides some processors execute.
    int steps = wanted ? parameters.stepLimit : 0;
    for (int i = 0; i < steps && t < farthest; ++i) {
        float footprint = t * ray.footprint;
        float stride = fieldAt(ray.origin + ray.direction * t, ray.direction, footprint, clearing(t - ray.start), false, true).stride;
        if (stride < max(0.2 * footprint, LEAST_LOOKED_STRIDE / parameters.frequency)) break;
        t += stride;
    }
#endif
    return t;
}

// State machine of a ray. Each step evaluates the field once, at one place of the shader: for the surface or, there,
// for normal, sky and sun. So the field is compiled once, not nine times.
const int FIELD_MARCH = 0;
const int FIELD_NORMAL = 1;
const int FIELD_SKY = 2;
const int FIELD_WAX = 3;
const int FIELD_SUN = 4;
const int FIELD_DONE = 5;
#ifdef DERIVATIVE
const int NORMAL_STEPS = 1;
#else
const int NORMAL_STEPS = 6;
#endif

struct FieldSearch {
    int phase;
    int index;      // index within the phase
    float t;        // distance along the camera ray
    bool away;      // away from the surface, as far as lookups can tell
    float sunT;     // distance along the ray to the sun
    vec3 position;  // position on the surface
    vec3 normal;
    float open;     // visible share of the sky, 0 to 1
    float inside;   // sum of the field inside the solid, on the way to the sun
    float lit;      // smallest clearance towards the sun
};

vec3 differenceStep(int index, float h)
{
    vec3 e = vec3(0.0);
    e[index >> 1] = (index & 1) == 0 ? h : -h;
    return e;
}

// Point of the next evaluation.
vec3 searchPoint(FieldSearch s, PortalRay ray, float footprint)
{
    float cell = 1.0 / parameters.frequency;
    if (s.phase == FIELD_MARCH) return ray.origin + ray.direction * s.t;
    if (s.phase == FIELD_NORMAL) return NORMAL_STEPS == 1 ? s.position : s.position + differenceStep(s.index, 0.5 * footprint);
    if (s.phase == FIELD_SKY) return s.position + s.normal * (0.18 * cell * float(s.index + 1));
    if (s.phase == FIELD_WAX) return s.position - s.normal * footprint + work.sunDirection * (0.22 * cell * float(s.index + 1));
    return s.position + s.normal * footprint + work.sunDirection * s.sunT;
}

FieldSearch withNormal(FieldSearch found, vec3 slope, PortalRay ray)
{
    FieldSearch s = found;
    s.phase = FIELD_SKY;
    s.index = 0;
    // A surface that is cut open near the eye faces it.
    s.normal = safeNormalize(s.t - ray.start < 6.0 ? slope - ray.direction * CLEARING_SLOPE : slope, -ray.direction);
    return s;
}

FieldSearch searchFurther(FieldSearch before, FieldPoint f, PortalRay ray, float footprint)
{
    FieldSearch s = before;
    float cell = 1.0 / parameters.frequency;
    s.index += 1;
    if (s.phase == FIELD_MARCH) {
#ifdef HALVED
        float stride = max(0.5 * f.outside * cell, 1e-4);
#else
        float stride = max(f.stride, 0.5 * footprint * min(parameters.hitTolerance, 1.0));
#endif
        // At the step limit, the ray is near a surface that it grazes.
        if (f.outside < footprint * parameters.hitTolerance * parameters.frequency || s.index >= parameters.stepLimit) {
            s.phase = FIELD_NORMAL;
            s.index = 0;
            s.position = ray.origin + ray.direction * s.t;
            s.normal = vec3(0.0);
            // The last step evaluated all octaves and their slope, unless the step limit was exceeded.
            if (NORMAL_STEPS == 1 && f.complete) s = withNormal(s, f.slope, ray);
        } else {
            s.t += stride;
            s.away = f.outside > 1.2 * parameters.boundShare * lookedUpError();
        }
    } else if (s.phase == FIELD_NORMAL) {
        s.normal += NORMAL_STEPS == 1 ? f.slope : differenceStep(before.index, 1.0) * (f.outside / footprint);
        if (s.index == NORMAL_STEPS) s = withNormal(s, s.normal, ray);
    } else if (s.phase == FIELD_SKY) {
        float h = 0.18 * float(s.index);
        s.open += clamp(0.35 + f.outside / (0.9 * h), 0.0, 1.0) / 3.0;
        if (s.index == 3) {
            s.phase = FIELD_WAX;
            s.index = 0;
        }
    } else if (s.phase == FIELD_WAX) {
        s.inside += max(-f.outside, 0.0);
        if (s.index == 3) {
            s.phase = dot(s.normal, work.sunDirection) > 0.0 ? FIELD_SUN : FIELD_DONE;
            s.index = 0;
            s.sunT = 0.02 * cell + 2.0 * footprint;
        }
    } else {
        s.lit = min(s.lit, 7.0 * f.outside * cell / s.sunT);
        s.sunT += max(f.stride, 0.1 * cell);
        if (s.index == 14 || s.sunT > 2.5 * cell || s.lit <= 0.0) s.phase = FIELD_DONE;
    }
    return s;
}

FieldSearch searchStep(FieldSearch s, PortalRay ray, const bool looked)
{
    float footprint = s.t * ray.footprint;
    bool marching = s.phase == FIELD_MARCH;
    float width = s.phase >= FIELD_SKY ? max(footprint, 0.06 / parameters.frequency) : footprint;
#ifdef HALVED
    bool all = s.phase != FIELD_SUN;
#else
    bool all = !marching && s.phase != FIELD_SUN;
#endif
    vec3 direction = s.phase == FIELD_SUN ? work.sunDirection : ray.direction;
    float clear = marching ? clearing(s.t - ray.start) : 0.0;
    return searchFurther(s, fieldAt(searchPoint(s, ray, footprint), direction, width, clear, all, looked), ray, footprint);
}

// Air behind the field: the sky, continued below the horizon. The clearer the air, the darker it is: against deep
// shadow, thin parts glow.
vec3 backdrop(vec3 d)
{
    float share = mix(0.02, 0.75, parameters.haze);
    return share * skyLight(normalize(vec3(d.x, abs(d.y) * 0.6 + 0.04, d.z)));
}

vec3 shadeField(FieldSearch s, vec3 direction)
{
    vec3 n = s.normal;
    float lit = smoothstep(0.0, 1.0, s.lit) * max(dot(n, work.sunDirection), 0.0);
    float through = exp(-9.0 * s.inside) * (work.octaves == 1 ? 1.0 : 0.3);
    vec3 sun = sunLight();
    // Cavities have a deeper color than ridges.
    vec3 color = mix(parameters.albedo * parameters.albedo, parameters.albedo, smoothstep(0.1, 0.8, s.open));
    vec3 radiance = color * (skyAmbient(n.y) * mix(0.15, 1.0, s.open) + sun * 0.3183 * lit);
    // Light that passes through wax is colored twice.
    vec3 tint = parameters.albedo * mix(parameters.albedo, vec3(1.0), 0.3);
    radiance += tint * sun * (0.3183 * through * (0.35 + 0.65 * clamp(dot(direction, work.sunDirection), 0.0, 1.0)));
    vec3 h = safeNormalize(work.sunDirection - direction, n);
    radiance += sun * (0.35 * pow(max(dot(n, h), 0.0), 80.0) * lit);
    float mirrored = schlick(clamp(-dot(n, direction), 0.0, 1.0), 0.04);
    return mix(radiance, backdrop(reflect(direction, n)), mirrored * s.open * 0.35);
}

PortalSeen ourField(PortalRay ray)
{
    PortalSeen seen = nothingSeen();
    float reach = mix(30.0, 7.0, parameters.haze);
    float farthest = min(reach * 4.0, FIELD_FARTHEST);
    FieldSearch s = FieldSearch(FIELD_MARCH, 0, ray.start + 0.02, true, 0.0, vec3(0.0), vec3(0.0), 0.0, 0.0, 1.0);
    int steps = parameters.stepLimit + NORMAL_STEPS + 20;
#ifdef BAKED
    for (int i = 0; i < steps && s.phase < FIELD_SKY; ++i) {
        s.t = throughEmptySpace(ray, s.t, farthest, s.phase == FIELD_MARCH && s.away);
        if (s.t > farthest) break;
        s = searchStep(s, ray, false);
    }
    for (int i = 0; i < steps && s.phase >= FIELD_SKY && s.phase != FIELD_DONE; ++i) s = searchStep(s, ray, true);
#else
    for (int i = 0; i < steps && s.phase != FIELD_DONE && !(s.phase == FIELD_MARCH && s.t > farthest); ++i) s = searchStep(s, ray, false);
#endif
    vec3 back = backdrop(ray.direction) + sunDisk(ray.direction, ray.footprint) * 0.05;
    seen.radiance = back;
    if (s.phase != FIELD_MARCH) {
        seen.radiance = mix(back, shadeField(s, ray.direction), exp(-max(s.t - ray.start - 1.0, 0.0) / reach));
        seen.normal = s.normal;
        seen.distance = s.t;
    }
#ifdef COUNT_LOOKUPS
    seen.evaluations = lookups;
#else
    seen.evaluations = evaluations;
#endif
    return seen;
}

// Draws as the reference does: steps of half the value, colors by height, and fog by the number of steps.
PortalSeen referenceField(PortalRay ray)
{
    PortalSeen seen = nothingSeen();
    float t = 0.1;
    int steps = 0;
    bool hit = false;
    vec3 p = ray.origin;
    for (; steps < parameters.stepLimit && t < 100.0; ++steps) {
        p = ray.origin + ray.direction * (t + ray.start);
        float outside = fieldAt(p, ray.direction, 0.0, 0.0, true, false).outside * 0.5 + clearing(t);
        if (outside < 0.01) {
            hit = true;
            break;
        }
        t += 0.5 * outside / parameters.frequency;
    }
    vec3 background = vec3(0.0, 0.9, 0.9);
    vec3 color = 0.6 * background;
    if (hit) {
        vec3 q = p * parameters.frequency;
        vec3 base = vec3(0.0, 0.7, 0.7 * sin(q.y - work.time + cos(q.x))) * 0.5 + 0.5;
        float a = float(steps) / float(parameters.stepLimit);
        color = base * (1.0 - 0.5 * a) + 0.2 * a * background;
        seen.normal = safeNormalize(fieldAt(p, ray.direction, 0.0, 0.0, true, false).slope, -ray.direction);
        seen.distance = t + ray.start;
    }
    // The reference displays its values directly; exposed values are their square.
    seen.radiance = color * color * 0.8;
    seen.evaluations = evaluations;
    return seen;
}

PortalSeen portalSeen(PortalRay ray)
{
#ifdef REFERENCE
    return referenceField(ray);
#else
    return ourField(ray);
#endif
}

#include "kit/portal/main.glsl"
