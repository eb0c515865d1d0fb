// A part of the small world as its sun sees it.
#include "lib/frame.glsl"
#include "pixel_art/object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PixelObjectBlock object;
};

layout(location = 0) in vec3 position;

void main()
{
    gl_Position = frame.clipFromWorld * (object.worldFromModel * vec4(position, 1.0));
}
