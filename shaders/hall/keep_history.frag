// A picture at rest as what a motion begins with: each pixel stands for as many frames as the block says.
#include "lib/bindings.glsl"
#include "hall/antialiasing_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Antialiasing {
    AntialiasingBlock antialiasing;
};
layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 kept;

void main()
{
    kept = vec4(texelFetch(source, ivec2(gl_FragCoord.xy), 0).rgb, antialiasing.frames);
}
