// Copies one texel to one pixel; used with blending to keep a running mean. Permutation: COVERAGE (alpha is coverage:
// DISPLAY_LIGHT of lib/display_light.glsl becomes 1).
#include "lib/bindings.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 copied;

void main()
{
    copied = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
#ifdef COVERAGE
    copied.a = min(copied.a, 1.0);
#endif
}
