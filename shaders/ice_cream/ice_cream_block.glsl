// An ice cream at one moment, precomputed once for each frame. Meters, in its own space: y up, the wafer's foot on y =
// 0, its axis the y axis. GLSL and C++: render/glsl/std140.h.
#define CREAM_LAYERS 2
#define CANDIES 10

// Numbers of the parts, and their bits in `parts`. The candies are PART_CANDY to PART_CANDY + CANDIES - 1. A sprinkle
// of color k has the number PART_SPRINKLE + k.
#define PART_FOOT 0
#define PART_COLLAR 1
#define PART_BOWL 2
#define PART_RINGS 3
#define PART_BARS 4
#define PART_CREAM 5  // The lower layer; the upper one is the next number.
#define PART_PLINTH 7
#define PART_SPRINKLES 8
#define PART_CANDY 9
#define PART_SPRINKLE 19

// Stages of the build-up, as in the reference's slides. Each stage shows its own element and all before it.
#define STAGE_FOOT 0
#define STAGE_COLLAR 1
#define STAGE_BOWL 2
#define STAGE_RINGS 3
#define STAGE_BARS 4
#define STAGE_WAFER 5      // joined smoothly
#define STAGE_CONE 6       // one sharp cone of cream
#define STAGE_ROUND 7      // with round edges
#define STAGE_REPEATED 8   // around the axis
#define STAGE_JOINED 9     // smoothly
#define STAGE_TWIST 10
#define STAGE_UPPER 11
#define STAGE_LAYERS 12    // joined smoothly
#define STAGE_CANDIES 13
#define STAGE_COLORS 14
#define STAGE_SPECULAR 15
#define STAGE_CLASSIC 16   // soft shadow
#define STAGE_IMPROVED 17  // soft shadow
#define STAGE_OCCLUSION 18
#define STAGE_FOG 19
#define STAGE_FINISHED 20  // edges without stairs

// A layer of cream: cones with round edges around the axis, twisted by their height.
#define CREAM_LAYER_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, foot)        /* center of the first cone's base */ \
    FIELD(float, radius)     /* radius of its base, without the rounding */ \
    FIELD(vec3, axis)        /* unit vector from there to its tip */ \
    FIELD(float, halfHeight) /* without the rounding */ \
    FIELD(vec3, color)       /* linear Rec. 709 */ \
    FIELD(float, corner)     /* radius of the rounding */ \
    FIELD(vec3, ball)        /* center of a ball that contains the first cone */ \
    FIELD(float, ballRadius) \
    FIELD(float, ballAngle)  /* angle of the ball's center around the y axis, radians */ \
    FIELD(vec4, hull)        /* cylinder that contains all cones: radius, middle, half height */ \
    FIELD(int, lobes) \
    FIELD(float, twist)      /* radians per meter of height */ \
    FIELD(float, blend)      /* width of the fillet between neighbors */
BLOCK_STRUCT(CreamLayer, CREAM_LAYER_FIELDS)

#define CANDY_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, center) \
    FIELD(float, reach)      /* radius of the ball that contains it */ \
    FIELD(vec3, axisX)       /* its own axes, unit length */ \
    FIELD(float, corner) \
    FIELD(vec3, axisY) \
    FIELD(float, unused) \
    FIELD(vec3, halfSize) \
    FIELD(vec3, color)
BLOCK_STRUCT(Candy, CANDY_FIELDS)

#define ICE_CREAM_FIELDS(FIELD, ARRAY) \
    ARRAY(CreamLayer, layers, CREAM_LAYERS) \
    ARRAY(Candy, candies, CANDIES) \
    FIELD(vec4, foot)        /* frustum: radius at y = 0, radius at its top, its height, 0 */ \
    FIELD(vec4, collar)      /* frustum: bottom radius, top radius, y of its bottom, y of its top */ \
    FIELD(vec4, bowl)        /* part of a ball: radius, y of its center, y of its bottom, y of its top */ \
    FIELD(vec4, waferHull)   /* cylinder that contains the wafer: radius, middle, half height */ \
    FIELD(vec4, plinth)      /* radius, height, rounding, 0 */ \
    FIELD(int, rings) \
    FIELD(float, ringTube)   /* radius of the rings' tube */ \
    FIELD(int, bars) \
    FIELD(float, barRadius) \
    FIELD(float, reliefBlend) /* blend between rings and bars */ \
    FIELD(float, footBlend)  /* blend between them and the foot */ \
    FIELD(float, layerBlend) \
    FIELD(float, waferBlend) /* blend between cream and wafer */ \
    FIELD(int, parts)        /* bits of the parts that are shown */ \
    FIELD(int, stage)        /* stage of the build-up */ \
    FIELD(float, steepest)   /* the largest twist, radians per meter */ \
    FIELD(float, outermost)  /* radius of the cream */ \
    FIELD(vec3, gridLow)     /* low corner of the sprinkles' grid */ \
    FIELD(float, gridCell)   /* width of its cells */ \
    FIELD(ivec3, gridCells)  /* number along each axis; 0: no sprinkles */ \
    FIELD(float, sprinkleRadius) \
    FIELD(float, sprinkleReach)  /* how far one may extend beyond the cream */ \
    FIELD(vec3, towardsHall)     /* unit vector towards the hall */
BLOCK_STRUCT(IceCreamShape, ICE_CREAM_FIELDS)
