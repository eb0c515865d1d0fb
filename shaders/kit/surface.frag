// Shades a mesh with a material. Permutations: those of kit/material.glsl, NORMAL_MAP, ORM_MAP, OCCLUSION_MAP, SURFACE_MAP
// (roughness and occlusion, with NORMAL_MAP the normal, too, from Material::surfaceMap in place of their own maps),
// ALPHA_MASK, BLENDED (opacity in alpha), LIGHTMAP, BOUNCED_LIGHT (of the sun, with LIGHTMAP), LAMP_LIGHT (of the
// vault, with LIGHTMAP), UNLIT (some objects are), FLAT_PROBE (for the probe's own capture: no reflections), WRITE_NORMAL,
// WRITE_EVALUATIONS, WRITE_ALBEDO,
// POLISHED_FLOOR with those of kit/polished_floor.glsl, and those of kit/stored_surface.glsl: STORE_SURFACE draws the
// mesh without light, LIGHT_STORED then adds the light of each pixel once.
#include "lib/frame.glsl"
#include "lib/surface.glsl"
#include "kit/stored_surface.glsl"
#ifndef LIGHT_STORED
#include "kit/surface_object.glsl"
#include "kit/material.glsl"
#endif
#ifdef POLISHED_FLOOR
#include "kit/polished_floor.glsl"
#endif

layout(binding = UNIT_SKY_LIGHTMAP) uniform sampler2D skyLightmap;
layout(binding = UNIT_BOUNCED_LIGHT) uniform sampler2D bouncedLight;

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

#ifndef LIGHT_STORED
layout(binding = UNIT_NORMAL) uniform sampler2D normalMap;
layout(binding = UNIT_ORM) uniform sampler2D ormMap;
layout(binding = UNIT_OCCLUSION) uniform sampler2D occlusionMap;

in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec2 tileUv;
in vec2 atlasUv;
#if defined(LIGHTMAP) || defined(POLISHED_FLOOR)
in vec3 roomAmbient;
#endif

// The surface of the mesh at this fragment. Sets base color with opacity, and emitted radiance.
StoredSurface drawnSurface(out vec4 base, out vec3 emitted)
{
    // Levels of detail are undefined after a discard, and in a branch that not all pixels of a quad take.
    base = materialColor(tileUv);
    emitted = materialEmission(tileUv);
#ifdef SURFACE_MAP
    vec4 surface = texture(normalMap, tileUv);
    vec3 orm = vec3(surface.ab, 1.0);
    vec3 m = vec3(surface.rg * 2.0 - 1.0, 1.0);
    m.z = safeSqrt(1.0 - dot(m.xy, m.xy));
#else
#ifdef NORMAL_MAP
    vec3 m = texture(normalMap, tileUv).xyz * 2.0 - 1.0;
#endif
#ifdef ORM_MAP
    vec3 orm = texture(ormMap, mapUv(mapRoughness, tileUv)).rgb;
#endif
#endif
#ifdef OCCLUSION_MAP
    float ownOcclusion = texture(occlusionMap, mapUv(mapOcclusion, tileUv)).r;
#endif
#ifdef ALPHA_MASK
    if (base.a < object.alphaCutoff) discard;
#endif

    vec3 toEye = normalize(frame.eye - worldPosition);
    vec3 n = safeNormalize(worldNormal, toEye);  // A user's file may contain normals of length 0.
    if (!gl_FrontFacing) n = -n;
#ifdef NORMAL_MAP
    vec3 t = worldTangent.xyz - n * dot(n, worldTangent.xyz);
    if (dot(t, t) > 1e-8) {
        t = normalize(t);
        vec3 b = cross(n, t) * worldTangent.w;
        n = normalize(t * (m.x * object.normalScale) + b * (m.y * object.normalScale) + n * max(m.z, 0.05));
    }
#endif
    Surface s;
    s.position = worldPosition;
    s.normal = n;
    s.baseColor = base.rgb;
    s.metalness = object.metalness;
    s.roughness = object.roughness;
    s.specular = object.specular;
    s.ambient = vec3(0.0);
    s.occlusion = 1.0;
#if defined(ORM_MAP) || defined(SURFACE_MAP)
    s.occlusion = mix(1.0, orm.r, object.occlusionStrength);
    s.roughness *= orm.g;
    s.metalness *= orm.b;
#endif
#ifdef OCCLUSION_MAP
    s.occlusion *= mix(1.0, ownOcclusion, object.ownOcclusionStrength);
#endif
    s.roughness = clamp(s.roughness, 0.045, 1.0);
    StoredSurface stored = StoredSurface(s, atlasUv, 0.0);
#ifdef LIGHTMAP
    stored.roomAmbient = dot(roomAmbient, vec3(0.3333));
#endif
    return stored;
}
#endif

// Ambient light of the lightmaps at `at`.
vec3 bakedAmbient(vec2 at)
{
    vec4 root = textureLod(skyLightmap, at, 0.0);  // Stored as square roots.
    vec3 ambient = root.rgb * root.rgb * light.skyLightmapScale * mix(light.skyHorizon, light.skyZenith, 0.4);
#ifdef LAMP_LIGHT
    ambient += root.a * root.a * light.lampsOnWalls;
#endif
#ifdef BOUNCED_LIGHT
    ambient += textureLod(bouncedLight, at, 0.0).rgb * light.sunIrradiance;
#endif
    return ambient;
}

// Radiance of the surface towards the eye, without what it emits.
vec3 lit(StoredSurface stored)
{
    Surface s = stored.surface;
    vec3 toEye = normalize(frame.eye - s.position);
#ifdef LIGHTMAP
    s.ambient = bakedAmbient(stored.atlasUv);
    // The probe represents the whole room. Where the baked light is far below the room's mean, the reflection is
    // darkened, too.
    float local = dot(s.ambient, vec3(0.3333)) / max(stored.roomAmbient, 1e-4);
    s.occlusion *= mix(1.0, clamp(local, 0.15, 1.0), light.bakedOcclusion * (0.35 + 0.65 * s.roughness));
#else
    s.ambient = ambientAt(s.position, s.normal) * s.occlusion;
#endif
#ifdef CONTACT_SHADOWS
    float contact = contactLight(s.position);
    s.ambient *= contact;
    s.occlusion *= contact;
#endif
#ifdef FLAT_PROBE
    vec3 color = s.baseColor * s.ambient + sunReflected(s, toEye, sunVisibility(s.position, s.normal));
#ifdef LOCAL_LIGHTS
    color += localLightsReflected(s, toEye);
#endif
    return color;
#elif defined(POLISHED_FLOOR)
    return shadeFloor(s, toEye, roomAmbient);
#else
    return shadeSurface(s, toEye);
#endif
}

// Half floats end at 65504, and infinity would become NaN in every average. The sum of the two steps of deferred shading
// is below that, too.
#if defined(STORE_SURFACE) || defined(LIGHT_STORED)
const vec3 brightest = vec3(3e4);
#else
const vec3 brightest = vec3(6e4);
#endif

#ifdef LIGHT_STORED
void main()
{
    StoredSurface stored = storedSurface();
    if (stored.surface.roughness <= 0.0) discard;
    turnDisk(framePixel(gl_FragCoord.xy));
    radiance = vec4(min(lit(stored), brightest), 0.0);
}
#else
void main()
{
    vec4 base;
    vec3 color;
    StoredSurface stored = drawnSurface(base, color);
#ifdef STORE_SURFACE
    storeSurface(stored);
#else
    turnDisk(framePixel(gl_FragCoord.xy));
    color += lit(stored);
#ifdef UNLIT
    if (object.unlit) color = base.rgb;
#endif
#endif
#ifdef BLENDED
    float opacity = base.a;
#else
    float opacity = 1.0;
#endif
    radiance = vec4(min(color, brightest), opacity);
#ifdef WRITE_NORMAL
    normalOut = vec4(stored.surface.normal, 1.0);
#endif
#ifdef WRITE_EVALUATIONS
    evaluationsOut = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(base.rgb, 1.0) * opacity;
#endif
}
#endif
