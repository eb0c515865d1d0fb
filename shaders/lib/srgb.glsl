// Transfer function of sRGB (IEC 61966-2-1) and its inverse, both clamped to [0, 1]: render/image/srgb.h.

vec3 srgbFromLinear(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec3 linearFromSrgb(vec3 encoded)
{
    vec3 c = clamp(encoded, 0.0, 1.0);
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}
