// Draws a mesh at its position in the hall's lightmap.
#include "kit/surface_object.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 4) in vec2 lightmapUv;

out vec3 worldPosition;
out vec3 worldNormal;
out vec2 atlasUv;

void main()
{
    worldPosition = (object.worldFromModel * vec4(position, 1.0)).xyz;
    worldNormal = mat3(object.worldFromModelNormals) * normal;
    atlasUv = lightmapUv;
    gl_Position = vec4(lightmapUv * 2.0 - 1.0, 0.5, 1.0);
}
