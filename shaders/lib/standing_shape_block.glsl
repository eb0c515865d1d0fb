// An object on a floor, as a simple upright shape: it darkens the floor around it and is reflected in it.
// GLSL and C++: render/glsl/std140.h.
#define STANDING_BOX 0
#define STANDING_CYLINDER 1
#define STANDING_SPHERE 2

#define STANDING_SHAPE_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, center)       /* world space, meters */ \
    FIELD(int, kind)          /* STANDING_ */ \
    FIELD(vec2, axis)         /* direction of a box's first side in the floor's x and z, unit */ \
    FIELD(vec2, halfSize)     /* half sides of a box along the axis and across it, meters; else x: the radius */ \
    FIELD(float, halfHeight)  /* meters */ \
    FIELD(float, strength)    /* strength of its contact shadow, 0 to 1; 0: none */ \
    FIELD(float, reach)       /* distance at which its contact shadow ends, meters */ \
    FIELD(vec3, color)        /* mean reflectance, linear Rec. 709 */
BLOCK_STRUCT(StandingShape, STANDING_SHAPE_FIELDS)
