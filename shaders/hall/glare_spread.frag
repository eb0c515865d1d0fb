// Sums up the mip levels of the light that causes glare, each smoothed.
#include "lib/glare.glsl"

layout(location = 0) out vec4 spread;

// Cubic B-spline by four bilinear lookups (Sigg and Hadwiger 2005, "Fast Third-Order Texture Filtering").
vec3 smoothed(vec2 at, int level)
{
    vec2 size = vec2(textureSize(halos, level));
    vec2 texel = at * size - 0.5;
    vec2 first = floor(texel);
    vec2 f = texel - first;
    vec2 r = 1.0 - f;
    vec2 w0 = r * r * r / 6.0;
    vec2 w1 = 2.0 / 3.0 - 0.5 * f * f * (2.0 - f);
    vec2 w2 = 2.0 / 3.0 - 0.5 * r * r * (2.0 - r);
    vec2 w3 = f * f * f / 6.0;
    vec2 low = w0 + w1;
    vec2 high = w2 + w3;
    vec2 a = (first - 0.5 + w1 / low) / size;
    vec2 b = (first + 1.5 + w3 / high) / size;
    float mip = float(level);
    return low.y * (low.x * textureLod(halos, a, mip).rgb + high.x * textureLod(halos, vec2(b.x, a.y), mip).rgb) +
           high.y * (low.x * textureLod(halos, vec2(a.x, b.y), mip).rgb + high.x * textureLod(halos, b, mip).rgb);
}

void main()
{
    vec2 at = gl_FragCoord.xy / vec2(textureSize(halos, 0));
    vec3 sum = vec3(0.0);
    for (int level = 0; level < glare.levels; ++level) sum += smoothed(at, level);
    spread = vec4(glare.share * sum, 1.0);
}
