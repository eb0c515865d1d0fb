// Shape of the torus-mug for one morph, precomputed once for each frame. Meters, in the solid's own space. Heights and
// the ring's center are relative to the body's center, which lies on the cup's axis. GLSL and C++:
// render/glsl/std140.h.
#define TORUS_MUG_SHAPE_FIELDS(FIELD, ARRAY) \
    FIELD(float, morph)              /* 0 torus, 1 mug */ \
    FIELD(vec3, bodyCenter) \
    FIELD(float, bodyRadius) \
    FIELD(float, bodyHalfHeight) \
    FIELD(float, bodyRoundingAbove) \
    FIELD(float, bodyRoundingBelow) \
    FIELD(float, cavityRadius) \
    FIELD(float, cavityBottom) \
    FIELD(float, cavityRounding) \
    FIELD(float, footRadius) \
    FIELD(float, footHeight)         /* height of the center of the foot's bead */ \
    FIELD(float, footTube) \
    FIELD(vec2, ringCenter) \
    FIELD(float, ringRadius) \
    FIELD(float, ringTube) \
    FIELD(float, ringStretch)        /* half the length by which the ring is stretched along y */ \
    FIELD(float, joint)              /* width of the blend between ring and body */ \
    FIELD(float, lip)                /* width of the blend between body and cavity */
BLOCK_STRUCT(TorusMugShape, TORUS_MUG_SHAPE_FIELDS)
