// The way of light through the body where it is glass.
#include "lib/numerics.glsl"
#include "kit/sdf/hit.glsl"

struct GlassPath {
    vec3 world;       // where it leaves the glass
    vec3 direction;   // how, unit length
    vec3 throughput;  // what is left of it
};

// In and out through every wall, as many as the table's bounces allow, without what each mirrors.
GlassPath throughGlass(vec3 direction, Hit hit, MarchSettings settings)
{
    FieldMaterial material = fieldMaterial(hit.local);
    float index = max(material.refractiveIndex, 1.0);
    vec3 absorption = -log(clamp(material.baseColor, 0.02, 1.0)) / 0.1;
    // A march that ends before a grazing surface may find a normal that faces away: it would mirror the ray.
    vec3 facing = faceforward(hit.worldNormal, direction, hit.worldNormal);
    float cosine = clamp(-dot(facing, direction), 0.0, 1.0);
    GlassPath path = GlassPath(hit.world, refract(direction, facing, 1.0 / index), vec3(1.0 - fresnelDielectric(cosine, index)));
    vec3 local = hit.local;
    float side = -1.0;
    int interfaces = 2 + 2 * parameters.bounces;
    for (int i = 0; i < 10 && i < interfaces; ++i) {
        vec3 localDirection = normalize(mat3(object.localFromWorld) * path.direction);
        // Off the surface, to the side that the ray travels on.
        vec3 start = hit.local - hit.localNormal * (2.0 * hit.tolerance);
        March march = onward(start, localDirection, side, settings, hit.traveled);
        if (!march.hit) break;
        if (side < 0.0) path.throughput *= exp(-absorption * march.t * length(mat3(object.worldFromLocal) * localDirection));
        MarchSettings next = settings;
        next.traveled = hit.traveled;
        hit = findHit(start, localDirection, march, next);
        // The way goes on from where it met the surface: what the march began beside it would shift the picture.
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
