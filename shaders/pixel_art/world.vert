// A part of the small world. Normals in view space.
#include "lib/frame.glsl"
#include "pixel_art/object_block.glsl"
#include "pixel_art/pixel_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PixelObjectBlock object;
};
layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 extra;

out vec3 modelPosition;
out vec3 viewNormal;
out vec2 uvAt;
flat out vec4 vertexColor;
flat out vec2 vertexExtra;

void main()
{
    modelPosition = position;
    viewNormal = mat3(object.worldFromModelNormals) * normal * mat3(pixel.worldFromView);
    uvAt = uv;
    vertexColor = tangent;
    vertexExtra = extra;
    gl_Position = frame.clipFromWorld * (object.worldFromModel * vec4(position, 1.0));
}
