// All bodies at once, for what looks from one to another: mirrored by FurBodies in exhibits/fur/coat.h.
#include "fur/body.glsl"

const int FUR_BODIES = 3;

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBody body[FUR_BODIES];
    mat4 worldFromPit;
    mat4 pitFromWorld;
    vec4 pit;  // x: radius, y: height of the rim above the floor, metres; z: 1 when a floor must be drawn
};

// Nearest point to `p` of the line that a body is thick around: a point, a straight line, or a ring.
vec3 spinePoint(FurBody b, vec3 p)
{
    if (b.spine.y > 0.0) {
        vec3 flat_ = vec3(p.x, 0.0, p.z);
        return safeNormalize(flat_, vec3(1.0, 0.0, 0.0)) * (b.spine.y * b.pull.w);
    }
    return vec3(clamp(p.x, -b.spine.x, b.spine.x) * 1.0, 0.0, 0.0);
}

// Share of the sky over a surface that a body leaves: the cosine-weighted solid angle of a sphere, for
// spheres above the horizon (Quilez 2006, "Sphere ambient occlusion"), around the nearest point of the spine.
float openSky(FurBody b, vec3 world, vec3 normal)
{
    vec3 p = (b.bodyFromWorld * vec4(world, 1.0)).xyz;
    vec3 center = (b.worldFromBody * vec4(spinePoint(b, p), 1.0)).xyz;
    float radius = b.spine.z * b.pull.w + 0.6 * b.coat.x;
    vec3 d = center - world;
    float distance_ = max(length(d), radius * 1.001);
    float cosine = clamp(0.5 + 0.5 * dot(normal, d) / max(length(d), 1e-5), 0.0, 1.0);
    float share = radius * radius / (distance_ * distance_);
    return 1.0 - cosine * cosine * share;
}

// The lamp in the vault above the pit: unit vector towards it, and its irradiance on what faces it.
vec3 lampDirection()
{
    return normalize(mat3(worldFromPit) * parameters.lampDirection);
}

vec3 lampLight()
{
    return vec3(1.0, 0.86, 0.68) * parameters.lamp;
}

// Share of the lamp that reaches a point past all bodies but `own` (-1: past all): their spines' nearest
// approach to the ray, found by going back and forth, against their thickness.
float lampShadow(vec3 world, int own)
{
    vec3 l = lampDirection();
    float visible = 1.0;
    for (int i = 0; i < FUR_BODIES; ++i) {
        if (i == own) continue;
        vec3 p = (body[i].bodyFromWorld * vec4(world, 1.0)).xyz;
        vec3 d = mat3(body[i].bodyFromWorld) * l;
        float t = max(-dot(p, d), 0.0);
        vec3 nearest = vec3(0.0);
        for (int k = 0; k < 4; ++k) {
            nearest = spinePoint(body[i], p + d * t);
            t = max(dot(nearest - p, d), 0.0);
        }
        float away = length(p + d * t - nearest);
        float radius = body[i].spine.z * body[i].pull.w;
        // A fringe half as wide as the fur is long lets light through; the lamp is no point either.
        float soft = 0.5 * body[i].coat.x + 0.06 * t + 0.01;
        visible *= smoothStep(radius + 0.3 * body[i].coat.x - soft, radius + 0.5 * body[i].coat.x + soft, away);
    }
    return visible;
}
