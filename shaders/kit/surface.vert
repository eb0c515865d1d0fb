// Transforms a mesh with a material. Permutations: VERTEX_COLOR, SECOND_UV, LIGHTMAP, POLISHED_FLOOR.
#include "lib/frame.glsl"
#if defined(LIGHTMAP) || defined(POLISHED_FLOOR)
#define ROOM_AMBIENT
#include "lib/light.glsl"
#endif
#include "kit/surface_object.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 lightmapUv;
#ifdef VERTEX_COLOR
layout(location = 5) in vec4 color;
out vec4 vertexColor;
#endif

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec2 tileUv;
out vec2 atlasUv;
#ifdef SECOND_UV
out vec2 secondUv;
#endif
#ifdef ROOM_AMBIENT
out vec3 roomAmbient;  // Irradiance over pi of the probe for this normal.
#endif

void main()
{
    vec4 world = object.worldFromModel * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = mat3(object.worldFromModelNormals) * normal;
    worldTangent = vec4(mat3(object.worldFromModel) * tangent.xyz, tangent.w);
    tileUv = uv * object.textureRepeats;
    atlasUv = lightmapUv;
#ifdef SECOND_UV
    secondUv = lightmapUv;
#endif
#ifdef VERTEX_COLOR
    vertexColor = color;
#endif
#ifdef ROOM_AMBIENT
    roomAmbient = probeAmbient(safeNormalize(worldNormal, vec3(0.0, 1.0, 0.0)));
#endif
    gl_Position = frame.clipFromWorld * world;
}
