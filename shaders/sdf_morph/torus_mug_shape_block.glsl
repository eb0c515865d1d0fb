// The parameters of a torus-mug, by the names of the table. Meters, all > 0 except morph and blend. GLSL and C++:
// render/glsl/std140.h.
#define TORUS_MUG_FIELDS(FIELD, ARRAY) \
    FIELD(float, morph)              /* 0 torus, 1 mug; cut to [0, 1] */ \
    FIELD(float, majorRadius)        /* torus: center to the middle of the tube */ \
    FIELD(float, minorRadius)        /* torus: radius of the tube */ \
    FIELD(float, mugRadius)          /* outside of the cup */ \
    FIELD(float, mugHeight)          /* ground to lip */ \
    FIELD(float, wallThickness)      /* cut to the mug's radius */ \
    FIELD(float, handleRadius)       /* center to the middle of the handle */ \
    FIELD(float, handleThickness)    /* diameter of the handle */ \
    FIELD(float, blend)              /* width of the fillet between handle and cup */
BLOCK_STRUCT(TorusMug, TORUS_MUG_FIELDS)

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
    FIELD(float, footHeight)         /* height of the center of the foot's bead */ \
    FIELD(float, footTube) \
    FIELD(vec2, ringCenter) \
    FIELD(float, ringRadius) \
    FIELD(float, ringTube) \
    FIELD(float, ringStretch)        /* half the length by which the ring is stretched along y */ \
    FIELD(float, joint)              /* width of the blend between ring and body */ \
    FIELD(float, lip)                /* width of the blend between body and cavity */
BLOCK_STRUCT(TorusMugShape, TORUS_MUG_SHAPE_FIELDS)
