// A portal: an opening that shows another world. GLSL and C++: render/glsl/std140.h.
#define PORTAL_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromOpening)  /* a square from -1 to 1 on z = 0, which the opening fills */ \
    FIELD(mat4, workFromWorld)     /* from the hall to the world behind: rotation, translation and uniform scale */ \
    FIELD(vec4, plane)             /* plane of the opening, world space, facing the viewer */ \
    FIELD(float, workPerMeter)     /* the uniform scale */ \
    FIELD(float, radianceScale)    /* converts the portal's exposed values to radiance of the hall */ \
    FIELD(vec3, dividerAt)         /* a line through this point, world space, divides the picture */ \
    FIELD(float, side)             /* draws only the right part: 1; only the left part: -1; all: 0 */ \
    FIELD(vec3, dividerUp)         /* direction of the dividing line */
BLOCK_STRUCT(PortalBlock, PORTAL_FIELDS)
