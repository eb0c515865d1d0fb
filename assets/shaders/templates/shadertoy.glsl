// Code for Shadertoy. A line #iUniform makes a slider: type, name, initial value, range.
#iUniform float rings = 12.0 in {1.0, 40.0}
#iUniform color3 tint = color3(1.0, 0.8, 0.5)

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 p = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    float wave = 0.5 + 0.5 * cos(rings * length(p) - 2.0 * iTime);
    fragColor = vec4(wave * tint, 1.0);
}
