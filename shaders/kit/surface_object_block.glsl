// A mesh where it stands, and its material. GLSL and C++: render/glsl/std140.h.
#define SURFACE_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromModel) \
    FIELD(mat4, worldFromModelNormals)  /* inverse transpose, up to a factor; its fourth column is unused */ \
    FIELD(vec4, baseColor)              /* linear Rec. 709; a: opacity */ \
    FIELD(vec3, emissive)               /* radiance */ \
    FIELD(float, alphaCutoff)           /* less opacity is not drawn; negative: all is */ \
    FIELD(float, metalness)             /* 0 to 1 */ \
    FIELD(float, roughness)             /* perceptual, 0 to 1 */ \
    FIELD(float, specular)              /* of what is no metal: 0.5 reflects 4 % */ \
    FIELD(float, normalScale)           /* of the normal map's x and y */ \
    FIELD(float, occlusionStrength)     /* share that counts of the occlusion in the map of roughness, 0 to 1 */ \
    FIELD(float, ownOcclusionStrength)  /* the same of an occlusion map of its own */ \
    FIELD(float, textureRepeats)        /* per unit of uv */ \
    FIELD(float, fontSpread)            /* texels of the font over which its distance goes from 0 to 1: letters only */
BLOCK_STRUCT(SurfaceObject, SURFACE_OBJECT_FIELDS)
