// A mesh with a material.
#include "lib/frame.glsl"
#include "kit/surface_object.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 lightmapUv;

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec2 tileUv;
out vec2 atlasUv;

void main()
{
    vec4 world = object.worldFromModel * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = mat3(object.worldFromModelNormals) * normal;
    worldTangent = vec4(mat3(object.worldFromModel) * tangent.xyz, tangent.w);
    tileUv = uv * object.textureRepeats;
    atlasUv = lightmapUv;
    gl_Position = frame.clipFromWorld * world;
}
