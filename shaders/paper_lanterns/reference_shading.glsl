// Shading of the reference: Lambert and Phong, and noise added to normals in world space. A candle shines through paper
// as if it had two sides and no inside. The sky has two colors, and water reflects equally at any angle.

// Noise of the reference, with its fault: a seam where the angle wraps around.
vec3 referenceNoise(vec3 p)
{
    vec2 uv = vec2(angleOf(-p.z, p.x) / (2.0 * PI) + 0.5, p.y * 0.5 + 0.5) * vec2(2.0, 1.0) * 12.0;
    Noise2 a = gradientNoise(ivec2(floor(uv)), uv - floor(uv), ivec2(0), 11u);
    Noise2 b = gradientNoise(ivec2(floor(uv)), uv - floor(uv), ivec2(0), 12u);
    Noise2 c = gradientNoise(ivec2(floor(uv)), uv - floor(uv), ivec2(0), 13u);
    return vec3(a.value, b.value, c.value);
}

Lit referenceLantern(LanternWalk walk, vec3 localNormal, vec3 worldNormal, vec3 localView)
{
    vec3 p = walk.local;
    bool paper = walk.part == PART_PAPER;
    vec3 albedo = paper ? vec3(0.9, 0.8, 0.62) : (walk.part == PART_WOOD ? vec3(0.30, 0.17, 0.085) : vec3(0.2, 0.16, 0.12));
    vec3 n = localNormal;
    if (paper) {
        vec3 noise = referenceNoise(p) * parameters.fibers * 2.0;
        n = normalize(n + noise * 0.35);
        albedo *= 1.0 - (0.5 + 0.5 * noise.x) * 0.4;
    }
    vec3 to = vec3(0.0, lake.flameHeight, 0.0) - p;
    float squared = max(dot(to, to), 0.01);
    vec3 l = to * inversesqrt(squared);
    float facing = dot(n, l);
    vec3 candle = lake.candle * (walk.lantern.light * 0.2);
    vec3 arriving = candle * ((paper ? abs(facing) : max(facing, 0.0)) / squared);
    float gloss = paper ? 0.0 : pow(max(dot(reflect(-l, n), -localView), 0.0), 20.0);
    Lit lit;
    lit.radiance = albedo * arriving + candle * (0.3 * gloss / squared);
    lit.byMoon = albedo * lake.moonLight * max(dot(worldNormal, lake.towardsMoon), 0.0);
    return lit;
}

#ifdef PANORAMA
// The mip level follows from the change between neighboring pixels, so it is coarsest where the angle wraps around:
// another fault of the reference.
vec3 referencePanorama(vec3 d)
{
    vec3 ahead = vec3(0.70710678 * (d.x + d.z), d.y, 0.70710678 * (d.z - d.x));
    vec3 beside = normalize(ahead + 0.004 * safeNormalize(vec3(-ahead.z, 0.0, ahead.x), vec3(1.0, 0.0, 0.0)));
    vec2 at = equirectangular(ahead);
    return min(textureGrad(environmentPicture, at, equirectangular(beside) - at, vec2(0.0, 0.004 / PI)).rgb, vec3(60.0));
}
#endif

vec3 referenceSky(vec3 d)
{
    float fog = clamp(1.0 - 2.5 * d.y, 0.0, 1.0);
    fog = fog * fog * (3.0 - 2.0 * fog);
    fog = pow(fog, 15.0);
#ifdef PANORAMA
    vec3 sky = referencePanorama(d);
#else
    vec3 sky = mix(vec3(0.05, 0.05, 0.075), vec3(0.012, 0.02, 0.05), clamp(d.y * 1.4, 0.0, 1.0));
#endif
    return mix(sky, parameters.horizonColor, fog);
}
