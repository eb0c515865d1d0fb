// Refracted path of light through a glass body.
#include "lib/numerics.glsl"
#include "kit/sdf/hit.glsl"

struct GlassPath {
    vec3 world;       // where it leaves the glass
    vec3 direction;   // direction there, unit length
    vec3 throughput;  // remaining share of the light
};

// Follows the ray in and out through every wall, up to the `bounces` of the parameters. Reflections are ignored.
GlassPath throughGlass(vec3 direction, Hit hit, MarchSettings settings)
{
    FieldMaterial material = fieldMaterial(hit.local);
    float index = max(material.refractiveIndex, 1.0);
    vec3 absorption = -log(clamp(material.baseColor, 0.02, 1.0)) / 0.1;
    // A march that ends before a grazing surface may find a normal on the wrong side, which would reflect the ray.
    vec3 facing = faceforward(hit.worldNormal, direction, hit.worldNormal);
    float cosine = clamp(-dot(facing, direction), 0.0, 1.0);
    GlassPath path = GlassPath(hit.world, refract(direction, facing, 1.0 / index), vec3(1.0 - fresnelDielectric(cosine, index)));
    vec3 local = hit.local;
    float side = -1.0;
    int interfaces = 2 + 2 * parameters.bounces;
    for (int i = 0; i < 10 && i < interfaces; ++i) {
        vec3 localDirection = normalize(mat3(object.localFromWorld) * path.direction);
        // Start off the surface, on the side that the ray travels on.
        vec3 start = hit.local - hit.localNormal * (2.0 * hit.tolerance);
        March march = onward(start, localDirection, side, settings, hit.traveled);
        if (!march.hit) break;
        if (side < 0.0) path.throughput *= exp(-absorption * march.t * length(mat3(object.worldFromLocal) * localDirection));
        MarchSettings next = settings;
        next.traveled = hit.traveled;
        hit = findHit(start, localDirection, march, next);
        // The path continues from the hit itself: the offset of the march's start would shift the picture.
        local += localDirection * dot(hit.local - local, localDirection);
        float eta = side < 0.0 ? index : 1.0 / index;
        facing = faceforward(hit.worldNormal, path.direction, hit.worldNormal);
        vec3 through = refract(path.direction, facing, eta);
        // refract() returns the zero vector on total reflection; reflect instead of normalizing it to NaN.
        if (dot(through, through) < 0.5) {
            path.direction = reflect(path.direction, facing);
            hit.localNormal = -hit.localNormal;
            continue;
        }
        path.throughput *= 1.0 - fresnelDielectric(min(-dot(path.direction, facing), 1.0), 1.0 / eta);
        path.direction = through;
        side = -side;
    }
    path.world = (object.worldFromLocal * vec4(local, 1.0)).xyz;
    return path;
}
