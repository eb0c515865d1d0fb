// One texel to one pixel; used with blending to keep a running mean.
#include "lib/bindings.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 copied;

void main()
{
    copied = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
}
