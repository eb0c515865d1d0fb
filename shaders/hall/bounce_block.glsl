// The sources of the sun's bounced light, and the air that they light. GLSL and C++: render/glsl/std140.h.
#define MOST_BOUNCE_SOURCES 512
#define BOUNCE_FIELDS(FIELD, ARRAY) \
    FIELD(ivec3, size)                      /* points in the air along x, y and z */ \
    FIELD(int, sources)                     /* how many shine */ \
    FIELD(vec3, tintScale)                  /* of the rows of tint */ \
    FIELD(int, tintRow)                     /* the first of three */ \
    ARRAY(vec4, shining, MOST_BOUNCE_SOURCES) /* x: row of the picture, y: light times the row's scale */
BLOCK_STRUCT(BounceBlock, BOUNCE_FIELDS)

// The air on the walls.
#define AIR_ON_WALLS_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, low)                        /* corners of the air's points, world space */ \
    FIELD(float, scale)                     /* of the picture of surfaces against the air */ \
    FIELD(vec3, high)
BLOCK_STRUCT(AirOnWalls, AIR_ON_WALLS_FIELDS)
