// Maps scene-linear radiance to display-referred linear light. Alpha (coverage) is premultiplied in both.
#include "lib/light.glsl"
#include "lib/tonemap.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 display;

void main()
{
    vec4 radiance = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
    display = vec4(displayLight(radiance.rgb * light.exposure, radiance.a), min(radiance.a, 1.0));
    if (radiance.a <= 0.0) display.rgb = vec3(0.0);
}
