// What a ray that hit the object sees there: sun with the object's own shadow, the hall's light, mirror
// images of the object in itself, glass.
#include "lib/surface.glsl"
#include "lib/hash.glsl"
#include "kit/sdf/shadow_method.glsl"

int evaluations;  // Calls of fieldDistance for this pixel.

struct Hit {
    vec3 local;        // on the surface, in the object's own space
    vec3 localNormal;  // facing the ray
    vec3 world;
    vec3 worldNormal;
    float tolerance;   // local
    float traveled;   // local length of the path so far
};

// Light that the exhibit adds to the hall's, towards the eye: SdfShaders::shading.
vec3 exhibitLight(Surface s, Hit hit, vec3 toEye);

vec3 worldDirection(vec3 local)
{
    return normalize(mat3(object.worldFromLocal) * local);
}

Hit findHit(vec3 origin, vec3 direction, March march, MarchSettings settings)
{
    Hit hit;
    hit.local = origin + direction * march.t;
    hit.tolerance = hitTolerance(march.t, settings);
    hit.traveled = settings.traveled + march.t;
    int part = fieldPart;
    float step_ = max(parameters.normalStep, 0.25 * settings.pixelCone * hit.traveled);
    vec3 n = fieldNormal(hit.local, step_, parameters.normalMethod, -direction * march.side);
    fieldPart = part;
    evaluations += parameters.normalMethod == NORMAL_CENTRAL ? 6 : 4;
    // A ray inside the solid meets the surface from behind.
    hit.localNormal = n * march.side;
    hit.world = (object.worldFromLocal * vec4(hit.local, 1.0)).xyz;
    hit.worldNormal = worldNormalOf(hit.localNormal);
    return hit;
}

// Share of a light that the object leaves at a point (local) in the direction `toLight`, from tMin to tMax along the way, by
// the table's method.
float fieldVisibility(vec3 p, vec3 toLight, float tMin, float tMax)
{
    float width = tan(0.5 * parameters.sunWidth);
    uvec2 pixel = uvec2(framePixel(gl_FragCoord.xy));
    uint bits = pcg(pixel.x + 65536u * pixel.y + 747796405u * uint(frame.sampleIndex));
    Shadow s = shadowByMethod(p, toLight, width, tMin, tMax, parameters.stepLimit, parameters.shadowRays, 6.2831853 * unitFromBits(bits));
    evaluations += s.evaluations;
    return s.visibility;
}

// Share of a light in the direction `toLight` (local, unit length) that the object leaves itself.
float selfVisibility(Hit hit, vec3 toLight)
{
    if (parameters.shadowMethod == shadowMethod_none) return 1.0;
    if (dot(hit.localNormal, toLight) <= 0.0) return 0.0;
    vec3 start = hit.local + hit.localNormal * (2.0 * hit.tolerance);
    return fieldVisibility(start, toLight, 0.004, rayBox(start, toLight, object.boxLow, object.boxHigh).y);
}

// Share of the sun that the other exhibits leave: looked up beside the nearest corner of the object's box to the sun,
// where nothing of its own shadow lies, however wide the filter looks around.
float othersVisibility(Hit hit)
{
#ifdef OTHERS_SHADOWS
    if (!light.exhibitsCastShadow) return 1.0;
    vec3 rise = transpose(mat3(object.worldFromLocal)) * light.sunDirection;
    vec3 corner = mix(object.boxLow, object.boxHigh, greaterThan(rise, vec3(0.0)));
    return sunVisibilityOfExhibits(hit.world + light.sunDirection * max(dot(corner - hit.local, rise), 0.0), light.sunDirection);
#else
    return 1.0;
#endif
}

// Walls and what else stands in the sun's way, then the object itself.
float sunReaches(Hit hit)
{
    if (dot(hit.worldNormal, light.sunDirection) <= 0.0 || dot(light.sunIrradiance, vec3(1.0)) <= 0.0) return 0.0;
    float visible = sunVisibilityOfHall(hit.world, hit.worldNormal);
    if (visible > 0.0) visible *= othersVisibility(hit);
    return visible > 0.0 ? visible * selfVisibility(hit, normalize(mat3(object.localFromWorld) * light.sunDirection)) : 0.0;
}

// In no light from around it, with nothing near it.
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

Surface surfaceOf(Hit hit, FieldMaterial material)
{
    Surface s = bareSurface(hit, material);
    if (parameters.ambientOcclusion) {
        s.occlusion = fieldOcclusion(hit.local, hit.localNormal, 0.25 * length(object.boxHigh - object.boxLow));
        evaluations += 5;
    }
    s.ambient = ambientAt(s.position, s.normal) * s.occlusion;
    return s;
}

// The next surface along a ray that starts on a surface. `side`: 1 outside the solid, -1 inside.
March onward(vec3 start, vec3 direction, float side, MarchSettings settings, float traveled)
{
    float tMax = rayBox(start, direction, object.boxLow, object.boxHigh).y;
    MarchSettings s = settings;
    s.tMin = 0.0;
    s.tMax = tMax;
    s.traveled = traveled;
    s.side = side;
    March march = sphereTrace(start, direction, s);
    evaluations += march.evaluations;
    return march;
}

// Recursive reflection without recursion: each bounce adds what its surface sends, weakened by all
// surfaces before it; a ray that leaves the object sees the hall.
vec3 shadeOpaque(vec3 toEye, Hit hit, MarchSettings settings)
{
    vec3 color = vec3(0.0);
    vec3 throughput = vec3(1.0);
#ifdef BOUNCES
    const int most = 4;
#else
    const int most = 0;  // Nothing of a second surface is compiled.
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
            // With no bounce left to find it, what the object hides from itself is only darkened.
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

// Through every wall, in and out: Fresnel splits off a mirror image at the first, the rest goes on.
// Beer's law colors it, and the material is that of the first surface.
vec3 shadeGlass(vec3 toEye, Hit hit, MarchSettings settings)
{
    FieldMaterial material = fieldMaterial(hit.local);
    float index = max(material.refractiveIndex, 1.0);
    Surface s = surfaceOf(hit, material);
    s.metalness = 0.0;
    float cosine = clamp(dot(s.normal, toEye), 0.0, 1.0);
    float mirror = fresnelDielectric(cosine, index);
    vec3 mirrored = reflect(-toEye, s.normal);
    s.baseColor = vec3(0.0);
    vec3 color = mirror * probeRadiance(hit.world, mirrored, s.roughness) + sunReflected(s, toEye, sunReaches(hit));
    vec3 throughput = vec3(1.0 - mirror);

    vec3 absorption = -log(clamp(material.baseColor, 0.02, 1.0)) / 0.1;
    vec3 direction = refract(-toEye, s.normal, 1.0 / index);
    float side = -1.0;
    int interfaces = 2 + 2 * parameters.bounces;
    for (int i = 0; i < 10 && i < interfaces; ++i) {
        vec3 localDirection = normalize(mat3(object.localFromWorld) * direction);
        // Off the surface, to the side that the ray travels on.
        vec3 start = hit.local - hit.localNormal * (2.0 * hit.tolerance);
        March march = onward(start, localDirection, side, settings, hit.traveled);
        if (!march.hit) break;
        if (side < 0.0) throughput *= exp(-absorption * march.t * length(mat3(object.worldFromLocal) * localDirection));
        MarchSettings next = settings;
        next.traveled = hit.traveled;
        hit = findHit(start, localDirection, march, next);
        float eta = side < 0.0 ? index : 1.0 / index;
        vec3 through = refract(direction, hit.worldNormal, eta);
        // refract() returns the zero vector on total reflection; reflect instead of normalizing it to NaN.
        if (dot(through, through) < 0.5) {
            direction = reflect(direction, hit.worldNormal);
            hit.localNormal = -hit.localNormal;
            continue;
        }
        throughput *= 1.0 - fresnelDielectric(min(abs(dot(direction, hit.worldNormal)), 1.0), 1.0 / eta);
        direction = through;
        side = -side;
    }
    return color + throughput * probeRadiance(hit.world, direction, s.roughness);
}

vec3 shadeFound(LocalRay ray, Hit hit, MarchSettings settings)
{
    vec3 toEye = -worldDirection(ray.direction);
#ifdef GLASS
    return shadeGlass(toEye, hit, settings);
#else
    return shadeOpaque(toEye, hit, settings);
#endif
}
