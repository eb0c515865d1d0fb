// A torus-mug of one morph, ready for many points: made once for each frame. Meters, in the solid's own space;
// heights and the ring's center are relative to the body's center, which lies on the cup's axis. GLSL and C++:
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
    FIELD(float, footHeight)         /* of the middle of the foot's bead */ \
    FIELD(float, footTube) \
    FIELD(vec2, ringCenter) \
    FIELD(float, ringRadius) \
    FIELD(float, ringTube) \
    FIELD(float, ringStretch)        /* half the length by which the ring is drawn apart along y */ \
    FIELD(float, joint)              /* width of the blend of ring and body */ \
    FIELD(float, lip)                /* width of the blend of body and cavity */
BLOCK_STRUCT(TorusMugShape, TORUS_MUG_SHAPE_FIELDS)
