// Shading of a hit on the object: sun with the object's own shadow, the hall's light, reflections of the object in
// itself, glass.
#include "lib/surface.glsl"
#include "lib/hash.glsl"
#include "kit/sdf/shadow_method.glsl"
#include "kit/sdf/hit.glsl"
#ifdef GLASS
#include "kit/sdf/glass_path.glsl"
#endif
#ifdef BACKDROP
#include "kit/backdrop.glsl"
#endif

// Light towards the eye that the exhibit adds to the hall's: SdfShaders::shading.
vec3 exhibitLight(Surface s, Hit hit, vec3 toEye);

// Visibility of a light past the object, from a point (local) in the direction `toLight`, over tMin to tMax, by the
// method that the parameters choose.
float fieldVisibility(vec3 p, vec3 toLight, float tMin, float tMax)
{
    float width = tan(0.5 * parameters.sunWidth);
    uvec2 pixel = uvec2(framePixel(gl_FragCoord.xy));
    uint bits = pcg(pixel.x + 65536u * pixel.y + 747796405u * uint(frame.sampleIndex));
    Shadow s = shadowByMethod(p, toLight, width, tMin, tMax, parameters.stepLimit, parameters.shadowRays, 6.2831853 * unitFromBits(bits));
    evaluations += s.evaluations;
    return s.visibility;
}

// Visibility of a light in the direction `toLight` (local, unit length) past the object itself.
float selfVisibility(Hit hit, vec3 toLight)
{
    if (parameters.shadowMethod == shadowMethod_none) return 1.0;
    if (dot(hit.localNormal, toLight) <= 0.0) return 0.0;
    vec3 start = hit.local + hit.localNormal * (2.0 * hit.tolerance);
    return fieldVisibility(start, toLight, 0.004, rayBox(start, toLight, object.boxLow, object.boxHigh).y);
}

// Visibility of the sun past the other exhibits. It is looked up next to the corner of the object's box that is closest
// to the sun. There the object's own shadow does not reach, however wide the filter is. 1 if not `wanted`.
float othersVisibility(Hit hit, bool wanted)
{
#ifdef OTHERS_SHADOWS
    vec3 rise = transpose(mat3(object.worldFromLocal)) * light.sunDirection;
    vec3 corner = mix(object.boxLow, object.boxHigh, greaterThan(rise, vec3(0.0)));
    return sunVisibilityOfExhibits(hit.world + light.sunDirection * max(dot(corner - hit.local, rise), 0.0), light.sunDirection, wanted && light.exhibitsCastShadow);
#else
    return 1.0;
#endif
}

// Visibility of the sun: past walls and other objects, then past the object itself.
float sunReaches(Hit hit)
{
#ifdef SUNLESS
    return 0.0;
#else
    if (dot(hit.worldNormal, light.sunDirection) <= 0.0 || dot(light.sunIrradiance, vec3(1.0)) <= 0.0) return 0.0;
    float visible = sunVisibilityOfHall(hit.world, hit.worldNormal);
    visible *= othersVisibility(hit, visible > 0.0);
    return visible > 0.0 ? visible * selfVisibility(hit, normalize(mat3(object.localFromWorld) * light.sunDirection)) : 0.0;
#endif
}

// Returns the surface without ambient light and occlusion.
Surface bareSurface(Hit hit, FieldMaterial material)
{
    Surface s;
    s.position = hit.world;
    s.normal = hit.worldNormal;
    s.baseColor = material.baseColor;
    s.metalness = material.metalness;
    s.roughness = max(material.roughness, 0.02);
    s.specular = material.specular;
    s.occlusion = 1.0;
    s.ambient = vec3(0.0);
    return s;
}

// An exhibit's field or material may define two macros. FIELD_BUMP(p, n, pixel) is the normal for shading at a point with
// the unit normal `n`, local; `pixel` is the width of a pixel there. FIELD_AMBIENT(n) is the share of the room's light
// that reaches a surface with this normal, local.
Surface surfaceOf(Hit hit, FieldMaterial material)
{
    Surface s = bareSurface(hit, material);
#ifdef FIELD_BUMP
    s.normal = worldNormalOf(FIELD_BUMP(hit.local, hit.localNormal, frame.pixelAngle * hit.traveled));
#endif
    if (parameters.ambientOcclusion) {
        s.occlusion = fieldOcclusion(hit.local, hit.localNormal, 0.25 * length(object.boxHigh - object.boxLow));
        evaluations += 5;
    }
#ifdef FIELD_AMBIENT
    s.occlusion *= FIELD_AMBIENT(hit.localNormal);
#endif
    s.ambient = ambientAt(s.position, s.normal) * s.occlusion;
    return s;
}

// Iterative reflection: each bounce adds the light of its surface, weakened by all surfaces before it. A ray that
// leaves the object sees the hall.
vec3 shadeOpaque(vec3 toEye, Hit hit, MarchSettings settings)
{
    vec3 color = vec3(0.0);
    vec3 throughput = vec3(1.0);
#ifdef BOUNCES
    const int most = 4;
#else
    const int most = 0;  // The code for a second surface is compiled out.
#endif
    for (int bounce = 0; bounce <= most; ++bounce) {
        Surface s = surfaceOf(hit, fieldMaterial(hit.local));
        color += throughput * (shadeWithoutReflection(s, toEye, sunReaches(hit)) + exhibitLight(s, hit, toEye));
        throughput *= reflectance(s, toEye);
        vec3 mirrored = reflect(-toEye, s.normal);
        bool last = bounce >= parameters.bounces || max(throughput.r, max(throughput.g, throughput.b)) < 0.004;
        March march;
        march.hit = false;
        vec3 start = hit.local + hit.localNormal * (2.0 * hit.tolerance);
        vec3 direction = normalize(mat3(object.localFromWorld) * mirrored);
#ifdef BOUNCES
        if (!last) march = onward(start, direction, 1.0, settings, hit.traveled);
#endif
        if (!march.hit) {
            // Without a further bounce, self-occlusion only darkens the reflection.
            float open = last ? mix(1.0, s.occlusion, 0.7) : 1.0;
            return color + throughput * probeRadiance(hit.world, mirrored, s.roughness) * open;
        }
        MarchSettings next = settings;
        next.traveled = hit.traveled;
        hit = findHit(start, direction, march, next);
        toEye = -mirrored;
    }
    return color;
}

#ifdef GLASS
// Radiance along a ray that has left the glass. The blur of rough glass grows with the index, up to its full roughness
// at 1.5 (Khronos, KHR_materials_transmission, "Refraction").
vec3 seenThrough(vec3 world, vec3 direction, float roughness, float index)
{
    float spread = roughness * clamp(2.0 * index - 2.0, 0.0, 1.0);
#ifdef BACKDROP
    return backdropRadiance(world, direction, spread, spread * spread);
#else
    return probeRadiance(world, direction, spread);
#endif
}

// Highlight of the sun with exact Fresnel reflectance instead of Schlick's, which reflects even for an index of 1.
vec3 sunOnGlass(Surface s, vec3 toEye, float index, float visibility)
{
    vec3 halfway = safeNormalize(light.sunDirection + toEye, s.normal);
    float cosine = clamp(dot(toEye, halfway), 0.0, 1.0);
    float share = fresnelDielectric(cosine, index) / fresnelSchlick(vec3(0.04), cosine).r;
    // Glass does not lie in its own shadow.
    return lightReflected(s, toEye, light.sunDirection, light.sunIrradiance * visibility) * share;
}

// Light through every wall, in and out. Fresnel splits off a reflection at the first wall; the rest goes on. Beer's law
// colors it; the material is that of the first surface.
vec3 shadeGlass(vec3 toEye, Hit hit, MarchSettings settings)
{
    FieldMaterial material = fieldMaterial(hit.local);
    float index = max(material.refractiveIndex, 1.0);
    Surface s = surfaceOf(hit, material);
    s.metalness = 0.0;
    s.baseColor = vec3(0.0);
    float mirror = fresnelDielectric(clamp(dot(s.normal, toEye), 0.0, 1.0), index);
    vec3 color = mirror * probeRadiance(hit.world, reflect(-toEye, s.normal), s.roughness) +
                 sunOnGlass(s, toEye, index, sunReaches(hit));
    GlassPath path = throughGlass(-toEye, hit, settings);
    return color + path.throughput * seenThrough(path.world, path.direction, s.roughness, index);
}
#endif

vec3 shadeFound(LocalRay ray, Hit hit, MarchSettings settings)
{
    vec3 toEye = -worldDirection(ray.direction);
#ifdef GLASS
    return shadeGlass(toEye, hit, settings);
#else
    return shadeOpaque(toEye, hit, settings);
#endif
}
