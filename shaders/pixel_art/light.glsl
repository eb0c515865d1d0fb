// Light of the small world. Include it after pixel_art/picture.glsl and the exhibit's parameters. Permutation: SHADOWS.
#ifdef SHADOWS
layout(binding = UNIT_SHADOW_EXHIBITS) uniform sampler2DShadow shadowMap;
#endif

// Visibility of the sun. `place` and `n` in view space; `width` of a texel, meters.
float sunlit(vec3 place, vec3 n, float width)
{
#ifdef SHADOWS
    // Offset out of the surface by more than the width of a shadow map texel.
    vec4 at = pixel.shadowFromView * vec4(place + n * (0.6 * width + 0.02) + pixel.sun * 0.02, 1.0);
    float reached = textureLod(shadowMap, at.xyz, 0.0);
    bool beyond = any(lessThan(at.xyz, vec3(0.0))) || any(greaterThan(at.xy, vec2(1.0)));
    return beyond ? 1.0 : reached;
#else
    return 1.0;
#endif
}

// Quantizes light to `bands` even steps; the darkest is 0, the brightest 1.
float banded(float light)
{
    int bands = parameters.bands;
    if (bands < 2) return light;
    float steps = float(bands - 1);
    return min(floor(light * float(bands)), steps) / steps;
}

// Share of the sun that a surface reflects, 0 to 1.
float sunOn(vec3 place, vec3 n, float width)
{
    return banded(clamp(dot(n, pixel.sun), 0.0, 1.0) * sunlit(place, n, width));
}

// Color lit by the sun and the sky.
vec3 shaded(vec3 base, vec3 n, float light)
{
    float up = 0.5 + 0.5 * dot(n, pixel.up);
    vec3 shade = mix(parameters.bounceLight, parameters.shadeLight, floor(up * 3.0 + 0.52) / 3.0);
    return base * (shade + parameters.sunLight * light);
}
