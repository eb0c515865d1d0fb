// Covers the part of the contact shadow map that one shape affects with a triangle.
#include "lib/bindings.glsl"
#include "lib/covering_triangle.glsl"
#include "kit/floor_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    ContactBlock contact;
};

out vec2 place;

void main()
{
    place = mix(contact.area.xy, contact.area.zw, coveringCorner());
    vec2 inMap = (place - contact.mapArea.xy) / (contact.mapArea.zw - contact.mapArea.xy);
    gl_Position = vec4(inMap * 2.0 - 1.0, 0.0, 1.0);
}
