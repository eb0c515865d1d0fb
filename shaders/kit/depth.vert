// Outputs positions only: for shadow maps.
#include "lib/frame.glsl"
#include "kit/surface_object.glsl"

layout(location = 0) in vec3 position;

void main()
{
    gl_Position = frame.clipFromWorld * (object.worldFromModel * vec4(position, 1.0));
}
