// Sphere tracing of one signed distance field: surfaces, normals, shadows, occlusion.
//
// How to use it, in GLSL:
//     #include "sdf_morph/torus_mug.glsl"
//     float fieldDistance(vec3 p) { return sdfTorusMug(p, shape); }      // the field, defined first
//     #include "lib/sphere_tracing.glsl"
//     ...
//     vec2 span = rayBox(eye, direction, low, high);                     // inside the bounding box
//     if (span.x > span.y) discard;
//     MarchSettings settings = marchSettings(span.x, span.y, pixelCone); // then change what differs
//     March march = sphereTrace(eye, direction, settings);
//     if (!march.hit) discard;
//     vec3 p = eye + direction * march.t;
//     vec3 normal = fieldNormal(p, normalStep(march.t, settings), NORMAL_CENTRAL, -direction);
// In C++: `Tracer` in render/glsl/cpu.h. `direction` has unit length everywhere, in the field's space. pixelCone =
// tan(fovY / 2) / height in pixels: half a pixel's width at distance 1.
//
// fieldDistance must be 1-Lipschitz (lib/sdf.glsl says which functions are); a steeper one must be divided by its
// Lipschitz constant first. If that makes it rough, define FIELD_LEVEL, a smooth function with the same zeros and
// signs, for normals and occlusion. Also define FIELD_CLEARANCE(d), its value at the point of fieldDistance's last
// result d, for the estimate of soft shadows, and FIELD_BUDGET, the calls after which shadowArea takes no further rays.
// Every `evaluations` counts calls of fieldDistance, exactly.
//
// GLSL 4.50 and C++: no swizzles beyond one component, no `inout`, literals with a point.

#ifndef __cplusplus
#include "lib/numerics.glsl"
#include "lib/ray_box.glsl"
#endif

#ifndef FIELD_LEVEL
#define FIELD_LEVEL fieldDistance
#endif
#ifndef FIELD_CLEARANCE
#define FIELD_CLEARANCE(d) (d)
#endif
#ifndef FIELD_BUDGET
#define FIELD_BUDGET 2147483647
#endif

const int RELAXATION_NONE = 0;
const int RELAXATION_FIXED = 1;
const int RELAXATION_AUTOMATIC = 2;

const int NORMAL_FORWARD = 0;
const int NORMAL_TETRAHEDRON = 1;
const int NORMAL_CENTRAL = 2;

// ---- Surfaces ------------------------------------------------------------------------------------

struct MarchSettings {
    float tMin;            // Meters along the ray.
    float tMax;
    float pixelCone;       // Half a pixel's width at distance 1.
    float traveled;       // Length of the path before this ray: 0 from the eye, more after reflections.
    float tolerance;       // Hit tolerance, in half pixels.
    // Meters; minimum of the tolerance. Must exceed the rounding error of positions in the scene.
    float toleranceFloor;
    int stepLimit;
    int relaxation;        // RELAXATION_...
    float omega;           // RELAXATION_FIXED: steps are this many distances long, 1 to 2.
    float side;            // 1 outside the solid, -1 inside it (refraction), 0: determined at the start.
};

struct March {
    bool hit;
    float t;          // Meters along the ray; where it ended if it did not hit.
    float distance;   // Value of the field there; negative inside the solid.
    float side;       // -1 if the ray traveled inside the solid: the outward normal then points away from the viewer.
    int steps;        // Points accepted.
    int evaluations;  // Points evaluated: more than `steps` if relaxed steps had to be taken back.
    bool exhausted;   // The step limit ended the ray; a hit is then the best candidate.
};

MarchSettings marchSettings(float tMin, float tMax, float pixelCone)
{
    MarchSettings s;
    s.tMin = tMin;
    s.tMax = tMax;
    s.pixelCone = pixelCone;
    s.traveled = 0.0;
    s.tolerance = 1.0;
    s.toleranceFloor = 1.0e-5;
    s.stepLimit = 128;
    s.relaxation = RELAXATION_AUTOMATIC;
    s.omega = 1.2;
    s.side = 0.0;
    return s;
}

// Hit tolerance at t: half a pixel, as seen from the eye. An absolute tolerance would be finer than float32 far away,
// so that thin wires are missed, and wasteful everywhere else.
float hitTolerance(float t, MarchSettings s)
{
    return max(s.pixelCone * (t + s.traveled) * s.tolerance, s.toleranceFloor);
}

// Length of the next step from a point at distance `radius`, given the slope of the distance along the ray.
//
// RELAXATION_AUTOMATIC steps to where the unbounding sphere beyond would just touch this one if the slope
// stayed: 2 r / (1 - slope). Valasek and Balint 2023, "Automatic Step Size Relaxation in Sphere Tracing".
float relaxedStep(float radius, float slope, MarchSettings s)
{
    if (s.relaxation == RELAXATION_FIXED) return radius * clamp(s.omega, 1.0, 1.999);
    if (s.relaxation == RELAXATION_AUTOMATIC) return max(radius, 2.0 * radius / (1.0 - min(slope, 0.9)));
    return radius;
}

// Finds the first surface along the ray. Hart 1996, "Sphere Tracing". Relaxed steps are taken back if the unbounding
// spheres at their ends do not touch (Keinert et al. 2014, "Enhanced Sphere Tracing"), so that no surface is ever
// stepped over.
//
// Special starts. A ray that starts at its origin (tMin = 0) on the surface, within the tolerance, first leaves it: it
// cannot hit before it has left the surface, or is deeper inside than the tolerance. If its origin is inside the solid,
// it travels to the exit. A ray that starts later (tMin > 0, at the face of a box) inside the solid hits there: a box
// that is too small shows a cut.
// A ray that reaches the step limit still hits in two cases: if its closest approach was within a pixel, as seen from
// the eye, or if it was still approaching and one more evaluation of the field confirms that it would have arrived. So
// grazing views have no holes.
March sphereTrace(vec3 origin, vec3 direction, MarchSettings s)
{
    March march;
    march.hit = false;
    march.t = s.tMin;
    march.distance = 0.0;
    march.side = s.side;
    march.steps = 0;
    march.evaluations = 0;
    march.exhausted = false;
    if (!(s.tMin <= s.tMax)) return march;

    float radius = 0.0;      // Distance at march.t, positive on the side we travel.
    float stepLength = 0.0;  // Step on trial, from march.t.
    float slope = -1.0;
    bool free = s.tMin > 0.0;  // The ray has left the surface that it started on.
    float candidateCone = 1.0e30;
    float candidateT = s.tMin;
    float candidateDistance = 0.0;
    float pixel = s.pixelCone * s.tolerance;

    for (int i = 0; i <= s.stepLimit; ++i) {
        // The field is evaluated at one place of the code: a SIMD processor without branches would pay for a second
        // one.
        bool outOfSteps = i == s.stepLimit;
        if (outOfSteps) {
            march.exhausted = true;
            bool arriving = free && slope < -1.0e-4 && radius <= 32.0 * pixel * (march.t + s.traveled) &&
                            march.t - radius / slope < s.tMax;
            if (!arriving) break;
            stepLength = -radius / slope;
        }

        float t = march.t + stepLength;
        float value = fieldDistance(origin + direction * t);
        march.evaluations = i + 1;
        float tolerance = hitTolerance(t, s);
        if (outOfSteps) {
            if (abs(value) > 2.0 * tolerance) break;
            march.hit = true;
            march.t = t;
            march.distance = value;
            return march;
        }
        if (i == 0 && march.side == 0.0) march.side = value < -tolerance && !free ? -1.0 : 1.0;
        float d = march.side * value;

        if (free && stepLength > radius && (d < 0.0 || stepLength > radius + d)) {
            stepLength = radius;  // Too long: the spheres do not touch, so a surface may lie between them.
            slope = -1.0;
            continue;
        }

        if (i > 0 && stepLength > 0.0) slope = slope + 0.3 * ((d - radius) / stepLength - slope);
        bool approaching = free && d < radius;
        march.t = t;
        march.steps += 1;
        radius = d;

        if (!free) {
            if (d > tolerance) free = true;
            else if (d < -tolerance) march.hit = true;
        } else if (d <= tolerance) {
            march.hit = true;
        }
        if (march.hit) {
            march.distance = value;
            return march;
        }

        float cone = d / max(t + s.traveled, 1.0e-20);
        if (approaching && cone < candidateCone) {
            candidateCone = cone;
            candidateT = t;
            candidateDistance = value;
        }
        if (free && t + radius >= s.tMax) {
            march.distance = value;
            march.t = s.tMax;
            return march;
        }
        stepLength = free ? relaxedStep(radius, slope, s) : 2.0 * tolerance;
        if (t + stepLength > s.tMax) {
            if (!free) return march;
            stepLength = max(radius, s.tMax - t);
        }
    }

    if (march.exhausted && candidateCone <= 2.0 * pixel) {
        march.hit = true;
        march.t = candidateT;
        march.distance = candidateDistance;
    }
    return march;
}

// ---- Cone pre-pass -------------------------------------------------------------------------------

struct ConeMarch {
    bool empty;       // No ray of the cone meets the field before tMax.
    float t;          // Otherwise: no ray of the cone meets it before t.
    int evaluations;
};

// Distance of a direction from a bundle's axis; the largest one over the bundle's corners is the `chord` of coneMarch.
// Use the corners of the block of pixels, not the centers of its outer pixels, to cover samples anywhere inside the
// pixels.
float coneChord(vec3 axis, vec3 direction)
{
    return length(direction - axis);
}

// Returns where the rays of a bundle may start, by a march along its axis; at every t they are within chord * t of it.
// One such march for a block of 8 x 8 pixels saves each of them all the steps through free space.
//
// The ball of the field's radius f at t frees all rays of the bundle from (t - f) / (1 - chord) to
// (t + f) / (1 + chord); relaxed steps must keep these spans touching. `s` as for the rays, tMin and tMax
// covering theirs; its tolerance, step limit and side are not used.
ConeMarch coneMarch(vec3 origin, vec3 axis, float chord, MarchSettings s)
{
    ConeMarch cone;
    cone.empty = false;
    cone.t = s.tMin;
    cone.evaluations = 0;
    if (!(s.tMin <= s.tMax)) {
        cone.empty = true;
        return cone;
    }
    float freeTo = s.tMin;   // Rays are free of surfaces up to here.
    float t = s.tMin;        // Position of the last accepted ball.
    float radius = 0.0;
    float slope = -1.0;
    float next = s.tMin;
    for (int i = 0; i < 64; ++i) {
        float f = fieldDistance(origin + axis * next);
        cone.evaluations = i + 1;
        if (i > 0 && next > freeTo && !((next - f) <= freeTo * (1.0 - chord))) {
            next = freeTo;  // The step was too long: the balls do not overlap.
            slope = -1.0;
            continue;
        }
        if (next > t) slope = slope + 0.3 * ((f - radius) / (next - t) - slope);
        float reach = (next + f) / (1.0 + chord);
        t = next;
        radius = f;
        float gain = reach - freeTo;
        freeTo = max(freeTo, reach);
        cone.t = freeTo;
        if (freeTo >= s.tMax) {
            cone.empty = true;
            return cone;
        }
        // The ball is hardly larger than the bundle: single rays are faster from here on.
        if (f < 1.5 * chord * t || !(gain > 0.0)) return cone;
        next = max(freeTo, min(t + relaxedStep(radius - chord * t, slope, s), s.tMax));
    }
    return cone;
}

// Interval of a bundle inside a box: as rayBox, for all its rays at once.
vec2 coneBox(vec3 origin, vec3 axis, float chord, vec3 low, vec3 high)
{
    vec3 farthest = max(abs(low - origin), abs(high - origin));
    float spread = chord * length(farthest);
    return rayBox(origin, axis, low - vec3(spread), high + vec3(spread));
}

// ---- Normals -------------------------------------------------------------------------------------

// Step of the differences at distance t: a quarter of the hit tolerance's scale, but at least `3e-4` of a meter-sized
// object. Below that, float32 cancellation outweighs the smaller truncation error.
float normalStep(float t, MarchSettings s)
{
    return max(3.0e-4, 0.25 * s.pixelCone * (t + s.traveled));
}

// Unit gradient of the field, or `fallback` (minus the ray's direction) if the field has no slope: on the ridge between
// two parts, where differences cancel, and if the step is wider than the solid. Costs 4, 4 and 6 evaluations. Central
// differences are the default: only their error is of second order in the step. Near a crease, where all methods blur
// the normal, they blur it least.
vec3 fieldNormal(vec3 p, float h, int method, vec3 fallback)
{
    vec3 gradient = vec3(0.0);
    int taps = method == NORMAL_CENTRAL ? 6 : 4;
    for (int i = 0; i < taps; ++i) {  // One loop for all methods, so that the field is compiled once.
        vec3 offset = vec3(i < 2 ? 1.0 : -1.0, i == 0 || i == 2 ? 1.0 : -1.0, i == 0 || i == 3 ? 1.0 : -1.0);
        vec3 weight = 0.25 * offset;  // The corners of a tetrahedron.
        if (method != NORMAL_TETRAHEDRON) {
            int axis = i < 3 ? i : i - 3;
            vec3 along = vec3(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0);
            offset = i < 3 ? along : -along;
            weight = 0.5 * offset;
            if (method == NORMAL_FORWARD) {
                weight = i < 3 ? along : vec3(-1.0);
                if (i == 3) offset = vec3(0.0);
            }
        }
        gradient = gradient + weight * FIELD_LEVEL(p + offset * h);
    }
    // A field of slope 1 gives a gradient of length h here.
    return length(gradient) > 1.0e-3 * h ? safeNormalize(gradient, fallback) : fallback;
}

// ---- Shadows -------------------------------------------------------------------------------------

struct Shadow {
    float visibility;  // Visible share of the light: 0 hidden, 1 fully visible.
    int evaluations;
};

// Arguments of all shadow functions: `p` is on the surface, and the light is in front of it. Test n.l > 0 first: a ray
// towards a light behind the surface costs steps and causes shadow acne. `tMin` > 0 is off the surface, `tMax` at the
// light or the end of the field. `tanRadius` is the tangent of the light's half angle as seen from p. tMin is at least
// 1e-5, because the soft methods divide by the distance traveled.

// Shadow of a point light.
Shadow shadowHard(vec3 p, vec3 toLight, float tMin, float tMax, int stepLimit)
{
    Shadow shadow;
    shadow.visibility = 1.0;
    shadow.evaluations = 0;
    float t = max(tMin, 1.0e-5);
    for (int i = 0; i < stepLimit && t < tMax; ++i) {
        float d = fieldDistance(p + toLight * t);
        shadow.evaluations = i + 1;
        if (d < 1.0e-4) {
            shadow.visibility = 0.0;
            return shadow;
        }
        t += d;
    }
    return shadow;
}

// Soft shadow by the smallest angle between the ray and the solid. Quilez 2010, "Soft shadows in raymarched SDFs". The
// penumbra lies only outside the hard edge, so the light seems larger and brighter than it is.
Shadow shadowClassic(vec3 p, vec3 toLight, float tanRadius, float tMin, float tMax, int stepLimit)
{
    Shadow shadow;
    shadow.visibility = 1.0;
    shadow.evaluations = 0;
    float width = max(tanRadius, 1.0e-4);
    float t = max(tMin, 1.0e-5);
    for (int i = 0; i < stepLimit && t < tMax; ++i) {
        float d = fieldDistance(p + toLight * t);
        shadow.evaluations = i + 1;
        shadow.visibility = min(shadow.visibility, max(FIELD_CLEARANCE(d), 0.0) / (width * t));
        if (d < 1.0e-4) {
            shadow.visibility = 0.0;
            return shadow;
        }
        t += d;
    }
    return shadow;
}

// The same with the closest approach estimated between the samples, from two neighboring unbounding
// spheres. Aaltonen 2018, "GPU-based clay simulation and ray-tracing tech in Claybook", GDC.
Shadow shadowAaltonen(vec3 p, vec3 toLight, float tanRadius, float tMin, float tMax, int stepLimit)
{
    Shadow shadow;
    shadow.visibility = 1.0;
    shadow.evaluations = 0;
    float width = max(tanRadius, 1.0e-4);
    float t = max(tMin, 1.0e-5);
    float previous = 1.0e20;
    for (int i = 0; i < stepLimit && t < tMax; ++i) {
        float d = fieldDistance(p + toLight * t);
        shadow.evaluations = i + 1;
        if (d < 1.0e-4) {
            shadow.visibility = 0.0;
            return shadow;
        }
        float clear = FIELD_CLEARANCE(d);
        float back = clear * clear / (2.0 * previous);
        float closest = safeSqrt(clear * clear - back * back);
        shadow.visibility = min(shadow.visibility, closest / (width * max(t - back, 1.0e-5)));
        previous = clear;
        t += d;
    }
    return shadow;
}

// Default. The ray continues through the solid as deep as the light is wide. The signed clearance in light radii, -1 to
// 1, says how far the solid's edge has moved across the light's disk. Umbra and penumbra are where a real disk has
// them. Form with inner penumbra: Quilez, "Soft shadows", after Bandi's signed variant; without the usual upper limit
// on steps, which triples the cost.
// Limit: the clearance inside a part ends at half its thickness, so a sheet thinner than the light's disk lets up to
// half of the light through. shadowArea does not have this error.
Shadow shadowSigned(vec3 p, vec3 toLight, float tanRadius, float tMin, float tMax, int stepLimit)
{
    Shadow shadow;
    shadow.evaluations = 0;
    float width = max(tanRadius, 1.0e-4);
    float clearance = 1.0;
    float t = max(tMin, 1.0e-5);
    for (int i = 0; i < stepLimit && t < tMax; ++i) {
        float d = fieldDistance(p + toLight * t);
        shadow.evaluations = i + 1;
        clearance = min(clearance, FIELD_CLEARANCE(d) / (width * t));
        if (clearance < -1.0) break;
        t += max(abs(d), 0.25 * width * t + 1.0e-3);  // Steps through the band where d is about 0.
    }
    shadow.visibility = smoothStep(-1.0, 1.0, clearance);
    return shadow;
}

// Accurate: `rayCount` hard rays over the light's disk in Vogel's sunflower pattern, rotated by `rotation` (radians; a
// different one per pixel, from lib/hash.glsl, replaces banding by noise).
Shadow shadowArea(vec3 p, vec3 toLight, float tanRadius, float tMin, float tMax, int stepLimit, int rayCount,
                  float rotation)
{
    Shadow shadow;
    shadow.visibility = 1.0;
    shadow.evaluations = 0;
    if (rayCount < 1) return shadow;
    // Orthonormal frame without a singular axis: Duff et al. 2017.
    float sz = toLight.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sz + toLight.z);
    float b = toLight.x * toLight.y * a;
    vec3 u = vec3(1.0 + sz * toLight.x * toLight.x * a, sz * b, -sz * toLight.x);
    vec3 v = vec3(b, sz + toLight.y * toLight.y * a, -toLight.y);
    float seen = 0.0;
    int taken = 0;
    for (int k = 0; k < rayCount && shadow.evaluations < FIELD_BUDGET; ++k) {
        float radius = tanRadius * sqrt((float(k) + 0.5) / float(rayCount));
        float angle = float(k) * 2.39996322972865332 + rotation;  // The golden angle.
        vec3 direction = normalize(toLight + u * (radius * cos(angle)) + v * (radius * sin(angle)));
        Shadow one = shadowHard(p, direction, tMin, tMax, stepLimit);
        seen += one.visibility;
        shadow.evaluations += one.evaluations;
        taken = k + 1;
    }
    if (taken > 0) shadow.visibility = seen / float(taken);
    return shadow;
}

// ---- Ambient occlusion ---------------------------------------------------------------------------

// Unoccluded share of the sky above the normal, 0 to 1, from five samples along the normal within `radius` meters
// (exactly 1 for a radius of 0). 5 evaluations. After Evans 2006, "Fast Approximations for Global Illumination on
// Dynamic Scenes"; samples at radius k^2 / 25 with weights 1 / k, which halves the error of the usual constants.
float fieldOcclusion(vec3 p, vec3 normal, float radius)
{
    if (!(radius > 0.0)) return 1.0;
    float blocked = 0.0;
    float total = 0.0;
    for (int k = 1; k <= 5; ++k) {
        float height = radius * float(k * k) * 0.04;
        float weight = 1.0 / float(k);
        blocked += weight * clamp(1.0 - FIELD_LEVEL(p + normal * height) / height, 0.0, 1.0);
        total += weight;
    }
    return clamp(1.0 - blocked / total, 0.0, 1.0);
}
