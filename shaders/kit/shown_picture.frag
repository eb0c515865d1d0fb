// Display values (sRGB) of a finished picture, texel by texel, for the screen of an exhibit.
#include "lib/bindings.glsl"
#include "lib/srgb.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 shown;

void main()
{
    shown = vec4(srgbFromLinear(texelFetch(source, ivec2(gl_FragCoord.xy), 0).rgb), 1.0);
}
