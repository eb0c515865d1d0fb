// A lake at night: one ray per pixel, which water reflects further. One ray towards the moon starts where it ends,
// another one from the water that it hit first. Permutations: SHOW, one of SHOW_PICTURE and further;
// LEGS, number of rays in sequence; BOUNCES, number of these on water; REFERENCE, the shading of the reference;
// REPETITION, which cells around a point are searched; LANTERNS, WAVES, MIST, MOON, STARS, PANORAMA; MOON_ON_WATER, if
// lanterns shadow the water from the moon.
#define COPY_BLOCKS
#include "kit/portal/portal.glsl"
#include "lib/noise_sums.glsl"
#include "paper_lanterns/scene.glsl"

layout(binding = UNIT_EXHIBIT_A) uniform sampler3D afloat;

const float LAKE_FARTHEST = 30000.0;
const vec3 WATER_ABSORBS = vec3(0.35, 0.12, 0.1);  // per meter

Lantern lanternAt(ivec2 cell)
{
    vec4 a = texelFetch(afloat, ivec3(cell, 0), 0);
    vec4 b = texelFetch(afloat, ivec3(cell, 1), 0);
    return Lantern(a.xyz, b.xy, b.z, a.w, b.w, texelFetch(afloat, ivec3(cell, 2), 0).rgb);
}

#include "paper_lanterns/walk.glsl"
#include "paper_lanterns/fibers.glsl"
#include "paper_lanterns/participating_media.glsl"
#include "paper_lanterns/night_sky.glsl"
#include "paper_lanterns/water_and_paper.glsl"
#ifdef REFERENCE
#include "paper_lanterns/reference_shading.glsl"
#endif

vec3 lanternNormal(vec3 p, float width)
{
    float h = max(3e-4, 0.25 * width);
    vec3 n = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        vec3 e = vec3(0.0);
        e[i >> 1] = (i & 1) == 0 ? h : -h;
        n += e * lanternField(p + e).distance;
    }
    return safeNormalize(n, vec3(0.0, 1.0, 0.0));
}

// A ray segment, and the weight of its light.
struct Leg {
    LanternRay ray;
    vec3 weight;
    vec2 blur;      // standard deviations of its direction, vertical and horizontal
    bool toMoon;    // tests whether the moon is visible
    int mirrored;   // number of reflections by water so far
};

struct Gathered {
    vec3 radiance;
    vec3 pending;  // added if the moon is visible
};

vec3 skyAround(vec3 d, Leg leg, float pixel)
{
#if SHOW != SHOW_PICTURE
    return vec3(0.02, 0.022, 0.03);
#elif defined(REFERENCE)
    return referenceSky(d);
#else
    return skyLight(d, leg.blur, pixel);
#endif
}

vec3 partColor(int part)
{
    return part == PART_PAPER ? 2.0 * PAPER_SHOWN : (part == PART_WOOD ? vec3(0.3, 0.5, 0.2) : vec3(0.3, 0.4, 0.9));
}

// Adds the light of a lantern that the ray hit; the next ray goes from there to the moon.
Gathered meetLantern(Gathered before, Leg leg, LanternWalk walk, float pixel)
{
    Gathered now = before;
    vec3 d = leg.ray.direction;
    float width = coneWidth(leg.ray, walk.distance).x;
    mat3 axes = lakeFromLantern(walk.lantern);
    vec3 n = lanternNormal(walk.local, width);
    if (dot(n, d * axes) > 0.0 && walk.part == PART_PAPER) n = -n;
    vec3 world = axes * n;
    vec3 p = leg.ray.origin + d * walk.distance;
    float left = mistLeft(leg.ray.origin, d, walk.distance);
#if SHOW == SHOW_NORMALS
    now.radiance += leg.weight * (0.5 + 0.5 * world) * 0.6;
#elif SHOW != SHOW_PICTURE
    now.radiance += leg.weight * partColor(walk.part) * (0.35 + 0.3 * max(world.y, -world.z));
#else
#ifdef REFERENCE
    Lit lit = referenceLantern(walk, n, world, d * axes);
#else
    vec3 outer = lanternLight(p, world, walk.lantern.place);
    outer += PI * 0.5 * nightAir(vec3(0.0, 1.0, 0.0)) * (1.0 + world.y);
    vec3 moon = lake.towardsMoon * axes;
    Lit lit;
    if (walk.part == PART_PAPER) lit = litPaper(walk, n, d * axes, outer, moon, width);
    else lit = litFrame(walk, n, d * axes, outer, moon, width);
    // Inside the tube, the flame is in front of paper and base.
    if (length(walk.local.xz) < lake.paperRadius && walk.local.y > 0.0)
        lit.radiance += flameLight((leg.ray.origin - walk.lantern.place) * axes, d * axes, walk.distance, width, walk.lantern.light);
#endif
    now.radiance += leg.weight * mix(mistLight(), lit.radiance, left);
#ifdef MOON
    now.pending = leg.weight * left * lit.byMoon;
#endif
#endif
    return now;
}

Leg towardsMoon(Leg from, LanternWalk walk)
{
    Leg leg = from;
    vec3 p = leg.ray.origin + leg.ray.direction * walk.distance;
    float away = 0.012 + 2.0 * coneWidth(leg.ray, walk.distance).x;
    leg.ray.origin = p + lake.towardsMoon * away - leg.ray.direction * 0.5 * away;
    leg.ray.direction = lake.towardsMoon;
    leg.ray.from = 0.0;
    leg.ray.width = vec2(0.0);
    leg.ray.spread = vec2(1e-5);
    leg.toMoon = true;
    return leg;
}

// Ray from the water to the moon. Its width is the pixel's footprint on the water, its spread that of the moon's disk.
Leg towardsMoonFrom(vec3 p, vec2 cone, float grazing)
{
    float along = cone.x + cone.y / grazing * lake.towardsMoon.y;
    LanternRay ray = LanternRay(p + vec3(0.0, 0.01, 0.0), lake.towardsMoon, 0.0, LAKE_FARTHEST, vec2(cone.x, along), vec2(2.0 * lake.moonTanRadius));
    return Leg(ray, vec3(1.0), vec2(0.0), true, 0);
}

// Light of the water itself, and the ray that it reflects.
struct Mirror {
    vec3 body;
    vec3 byMoon;  // light of the moon, if it is visible from there
    vec3 share;
    Leg leg;
    Leg toMoon;
};

Mirror meetWater(Leg from, float t, float pixel)
{
    Mirror m;
    m.leg = from;
    vec3 d = from.ray.direction;
    vec3 p = from.ray.origin + d * t;
    vec2 cone = coneWidth(from.ray, t);
    vec2 ahead = d.xz / max(length(d.xz), 1e-5);
    bool below = d.y > 0.0 && from.ray.origin.y < p.y;
    float grazing = max(abs(d.y), 0.01);
    WaterSurface water = waterSurface(p.xz, ahead, vec2(cone.y / grazing, cone.x));
    vec3 n = below ? -water.normal : water.normal;
    float cosine = dot(n, -d);
    if (cosine < 0.02) n = safeNormalize(n - d * (0.02 - cosine), vec3(0.0, 1.0, 0.0));
    cosine = clamp(dot(n, -d), 0.02, 1.0);
    vec2 rough = sqrt(water.hidden);
#ifdef REFERENCE
    float fresnel = 0.6;
    vec3 body = parameters.waterColor;
    m.byMoon = vec3(0.0);
#else
    // Among unresolved slopes, those that face the eye are more visible, and reflect less.
    float fresnel = fresnelDielectric(clamp(cosine + 0.5 * rough.x, 0.0, 1.0), below ? 1.0 / 1.333 : 1.333);
    vec3 body = parameters.waterColor * (nightAir(vec3(0.0, 0.7, -0.714)) * 2.0 + lanternLight(p, n, vec3(1e9)) * 0.6);
    m.byMoon = parameters.waterColor * lake.moonLight * (0.3 * max(lake.towardsMoon.y, 0.0) * (1.0 - fresnel));
#endif
    m.toMoon = towardsMoonFrom(p, cone, grazing);
    m.body = body * (1.0 - fresnel);
    m.share = vec3(fresnel);
    vec3 mirrored = reflect(d, n);
#ifndef REFERENCE
    if (below) {
        // Seen from below: the refracted ray through the surface. Nothing is visible in deep water.
        vec3 through = refract(d, n, 1.333);
        m.share = vec3(1.0 - fresnel) * exp(-WATER_ABSORBS * t);
        m.body = parameters.waterColor * 0.4;
        m.byMoon = vec3(0.0);
        mirrored = dot(through, through) > 0.5 ? through : vec3(0.0, 1.0, 0.0);
    }
#endif
    mirrored.y = max(abs(mirrored.y) + 0.5 * rough.x, 0.002);
    m.leg.ray.direction = normalize(mirrored);
    m.leg.ray.origin = p + vec3(0.0, 0.004 + 0.02 * cone.x, 0.0);
    m.leg.ray.from = 0.0;
    m.leg.blur = sqrt(from.blur * from.blur + vec2(2.0 * rough.x, 2.0 * rough.y * grazing) * vec2(2.0 * rough.x, 2.0 * rough.y * grazing));
    m.leg.ray.width = cone;
    // Width of a box with the same variance.
    m.leg.ray.spread = vec2(pixel) + 3.46 * vec2(m.leg.blur.y, m.leg.blur.x);
    m.leg.mirrored = from.mirrored + 1;
    return m;
}

#if SHOW == SHOW_HEIGHTS || SHOW == SHOW_NORMALS
// Heights or normals of the water, as colors.
vec3 waterShown(Leg leg, float t)
{
    vec3 p = leg.ray.origin + leg.ray.direction * t;
    vec2 cone = coneWidth(leg.ray, t);
    vec2 ahead = leg.ray.direction.xz / max(length(leg.ray.direction.xz), 1e-5);
#if SHOW == SHOW_HEIGHTS
    float h = clamp(lakeAt(p.xz).height * parameters.exaggeration / 0.2075, -1.0, 1.0);
    return mix(vec3(0.02, 0.05, 0.3), vec3(0.9, 0.75, 0.35), 0.5 + 0.5 * h);
#else
    vec3 n = waterSurface(p.xz, ahead, vec2(cone.y / max(abs(leg.ray.direction.y), 0.01), cone.x)).normal;
    vec2 slope = n.xz / max(n.y, 0.05) * parameters.exaggeration;
    n = normalize(vec3(slope.x, 1.0, slope.y));
    return (0.5 + 0.5 * n) * 0.6;
#endif
}
#endif

LanternWalk lanternsAlong(LanternRay ray)
{
#ifdef LANTERNS
#ifdef REPETITION
    return walkNeighbors(ray, REPETITION, 4 * lake.stepLimit);
#else
    return walkLanterns(ray);
#endif
#else
    return nothingMet(ray);
#endif
}

float waterAlong(LanternRay ray)
{
#ifdef WAVES
    return waterDistance(ray.origin, ray.direction, ray.from, LAKE_FARTHEST, ray.spread.x, lake.tolerance, parameters.waterSteps);
#else
    float t = abs(ray.direction.y) < 1e-9 ? -1.0 : -ray.origin.y / ray.direction.y;
    return t > ray.from && t < LAKE_FARTHEST ? t : -1.0;
#endif
}

bool underWater(vec3 p)
{
#ifdef WAVES
    return p.y < lakeAt(p.xz).height;
#else
    return p.y < 0.0;
#endif
}

PortalSeen portalSeen(PortalRay eye)
{
    PortalSeen seen;
    seen.normal = vec3(0.0);
    seen.distance = 1e20;
    seen.albedo = vec3(0.0);
    LanternRay ray = LanternRay(eye.origin, eye.direction, eye.start, LAKE_FARTHEST, vec2(0.0), vec2(eye.footprint));
    Leg leg = Leg(ray, vec3(1.0), vec2(0.3 * eye.footprint), false, 0);
    Gathered sum = Gathered(vec3(0.0), vec3(0.0));
    bool under = underWater(eye.origin + eye.direction * eye.start);
    // From above, water that stands higher than the opening's lower edge is met in front of it, where there are no
    // lanterns.
    bool before = under && !underWater(eye.origin);
    if (before) {
        under = false;
        leg.ray.from = 0.0;
    }
    Leg fromWater = leg;
    vec3 ofWater = vec3(0.0);  // depends on the moon being visible from there
    for (int i = 0; i < LEGS; ++i) {
        float t = leg.toMoon ? -1.0 : waterAlong(leg.ray);
        leg.ray.to = t > 0.0 ? t : LAKE_FARTHEST;
        if (before && i == 0) leg.ray.from = leg.ray.to;
        LanternWalk walk = lanternsAlong(leg.ray);
        bool ends = leg.toMoon;
        // A lantern so far away that it is a point is not visible through water.
        bool through = under && i == 0;
        if (!leg.toMoon && !through) {
            sum.radiance += leg.weight * walk.glow;
            leg.weight *= walk.left;
        }
        if (leg.toMoon && walk.part == PART_NONE) sum.radiance += sum.pending * walk.left;
        if (i == 0 && (walk.part != PART_NONE || t > 0.0)) {
            seen.distance = walk.distance;
            seen.normal = vec3(0.0, 1.0, 0.0);
        }
        // Light from deep water is absorbed on its way; without a hit it is dark.
        if (through && walk.part != PART_NONE) {
            vec3 clear = exp(-WATER_ABSORBS * walk.distance);
            sum.radiance += leg.weight * (parameters.waterColor * 0.4) * (1.0 - clear);
            leg.weight *= clear;
        }
        if (through && walk.part == PART_NONE && t <= 0.0) {
            sum.radiance += leg.weight * parameters.waterColor * 0.4;
            ends = true;
        }
        if (!ends && walk.part != PART_NONE) {
            sum = meetLantern(sum, leg, walk, eye.footprint);
            ends = dot(sum.pending, vec3(1.0)) <= 1e-6;
            leg = towardsMoon(leg, walk);
        } else if (!ends) {
#ifdef LANTERNS
            vec4 beyond = through ? vec4(0.0, 0.0, 0.0, 1.0) : farLanterns(leg.ray, walk.end);
            sum.radiance += leg.weight * beyond.rgb;
            leg.weight *= beyond.a;
#endif
            if (t <= 0.0) {
                sum.radiance += leg.weight * skyAround(leg.ray.direction, leg, eye.footprint);
                ends = true;
            } else {
#if SHOW == SHOW_HEIGHTS || SHOW == SHOW_NORMALS
                sum.radiance += leg.weight * waterShown(leg, t);
                ends = true;
#elif SHOW == SHOW_PARTS
                sum.radiance += leg.weight * vec3(0.02, 0.06, 0.1);
                ends = true;
#else
                float left = through ? 1.0 : mistLeft(leg.ray.origin, leg.ray.direction, t);
                sum.radiance += leg.weight * (1.0 - left) * mistLight();
                leg.weight *= left;
                Mirror m = meetWater(leg, t, eye.footprint);
                sum.radiance += leg.weight * m.body;
#ifdef MOON_ON_WATER
                if (leg.mirrored == 0) {
                    ofWater = leg.weight * m.byMoon;
                    fromWater = m.toMoon;
                }
#else
                sum.radiance += leg.weight * m.byMoon;
#endif
                vec3 weight = leg.weight * m.share;
                ends = leg.mirrored >= BOUNCES;
                leg = m.leg;
                leg.weight = weight;
                if (before && i == 0) leg.ray.from = max(eye.start - t, 0.0);
                if (ends) sum.radiance += weight * skyAround(leg.ray.direction, leg, eye.footprint);
#endif
            }
        }
        if (!ends) continue;
        if (dot(ofWater, vec3(1.0)) <= 1e-6) break;
        leg = fromWater;
        sum.pending = ofWater;
        ofWater = vec3(0.0);
    }
    seen.radiance = sum.radiance;
    seen.evaluations = float(evaluations);
    return seen;
}

#include "kit/portal/main.glsl"
