// Converts the drawn depth (reversed, 32-bit) to the precision and range of another depth buffer.
#include "lib/bindings.glsl"
#include "pixel_art/pixel_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};
layout(binding = UNIT_SOURCE) uniform sampler2D drawnDepth;
layout(location = 0) out vec4 stored;

void main()
{
    float d = texelFetch(drawnDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (pixel.standardDepth) d = 1.0 - d;
    if (pixel.depthLevels > 0.0) d = floor(d * pixel.depthLevels + 0.5) / pixel.depthLevels;
    stored = vec4(d, 0.0, 0.0, 1.0);
}
