// The dust in the hall's air.

// The ray inside the boxes of air, one or two stretches that do not overlap: entry and exit, twice. An exit before
// its entry is no stretch.
vec4 airStretches(vec3 eye, vec3 direction)
{
    vec2 none = vec2(0.0, -1.0);
    vec2 a = rays.beamCount > 0 ? airBox(eye, direction, rays.beams[0].airLow, rays.beams[0].airHigh) : none;
    vec2 b = rays.beamCount > 1 ? airBox(eye, direction, rays.beams[1].airLow, rays.beams[1].airHigh) : none;
    a.x = max(a.x, 0.0);
    b.x = max(b.x, 0.0);
    if (a.y < a.x) return vec4(b, none);
    if (b.y < b.x || b.x > a.y || a.x > b.y) return vec4(a, b);
    return vec4(min(a.x, b.x), max(a.y, b.y), none);
}

// Share of the light that comes through the air up to `end`, a distance along the ray.
float airThrough(vec3 eye, vec3 direction, vec4 stretches, float end)
{
    float depth = airOpticalDepth(eye.y + direction.y * stretches.x, direction.y, min(stretches.y, end) - stretches.x, parameters.airDensity, parameters.densityFalloff);
    depth += airOpticalDepth(eye.y + direction.y * stretches.z, direction.y, min(stretches.w, end) - stretches.z, parameters.airDensity, parameters.densityFalloff);
    return exp(-depth);
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
    if (parameters.densityNoise <= 0.0) return 1.0;
    float drift = dustNoise(world * vec3(1.1, 1.6, 1.1)) * 0.65 + dustNoise(world * vec3(2.7, 3.7, 2.7) + 19.0) * 0.35;
    return max(1.0 + parameters.densityNoise * (3.0 * drift - 1.5), 0.0);  // Air can be clear, but no clearer.
}
