// A marched body: its transform, and the box that bounds it. GLSL and C++: render/glsl/std140.h.
#define SDF_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromLocal) \
    FIELD(mat4, localFromWorld) \
    FIELD(vec3, boxLow)         /* meters, in the body's own space */ \
    FIELD(float, largestScale)  /* largest scale of worldFromLocal */ \
    FIELD(vec3, boxHigh)
BLOCK_STRUCT(SdfObject, SDF_OBJECT_FIELDS)
