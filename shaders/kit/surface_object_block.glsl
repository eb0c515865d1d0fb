// Transform and material of a mesh. GLSL and C++: render/glsl/std140.h.
const int mapBaseColor = 1, mapRoughness = 2, mapOcclusion = 4, mapEmissive = 8;  // bits of `secondUv`
#define SURFACE_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromModel) \
    FIELD(mat4, worldFromModelNormals)  /* inverse transpose, up to a factor; its fourth column is unused */ \
    FIELD(vec4, baseColor)              /* linear Rec. 709; a: opacity */ \
    FIELD(vec3, emissive)               /* radiance */ \
    FIELD(float, alphaCutoff)           /* fragments with less opacity are discarded; negative: none */ \
    FIELD(float, metalness)             /* 0 to 1 */ \
    FIELD(float, roughness)             /* perceptual, 0 to 1 */ \
    FIELD(float, specular)              /* for dielectrics: 0.5 reflects 4 % */ \
    FIELD(float, normalScale)           /* factor for the normal map's x and y */ \
    FIELD(float, occlusionStrength)     /* strength of the occlusion in the roughness map, 0 to 1 */ \
    FIELD(float, ownOcclusionStrength)  /* the same for a separate occlusion map */ \
    FIELD(float, textureRepeats)        /* texture repeats per unit of uv */ \
    FIELD(float, fontSpread)            /* letters only: texels of the font over which its distance goes from 0 to 1 */ \
    FIELD(int, secondUv)                /* maps that are read at the second texture coordinates, as bits */ \
    FIELD(bool, unlit)                  /* shows the base color without any light */
BLOCK_STRUCT(SurfaceObject, SURFACE_OBJECT_FIELDS)
