// All bodies at once, for what looks from one to another: mirrored by FurBodies in exhibits/fur/coat.h.
#include "fur/body.glsl"

const int FUR_BODIES = 3;

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBody body[FUR_BODIES];
    mat4 worldFromPit;
    mat4 pitFromWorld;
    vec4 pit;  // x: radius, y: height of the rim above the floor, metres
    vec4 middle;    // of the box that body 0 fills with its fur, body space
    vec4 halfSize;
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

// What one body leaves of the light at a point: of the sky over a surface with unit `normal`, and of a lamp
// towards unit `l`. Both from spheres on its spine: for the sky the nearest one, by the cosine-weighted solid
// angle it takes (Quilez 2006, "Sphere ambient occlusion"); for the lamp the one its ray passes nearest.
vec2 openTo(FurBody b, vec3 world, vec3 normal, vec3 l)
{
    vec3 p = (b.bodyFromWorld * vec4(world, 1.0)).xyz;
    vec3 n = mat3(b.bodyFromWorld) * normal;
    vec3 d = mat3(b.bodyFromWorld) * l;
    float skin = b.spine.z * b.pull.w;
    vec3 nearest = spinePoint(b, p);
    vec3 to = nearest - p;
    float apart = max(length(to), 1e-5);
    float radius = skin + 0.6 * b.coat.x;
    float cosine = clamp(0.5 + 0.5 * dot(n, to) / apart, 0.0, 1.0);
    float share = min(radius * radius / (apart * apart), 1.0);
    float t = max(dot(to, d), 0.0);
    for (int k = 0; k < 2; ++k) {
        nearest = spinePoint(b, p + d * t);
        t = max(dot(nearest - p, d), 0.0);
    }
    float away = length(p + d * t - nearest);
    // A fringe half as wide as the fur is long lets light through; the lamp is no point either.
    float soft = 0.5 * b.coat.x + 0.06 * t + 0.01;
    return vec2(1.0 - cosine * cosine * share, smoothStep(skin + 0.3 * b.coat.x - soft, skin + 0.5 * b.coat.x + soft, away));
}

// Unit vector towards the lamp in the vault above the pit, and its irradiance on what faces it.
vec3 lampDirection()
{
    return normalize(mat3(worldFromPit) * parameters.lampDirection);
}

vec3 lampLight()
{
    return vec3(1.0, 0.86, 0.68) * parameters.lamp;
}
