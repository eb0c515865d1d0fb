// Draws the letters of a plaque: quads in world space, texture coordinates of the font's distance field.
#include "lib/frame.glsl"
#include "kit/surface_object.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec2 uv;

out vec3 worldPosition;
out vec3 worldNormal;
out vec2 glyphUv;

void main()
{
    vec4 world = object.worldFromModel * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = mat3(object.worldFromModelNormals) * normal;
    glyphUv = uv;
    gl_Position = frame.clipFromWorld * world;
}
