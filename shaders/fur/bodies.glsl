// Data of all bodies, for occlusion of one by another.
#include "fur/body.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBodies fur;
};

// Point nearest to `p` on the spine of a body: a point, a straight line, or a ring.
vec3 spinePoint(FurBody b, vec3 p)
{
    if (b.ringRadius > 0.0) {
        vec3 flat_ = vec3(p.x, 0.0, p.z);
        return safeNormalize(flat_, vec3(1.0, 0.0, 0.0)) * (b.ringRadius * b.skinScale);
    }
    return vec3(clamp(p.x, -b.halfLength, b.halfLength), 0.0, 0.0);
}

// Unoccluded share of light at a point past one body. x: of the sky over a surface with unit `normal`; y: of a lamp in
// unit direction `l`. Both use spheres on the body's spine. For the sky it is the nearest one, by its cosine-weighted
// solid angle (Quilez 2006, "Sphere ambient occlusion"); for the lamp the one that its ray passes closest.
vec2 openTo(FurBody b, vec3 world, vec3 normal, vec3 l)
{
    vec3 p = (b.bodyFromWorld * vec4(world, 1.0)).xyz;
    vec3 n = mat3(b.bodyFromWorld) * normal;
    vec3 d = mat3(b.bodyFromWorld) * l;
    float skin = b.radius * b.skinScale;
    vec3 nearest = spinePoint(b, p);
    vec3 to = nearest - p;
    float apart = max(length(to), 1e-5);
    float radius = skin + 0.6 * b.strandLength;
    float cosine = clamp(0.5 + 0.5 * dot(n, to) / apart, 0.0, 1.0);
    float share = min(radius * radius / (apart * apart), 1.0);
    float t = max(dot(to, d), 0.0);
    for (int k = 0; k < 2; ++k) {
        nearest = spinePoint(b, p + d * t);
        t = max(dot(nearest - p, d), 0.0);
    }
    float away = length(p + d * t - nearest);
    // A fringe half as wide as the fur is long lets light through; the lamp is not a point either.
    float soft = 0.5 * b.strandLength + 0.06 * t + 0.01;
    return vec2(1.0 - cosine * cosine * share, smoothStep(skin + 0.3 * b.strandLength - soft, skin + 0.5 * b.strandLength + soft, away));
}

// Unit vector towards the lamp in the vault above the pit, and its irradiance on a plane that faces it.
vec3 lampDirection()
{
    return normalize(mat3(fur.worldFromPit) * parameters.lampDirection);
}

vec3 lampLight()
{
    return vec3(1.0, 0.86, 0.68) * parameters.lamp;
}

// Share of the hall in the background of a point along unit `d`, 0 to 1; the rest is wall and floor of the pit. All in
// the pit's space; its padded edge is not sharp.
float hallBehind(vec3 p, vec3 d)
{
    float inside = fur.pitRadius * fur.pitRadius - dot(p.xz, p.xz);
    if (inside <= 0.0) return 1.0;
    float a = max(dot(d.xz, d.xz), 1e-6);
    float b = dot(p.xz, d.xz);
    float toWall = (sqrt(b * b + a * inside) - b) / a;
    return smoothStep(fur.pitRim, fur.pitRim + 0.3, p.y + d.y * toWall);
}
