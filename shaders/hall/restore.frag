// Copies the depth of static objects back into the sun's shadow map.
#include "lib/bindings.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D still;

void main()
{
    gl_FragDepth = texelFetch(still, ivec2(gl_FragCoord.xy), 0).r;
}
