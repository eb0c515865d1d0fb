// False color for a count, 0 to 1.

// Black, violet, red, amber, white: rising brightness, so that it is readable in grayscale, too.
vec3 heatColor(float x)
{
    float t = clamp(x, 0.0, 1.0) * 4.0;
    vec3 c = mix(vec3(0.01, 0.01, 0.03), vec3(0.16, 0.04, 0.30), clamp(t, 0.0, 1.0));
    c = mix(c, vec3(0.62, 0.09, 0.10), clamp(t - 1.0, 0.0, 1.0));
    c = mix(c, vec3(0.90, 0.50, 0.08), clamp(t - 2.0, 0.0, 1.0));
    return mix(c, vec3(0.97, 0.96, 0.90), clamp(t - 3.0, 0.0, 1.0));
}
