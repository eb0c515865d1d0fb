// A work behind an opening, in a face of the reflection probe. Its picture was drawn from the same place.
#include "lib/frame.glsl"
#include "hall/probe_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    ProbeWork object;
};

layout(binding = UNIT_SOURCE) uniform sampler2D work;
layout(location = 0) out vec4 radiance;

void main()
{
    vec4 clip = object.pictureFromWorld * vec4(frame.eye + frameRay(gl_FragCoord.xy), 1.0);
    vec2 at = clip.xy / clip.w * 0.5 + 0.5;
    radiance = vec4(textureLod(work, at, 0.0).rgb, 1.0);
}
