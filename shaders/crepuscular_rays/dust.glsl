// The dust in the hall's air.

// Interval of the ray inside the air: entry and exit. Empty if exit < entry.
vec2 airStretch(vec3 eye, vec3 direction)
{
    vec2 inside = lineBox(eye, direction, rays.airLow, rays.airHigh);
    return vec2(max(inside.x, 0.0), inside.y);
}

// Transmittance of the air up to `end`, a distance along the ray.
float airThrough(vec3 eye, vec3 direction, vec2 stretch, float end)
{
    return exp(-airOpticalDepth(eye.y + direction.y * stretch.x, direction.y, min(stretch.y, end) - stretch.x, parameters.airDensity, parameters.densityFalloff));
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

// Relative density of the dust at a point; its mean is 1.
float dustDrift(vec3 world)
{
    if (parameters.densityNoise <= 0.0) return 1.0;
    vec3 p = world - rays.drift;
    float drift = dustNoise(p * vec3(1.1, 1.6, 1.1)) * 0.65 + dustNoise(p * vec3(2.7, 3.7, 2.7) + 19.0) * 0.35;
    return max(1.0 + parameters.densityNoise * (3.0 * drift - 1.5), 0.0);  // The density is at least 0.
}
