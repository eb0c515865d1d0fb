// Draws the bounding mesh: a box from -1 to 1, scaled to the object's box.
#include "kit/sdf/object.glsl"

layout(location = 0) in vec3 position;

void main()
{
    vec3 local = mix(object.boxLow, object.boxHigh, position * 0.5 + 0.5);
    gl_Position = frame.clipFromWorld * (object.worldFromLocal * vec4(local, 1.0));
}
