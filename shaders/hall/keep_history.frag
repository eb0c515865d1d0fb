// Turns a converged picture into the history that a motion begins with: each pixel counts as the number of frames in
// the block.
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
