// Draws the opening through which the reflection probe sees a work.
#include "lib/frame.glsl"
#include "hall/probe_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    ProbeWork object;
};

layout(location = 0) in vec3 position;

void main()
{
    gl_Position = frame.clipFromWorld * (object.worldFromBox * vec4(position, 1.0));
}
