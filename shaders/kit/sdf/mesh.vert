// Draws the mesh that the marched body is compared with.
#include "kit/sdf/object.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 localPosition;
out vec3 worldNormal;

void main()
{
    localPosition = position;
    worldNormal = transpose(mat3(object.localFromWorld)) * normal;
    gl_Position = frame.clipFromWorld * (object.worldFromLocal * vec4(position, 1.0));
}
