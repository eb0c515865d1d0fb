// Clouds of the reference: 65 growing steps with five octaves of value noise each, and five more lookups towards the
// sun.

float referenceCloudDensity(vec3 p)
{
    vec3 q = p * 0.5 - vec3(0.0, 0.0, 1.5) * work.time + vec3(sin(0.7 * work.time), 0.0, 0.0);
    float lacunarities[5] = float[5](2.02, 2.03, 2.01, 2.02, 2.0);
    float amplitude = 0.5;
    float f = 0.0;
    for (int i = 0; i < 5; ++i) {
        f += amplitude * (0.5 + 0.5 * noiseNear(NOISE_VALUE, q, ivec3(0), vec3(0.0), ivec3(0), uint(parameters.seed)).value);
        q *= lacunarities[i];
        amplitude *= 0.5;
        evaluations += 1.0;
    }
    return clamp(-1.0 - (abs(p.y - 0.5) + 0.5) / 2.0 + 4.0 * f, 0.0, 1.0);
}

PortalSeen referenceClouds(PortalRay ray)
{
    PortalSeen seen = nothingSeen();
    vec3 sun = vec3(-1.0, 0.2, -1.0);
    vec3 origin = ray.origin * 0.001 + vec3(0.0, 5.0, 0.0);
    vec3 color = vec3(0.0);
    float alpha = 0.0;
    int steps = affordableSteps(1 + 5);
    for (int i = 0; i < steps && alpha < 0.99; ++i) {
        float t = 0.1 * float(i);
        vec3 p = origin + ray.direction * (t + 0.2 * t * t);
        float density = referenceCloudDensity(p);
        if (density <= 0.0) continue;
        float shadow = 0.0;
        int count = affordableLightSteps(1 + 5);
        for (int s = 1; s <= count; ++s) shadow += referenceCloudDensity(p + sun * (0.05 * float(s)));
        float lit = clamp(1.0 - shadow / float(count), 0.0, 1.0);
        vec3 sample_ = mix(vec3(1.0), vec3(0.6, 0.5, 0.4), 0.5 * density) * mix(vec3(0.4, 0.47, 0.6), vec3(1.0), lit);
        float a = 0.7 * density;
        color += sample_ * a * (1.0 - alpha);
        alpha += a * (1.0 - alpha);
    }
    vec3 background = mix(vec3(0.3, 0.4, 0.5), vec3(0.5, 0.7, 1.0), clamp(0.5 - 0.5 * ray.direction.y, 0.0, 1.0));
    seen.radiance = (color + background * (1.0 - alpha)) * 0.9;
    seen.evaluations = evaluations;
    return seen;
}
