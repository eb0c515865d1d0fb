// Copies the picture of all opaque surfaces, as the background for glass: color, with alpha 0 where nothing was drawn,
// and reversed depth.
#include "lib/bindings.glsl"

layout(binding = UNIT_BACKDROP) uniform sampler2D radiance;
layout(binding = UNIT_BACKDROP_DEPTH) uniform sampler2D depth;

layout(location = 0) out vec4 copiedRadiance;
layout(location = 1) out float copiedDepth;

void main()
{
    copiedRadiance = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
    copiedDepth = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
}
