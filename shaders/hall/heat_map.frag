// Shows the number of fragments in each pixel in false color, over the whole picture.
#include "lib/bindings.glsl"
#include "lib/light_uniform.glsl"
#include "lib/heat_color.glsl"
#include "lib/display_light.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D fragments;
layout(location = 0) out vec4 radiance;

void main()
{
    float count = texelFetch(fragments, ivec2(gl_FragCoord.xy), 0).r;
    radiance = vec4(heatColor(count / parameters.heatScale) / light.exposure, DISPLAY_LIGHT);
}
