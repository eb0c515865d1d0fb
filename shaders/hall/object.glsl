// One drawn mesh of the hall: mirrored by SurfaceObject in exhibits/hall/surface_pass.h.
#include "lib/bindings.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    mat4 worldFromModel;
    mat4 worldFromModelNormals;  // inverse transpose; its fourth column is unused
    vec4 baseColor;
    vec4 material;               // x: metalness, y: roughness, z: normal scale, w: occlusion strength
    vec4 emissive;               // w: alpha cutoff, negative when opaque
    vec4 tiling;                 // x: texture repeats per unit of uv; z: first pixel right of the wipe; w: specular
} object;
