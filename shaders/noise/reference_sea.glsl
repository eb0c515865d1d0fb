// Sea of the reference: octaves of folded value noise, each rotated and of twice the frequency, in 100 steps; foam of
// sixteen more octaves; a sky of one color.

float referenceOctaves(vec3 p, int count)
{
    float f = 0.0;
    for (int i = 0; i < count; ++i) {
        p = (vec3(p.y, p.z, p.x) + vec3(p.z, -p.y, p.x)) * 0.70710678;
        float n = 0.5 + 0.5 * noiseNear(NOISE_VALUE, p, ivec3(0), vec3(0.0), ivec3(0), uint(parameters.seed)).value;
        f = 2.0 * f + 2.0 * abs(n - 0.5);
        p *= 2.0;
        evaluations += 1.0;
    }
    return f / exp2(float(count));
}

float referenceHeight(vec2 p, int count)
{
    float t = work.time * 0.3;
    return 0.5 - referenceOctaves(vec3(p.x, 0.0, p.y) * 0.2 + t * vec3(0.0, 0.1, 0.1), count);
}

PortalSeen referenceSea(PortalRay ray)
{
    PortalSeen seen = nothingSeen();
    vec3 origin = ray.origin + vec3(0.0, 1.0, 0.0);
    vec3 d = ray.direction;
    vec3 sky = vec3(0.7, 0.87, 0.98);
    float t = 0.1;
    bool hit = false;
    for (int i = 0; i < parameters.stepLimit && t < 200.0; ++i) {
        vec3 p = origin + d * t;
        float gap = p.y - referenceHeight(p.xz, 5);
        if (gap < 0.01) {
            hit = true;
            break;
        }
        t += gap;
    }
    seen.radiance = sky * 0.8;
    if (hit) {
        vec3 p = origin + d * t;
        float h = 0.01 * length(p);
        float middle = referenceHeight(p.xz, 8);
        vec3 n = normalize(vec3(middle - referenceHeight(p.xz + vec2(h, 0.0), 8), h, middle - referenceHeight(p.xz + vec2(0.0, h), 8)));
        float f = 0.5 - referenceHeight(p.xz * 1.5, 10);
        float foam = pow(smoothstep(0.0, 1.0, clamp((0.4 - f) / 0.5, 0.0, 1.0)), 6.0) * 0.25;
        float fresnel = pow(clamp(1.0 - abs(dot(n, reflect(d, n))), 0.0, 1.0), 5.0);
        vec3 sea = mix(vec3(0.0, 0.04, 0.04), sky, fresnel) + foam;
        seen.radiance = sea * 0.8;
        seen.normal = n;
        seen.distance = t;
    }
    seen.evaluations = evaluations;
    return seen;
}
