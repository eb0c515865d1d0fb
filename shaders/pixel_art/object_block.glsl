// A part of the small world where it stands. GLSL and C++: render/glsl/std140.h.
#define PIXEL_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromModel) \
    FIELD(mat4, worldFromModelNormals)  /* inverse transpose, up to a factor */ \
    FIELD(vec4, color)                  /* of a visitor's model: linear Rec. 709, and opacity */ \
    FIELD(vec3, emissive)               /* of a visitor's model */ \
    FIELD(float, id)                    /* added to that of the vertices */ \
    FIELD(float, alphaCutoff)           /* less opacity is not drawn; negative: all is */ \
    FIELD(bool, colored)                /* tangents hold color and id, `extra` glow and pattern */
BLOCK_STRUCT(PixelObjectBlock, PIXEL_OBJECT_FIELDS)
