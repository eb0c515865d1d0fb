// An opening through which one looks into a world of its own. GLSL and C++: render/glsl/std140.h.
#define PORTAL_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromOpening)  /* a square from -1 to 1 on z = 0, which the opening fills */ \
    FIELD(mat4, workFromWorld)     /* the world beyond from the hall's: a rotation, a shift and one scale */ \
    FIELD(vec4, plane)             /* of the opening, world space, towards the visitor */ \
    FIELD(float, workPerMeter)     /* that scale */ \
    FIELD(float, radianceScale)    /* what is seen is told as the film sees it: radiance of the hall over that */ \
    FIELD(vec3, dividerAt)         /* a line through this, world space, ... */ \
    FIELD(float, side)             /* ... of which what is seen to the right is drawn: 1; to the left: -1; all: 0 */ \
    FIELD(vec3, dividerUp)         /* its direction */
BLOCK_STRUCT(PortalBlock, PORTAL_FIELDS)
