// A part of the small world as its sun sees it. Permutation: MASKED, a part has a mask (pixel_art/shadow.frag).
#include "lib/frame.glsl"
#include "pixel_art/object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PixelObjectBlock object;
};

layout(location = 0) in vec3 position;
#ifdef MASKED
layout(location = 3) in vec2 uv;
out vec2 uvAt;
#endif

void main()
{
#ifdef MASKED
    uvAt = uv;
#endif
    gl_Position = frame.clipFromWorld * (object.worldFromModel * vec4(position, 1.0));
}
