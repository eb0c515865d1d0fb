// Environment of a scene: three colors from the ground up, or a panorama.

#ifdef PANORAMA
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D panorama;

// Radiance of the panorama, blurred over `width`: about 1.5 texels at level 0, the whole picture at the last level.
vec3 panoramaAt(vec3 d, float width)
{
    bool pole = abs(d.x) + abs(d.z) < 1e-6;
    float u = pole ? 0.5 : fract(atan(d.x, -d.z) / (2.0 * PI) + 0.5 + stage.environmentRotation / (2.0 * PI));
    float height = float(textureSize(panorama, 0).y);
    float level = log2(max(width * height / PI, 1.0));
    // The texture repeats vertically, too, so the lookup must not mix the first row with the last one.
    float edge = min(0.5 * exp2(ceil(level)) / height, 0.5);
    vec3 seen = textureLod(panorama, vec2(u, clamp(acos(clamp(d.y, -1.0, 1.0)) / PI, edge, 1.0 - edge)), level).rgb;
    return max(seen, vec3(0.0)) * stage.environmentBrightness;
}
#else
// Cosine-weighted mean of the sky over the hemisphere around `up`; closed forms fitted to the sky below.
vec3 skyAround(float up)
{
    float above = 0.5 + 0.5 * up;
    vec3 high = mix(stage.horizon, stage.zenith, 0.35 + 0.35 * above);
    vec3 low = mix(stage.horizon, stage.ground, 0.9 - 0.15 * above);
    return mix(low, high, above);
}
#endif

// Radiance of the environment from a direction, blurred by `roughness` (perceptual, 0 to 1).
vec3 environmentLight(vec3 d, float roughness)
{
#ifdef PANORAMA
    return panoramaAt(d, 2.5 * roughness * roughness);
#else
    float blur = roughness * roughness;
    vec3 sky;
    if (d.y >= 0.0) sky = mix(stage.horizon, stage.zenith, 1.0 - exp(-3.5 * d.y));
    else sky = mix(stage.horizon, stage.ground, 1.0 - exp(mix(18.0, 4.0, blur) * d.y));
    return mix(sky, skyAround(d.y), blur);
#endif
}

// Irradiance over pi of the whole environment.
vec3 environmentAround(vec3 n)
{
#ifdef PANORAMA
    return panoramaAt(n, 1.6);
#else
    return skyAround(n.y);
#endif
}
