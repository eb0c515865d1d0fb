// What a model's mask cuts out throws no shadow. After pixel_art/shadow.vert with MASKED.
#include "lib/bindings.glsl"
#include "pixel_art/object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PixelObjectBlock object;
};
layout(binding = UNIT_BASE_COLOR) uniform sampler2D baseColorMap;

in vec2 uvAt;

void main()
{
    if (object.color.a * texture(baseColorMap, uvAt).a < object.alphaCutoff) discard;
}
