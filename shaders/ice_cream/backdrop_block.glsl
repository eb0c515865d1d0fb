// Backdrop behind the ice cream. GLSL and C++: render/glsl/std140.h.
#define ICE_CREAM_BACKDROP_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromExhibit) \
    FIELD(vec3, foot)        /* center of the plinth's base, exhibit space, meters */ \
    FIELD(float, footRadius) /* meters */
BLOCK_STRUCT(IceCreamBackdrop, ICE_CREAM_BACKDROP_FIELDS)
