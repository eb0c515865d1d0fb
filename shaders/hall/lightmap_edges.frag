// Fills texels beside the charts of a lightmap, which a linear filter also reads, with the mean of their neighbors on a
// chart.
#include "lib/bindings.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D drawn;

layout(location = 0) out vec4 filled;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    filled = texelFetch(drawn, texel, 0);
    if (filled.a > 0.0) return;
    vec4 sum = vec4(0.0);
    ivec2 last = textureSize(drawn, 0) - 1;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) sum += texelFetch(drawn, clamp(texel + ivec2(x, y), ivec2(0), last), 0);
    filled = sum / max(sum.a, 1.0);
}
