// The dust in the hall's air.

// Share of the light that comes through the air from `begin` to `end`, distances along the ray.
float airThrough(vec3 eye, vec3 direction, float begin, float end)
{
    return exp(-airOpticalDepth(eye.y + direction.y * begin, direction.y, end - begin, parameters.airDensity, parameters.airThinning));
}

// Value noise on a lattice of one unit, 0 to 1, smooth.
float dustNoise(vec3 p)
{
    vec3 base = floor(p);
    vec3 f = p - base;
    f = f * f * (3.0 - 2.0 * f);
    ivec3 cell = ivec3(base);
    vec4 near = vec4(unitFromBits(hashCell(cell, 7u).x), unitFromBits(hashCell(cell + ivec3(1, 0, 0), 7u).x),
                     unitFromBits(hashCell(cell + ivec3(0, 1, 0), 7u).x), unitFromBits(hashCell(cell + ivec3(1, 1, 0), 7u).x));
    vec4 far = vec4(unitFromBits(hashCell(cell + ivec3(0, 0, 1), 7u).x), unitFromBits(hashCell(cell + ivec3(1, 0, 1), 7u).x),
                    unitFromBits(hashCell(cell + ivec3(0, 1, 1), 7u).x), unitFromBits(hashCell(cell + ivec3(1, 1, 1), 7u).x));
    vec4 z = mix(near, far, f.z);
    vec2 y = mix(z.xy, z.zw, f.y);
    return mix(y.x, y.y, f.x);
}

// How much more or less dust than the mean there is at a point; its own mean is 1.
float dustDrift(vec3 world)
{
    if (parameters.unevenness <= 0.0) return 1.0;
    float drift = dustNoise(world * vec3(1.1, 1.6, 1.1)) * 0.65 + dustNoise(world * vec3(2.7, 3.7, 2.7) + 19.0) * 0.35;
    return 1.0 + parameters.unevenness * (3.0 * drift - 1.5);
}
