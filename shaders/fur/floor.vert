// The floor of the pit, under the bodies.
#include "lib/frame.glsl"
#include "fur/bodies.glsl"

layout(location = 0) in vec3 position;

out vec3 world;

void main()
{
    vec4 p = worldFromPit * vec4(position.x * pit.x, 0.003, position.z * pit.x, 1.0);
    world = p.xyz;
    gl_Position = frame.clipFromWorld * p;
}
