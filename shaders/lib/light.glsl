// Functions for the light block: sun, sky, shadow maps, reflection probe. Permutation: FLAT_LIGHT of
// lib/light_uniform.glsl.
#include "lib/bindings.glsl"
#include "lib/air_light.glsl"
#include "lib/light_uniform.glsl"
#include "lib/numerics.glsl"
#include "lib/ray_box.glsl"

layout(binding = UNIT_SHADOW_HALL) uniform sampler2DShadow hallShadow;
layout(binding = UNIT_SHADOW_EXHIBITS) uniform sampler2DShadow exhibitShadow;
layout(binding = UNIT_PROBE) uniform samplerCube probe;
layout(binding = UNIT_PROBE_IRRADIANCE) uniform sampler2D probeIrradiance;
layout(binding = UNIT_AIR_LIGHT) uniform sampler3D airLight;
#ifdef GLASS_SHADOWS
layout(binding = UNIT_SHADOW_GLASS) uniform sampler2D glassShadow;
#endif

#ifndef SHADOW_FILTER
#define SHADOW_FILTER SHADOW_FILTER_HARD
#endif

bool isInShadowMap(vec3 position)
{
    return !(any(lessThan(position, vec3(0.0))) || any(greaterThan(position, vec3(1.0))));
}

// Share of the light that reaches `position` in one map, by one bilinear comparison.
float shadowMapLight(sampler2DShadow map, vec3 position)
{
    return isInShadowMap(position) ? textureLod(map, position, 0.0) : 1.0;
}

// The same with a tent filter over 3x3 or 5x5 texels, by 4 or 9 bilinear comparisons. Each lies between two texels in
// proportion to their weights, so that the result varies smoothly (Castano 2013, "Shadow Mapping Summary"). Returns 1
// if not `wanted`. Uses a loop: a software renderer executes skipped branches, but leaves a loop when no pixel needs
// it.
float shadowTentLight(sampler2DShadow map, vec3 position, bool wanted)
{
    vec2 size = vec2(textureSize(map, 0));
    vec2 texel = position.xy * size;
    vec2 base = floor(texel + 0.5);
    vec2 s = texel + 0.5 - base;
    base -= 0.5;
#if SHADOW_FILTER == SHADOW_FILTER_TENT_3
    const int across = 2;
    const float whole = 16.0;
    vec2 w0 = 3.0 - 2.0 * s, w1 = vec2(0.0), w2 = 1.0 + 2.0 * s;
    vec2 o0 = (2.0 - s) / w0 - 1.0, o1 = vec2(0.0), o2 = s / w2 + 1.0;
#else
    const int across = 3;
    const float whole = 144.0;
    vec2 w0 = 4.0 - 3.0 * s, w1 = vec2(7.0), w2 = 1.0 + 3.0 * s;
    vec2 o0 = (3.0 - 2.0 * s) / w0 - 2.0, o1 = (3.0 + s) / 7.0, o2 = s / w2 + 2.0;
#endif
    float lit = 0.0;
    int taps = wanted && isInShadowMap(position) ? across * across : 0;
    for (int i = 0; i < taps; ++i) {
        int row = i / across;
        ivec2 at = ivec2(i - row * across, row);
        bvec2 isFirst = equal(at, ivec2(0)), isLast = equal(at, ivec2(across - 1));
        vec2 weight = mix(mix(w1, w2, isLast), w0, isFirst);
        vec2 offset = mix(mix(o1, o2, isLast), o0, isFirst);
        lit += weight.x * weight.y * textureLod(map, vec3((base + offset) / size, position.z), 0.0);
    }
    return taps > 0 ? lit / whole : 1.0;
}

vec3 shadowPosition(mat4 shadowFromWorld, vec3 world)
{
    return (shadowFromWorld * vec4(world, 1.0)).xyz;
}

// Rotation of the sample points on the sun's disk, radians. A few fixed points would appear as repeated copies of an
// edge. Rotation per pixel turns them into noise; rotation per supersample adds points.
float diskTurn = 0.0;

// Sets the rotation for a pixel of the whole picture: interleaved gradient noise (Jimenez 2014, "Next Generation Post
// Processing in Call of Duty: Advanced Warfare"), plus the golden ratio per supersample.
void turnDisk(vec2 pixel)
{
    float noise = fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
    diskTurn = 2.0 * PI * fract(noise + 0.618033989 * float(light.sampleIndex));
}

// Point i of n, uniformly distributed over the unit disk: a spiral with the golden angle (Vogel 1979, "A better way to
// construct the sunflower head").
vec2 diskPoint(float i, float n)
{
    float angle = 2.39996323 * i + diskTurn;
    return sqrt((i + 0.5) / n) * vec2(cos(angle), sin(angle));
}

// Share of the sun's disk that is visible from `world`. The width of a penumbra is the sun's apparent width times the
// distance to the occluder (Fernando 2005, "Percentage-Closer Soft Shadows"). That distance is found by shadow
// comparisons alone: if the point is still hidden after it has moved d meters towards the sun, the occluder is farther
// than d. All sample points lie in the plane of the surface, because others would be shadowed by the surface itself.
#if SHADOW_FILTER == SHADOW_FILTER_SUN_DISK
float shadowDiskLight(sampler2DShadow map, mat4 shadowFromWorld, vec3 world, vec3 normal, bool wanted)
{
    const float farthest = 16.0;  // meters: from the floor to the window
    float samples = float(light.sunDiskSamples);
    vec3 position = shadowPosition(shadowFromWorld, world);
    if (!wanted || !isInShadowMap(position)) return 1.0;
    float looks = clamp(0.75 * samples, 12.0, 64.0);
    mat3 rows = transpose(mat3(shadowFromWorld));
    vec3 perMeter = vec3(length(rows[0]), length(rows[1]), length(rows[2]));
    vec2 texel = 1.0 / vec2(textureSize(map, 0));
    // Change of depth along the surface, per texture coordinate.
    vec2 rise = -vec2(dot(normal, rows[0]), dot(normal, rows[1])) / (perMeter.xy * perMeter.xy) / max(dot(normal, light.sunDirection), 0.1) * perMeter.z;
    vec2 widest = max(perMeter.xy * (light.sunTanHalfWidth * farthest), texel);
    float hidden = 0.0;
    for (float i = 0.0; i < looks; i += 1.0) {
        vec2 offset = diskPoint(i, looks) * widest;
        hidden += 1.0 - textureLod(map, position + vec3(offset, dot(offset, rise)), 0.0);
    }
    if (hidden <= 0.0) return 1.0;
    if (hidden >= looks) return 0.0;

    // Mean distance of the occluders: the integral over d of the share that is farther than d. Each interval is sampled
    // at a random position.
    float mean = 0.0;
    float last = 0.0;
    float within = fract(diskTurn * (1.61803399 / (2.0 * PI)) + 0.5);
    for (float d = 0.25; d <= farthest; d = max(d + 0.25, 1.5 * d)) {
        float farther = 0.0;
        for (float i = 0.0; i < looks; i += 1.0) {
            vec2 offset = diskPoint(i, looks) * widest;
            vec3 at = position + vec3(offset, dot(offset, rise) + mix(last, d, within) * perMeter.z);
            farther += 1.0 - textureLod(map, at, 0.0);
        }
        mean += farther * (d - last);
        last = d;
    }
    vec2 radius = max(perMeter.xy * (light.sunTanHalfWidth * mean / hidden), 0.75 * texel);
    float lit = 0.0;
    for (float i = 0.0; i < samples; i += 1.0) {
        vec2 offset = diskPoint(i, samples) * radius;
        lit += textureLod(map, position + vec3(offset, dot(offset, rise)), 0.0);
    }
    return lit / samples;
}
#endif

// Offset of a point along its normal before the lookup, in texels: larger at grazing light.
float shadowLift(float cosine)
{
    return 0.6 + 2.4 * safeSqrt(1.0 - cosine * cosine);
}

float filteredShadow(sampler2DShadow map, mat4 shadowFromWorld, vec3 world, vec3 normal, bool wanted)
{
#if SHADOW_FILTER == SHADOW_FILTER_SUN_DISK
    return shadowDiskLight(map, shadowFromWorld, world, normal, wanted);
#elif SHADOW_FILTER == SHADOW_FILTER_HARD
    return wanted ? shadowMapLight(map, shadowPosition(shadowFromWorld, world)) : 1.0;
#else
    return shadowTentLight(map, shadowPosition(shadowFromWorld, world), wanted);
#endif
}

// Returns whether sunlight that reaches a point has crossed the room. That is decided by the ray towards the sun: points
// of the walls lie on the room's boundary, or in niches outside it.
bool isBehindRoom(vec3 world)
{
    vec2 span = rayBox(world, light.sunDirection, light.roomLow, light.roomHigh);
    return span.x < span.y;
}

// Returns whether sunlight can reach a point. It enters the room only through the passages.
bool mayBeSunlit(vec3 world)
{
    bool may = !isBehindRoom(world);
    vec2 at = shadowPosition(light.hallShadowFromWorld, world).xy;
    for (int i = 0; i < MOST_SUN_PASSAGES; ++i)
        may = may || (all(greaterThan(at, light.sunPassages[i].xy)) && all(lessThan(at, light.sunPassages[i].zw)));
    return may;
}

// Visibility of the sun past walls and furniture, 0 to 1; 0 if `normal` faces away.
float sunVisibilityOfHall(vec3 world, vec3 normal)
{
    float cosine = dot(normal, light.sunDirection);
    if (!light.hallCastsShadow) return cosine > 0.0 ? 1.0 : 0.0;
    bool may = cosine > 0.0 && mayBeSunlit(world);
    vec3 lifted = world + normal * (light.hallShadowTexel * shadowLift(cosine));
    float visible = filteredShadow(hallShadow, light.hallShadowFromWorld, lifted, normal, may);
    return may ? visible : 0.0;
}

// Visibility of the sun past the exhibits, where their map is valid; 1 if not `wanted`.
float sunVisibilityOfExhibits(vec3 world, vec3 normal, bool wanted)
{
    vec3 lifted = world + normal * (light.exhibitShadowTexel * shadowLift(dot(normal, light.sunDirection)));
    return filteredShadow(exhibitShadow, light.exhibitShadowFromWorld, lifted, normal, wanted);
}

// Visibility of the sun past hall and exhibits.
float sunVisibility(vec3 world, vec3 normal)
{
    float visible = sunVisibilityOfHall(world, normal);
    bool wanted = light.exhibitsCastShadow && visible > 0.0;
    float besideExhibits = sunVisibilityOfExhibits(world, normal, wanted);
    return wanted ? visible * besideExhibits : visible;
}

// Transmittance of glass between the point and the sun, per color. A point in front of the glass is not in its shadow.
// Beside the glass, the map holds white at the nearest depth.
vec3 sunThroughGlass(vec3 world)
{
#ifdef GLASS_SHADOWS
    vec3 at = shadowPosition(light.exhibitShadowFromWorld, world);
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return vec3(1.0);
    vec4 glass = textureLod(glassShadow, at.xy, 0.0);
    if (glass.a > at.z + 1e-4) return glass.rgb;
#endif
    return vec3(1.0);
}

// Corrects the direction of a probe lookup so that the walls of the probe's box appear at their positions. Lagarde and
// Zanuttini 2012, "Local Image-based Lighting With Parallax-corrected Cubemap".
vec3 parallaxCorrected(vec3 world, vec3 direction)
{
    if (light.probeHigh.x <= light.probeLow.x) return direction;
    vec3 safe = mix(direction, vec3(1e-5), lessThan(abs(direction), vec3(1e-5)));
    vec3 toHigh = (light.probeHigh - world) / safe;
    vec3 toLow = (light.probeLow - world) / safe;
    vec3 exits = max(toHigh, toLow);
    float t = min(exits.x, min(exits.y, exits.z));
    return t > 0.0 ? world + direction * t - light.probePosition : direction;
}

// Radiance of the probe from `direction`, blurred by `roughness` (perceptual, 0 to 1).
vec3 probeRadiance(vec3 world, vec3 direction, float roughness)
{
    if (!light.hasProbe) return mix(light.skyHorizon, light.skyZenith, 0.5 + 0.5 * direction.y) * 0.05;
    float level = light.probeLastLevel * sqrt(clamp(roughness, 0.0, 1.0));
    return textureLod(probe, parallaxCorrected(world, direction), level).rgb;
}

// Irradiance over pi from the probe's nine spherical-harmonic coefficients (already convolved with the
// cosine lobe; Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps").
vec3 probeAmbient(vec3 n)
{
    if (!light.hasProbe) return light.skyZenith * 0.05;
    vec3 sum = texelFetch(probeIrradiance, ivec2(0, 0), 0).rgb;
    sum += texelFetch(probeIrradiance, ivec2(1, 0), 0).rgb * n.y + texelFetch(probeIrradiance, ivec2(2, 0), 0).rgb * n.z +
           texelFetch(probeIrradiance, ivec2(3, 0), 0).rgb * n.x;
    sum += texelFetch(probeIrradiance, ivec2(4, 0), 0).rgb * (n.x * n.y) + texelFetch(probeIrradiance, ivec2(5, 0), 0).rgb * (n.y * n.z) +
           texelFetch(probeIrradiance, ivec2(6, 0), 0).rgb * (3.0 * n.z * n.z - 1.0) +
           texelFetch(probeIrradiance, ivec2(7, 0), 0).rgb * (n.x * n.z) +
           texelFetch(probeIrradiance, ivec2(8, 0), 0).rgb * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0));
}

// Irradiance over pi on a surface without lightmap, with normal `n`.
vec3 ambientAt(vec3 world, vec3 n)
{
    if (!light.hasAirLight) return probeAmbient(n);
    return airLightOf(airLight, light.airLow, light.airHigh, world, n).rgb;
}
