// Share of the floor's ambient light that one shape blocks, written as opacity, so that several shapes multiply.
#include "lib/contact.glsl"
#include "kit/floor_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    ContactBlock contact;
};

in vec2 place;
layout(location = 0) out vec4 covered;

void main()
{
    covered = vec4(0.0, 0.0, 0.0, contactShadow(contact.shape, place));
}
