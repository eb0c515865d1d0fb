// Transforms a part of the small world. Normals in view space. Permutations: VERTEX_COLOR, SECOND_UV.
#include "lib/frame.glsl"
#include "pixel_art/object.glsl"
#include "pixel_art/pixel_block.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 extra;
#ifdef VERTEX_COLOR
layout(location = 5) in vec4 color;
out vec4 vertexColor;
#endif

out vec3 modelPosition;
out vec3 viewNormal;
out vec2 uvAt;
#ifdef SECOND_UV
out vec2 secondUv;
#endif
flat out vec4 paintColor;
flat out vec2 paintExtra;

void main()
{
    modelPosition = position;
    viewNormal = mat3(object.worldFromModelNormals) * normal * mat3(pixel.worldFromView);
    uvAt = uv;
#ifdef SECOND_UV
    secondUv = extra;
#endif
    paintColor = tangent;
    paintExtra = extra;
#ifdef VERTEX_COLOR
    vertexColor = color;
#endif
    gl_Position = frame.clipFromWorld * (object.worldFromModel * vec4(position, 1.0));
}
