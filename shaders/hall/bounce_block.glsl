// Sources of the sun's bounced light, and the grid of points in the air that they light. GLSL and C++:
// render/glsl/std140.h.
#define MOST_BOUNCE_SOURCES 512
#define BOUNCE_FIELDS(FIELD, ARRAY) \
    FIELD(ivec3, size)                      /* number of points in the air along x, y and z */ \
    FIELD(int, sources)                     /* number of sources that are lit */ \
    FIELD(vec3, tintScale)                  /* scale of the rows of tint */ \
    FIELD(int, tintRow)                     /* first of three rows */ \
    ARRAY(vec4, shining, MOST_BOUNCE_SOURCES) /* x: row of the picture, y: light times the row's scale */
BLOCK_STRUCT(BounceBlock, BOUNCE_FIELDS)

// Light of the air on the walls.
#define AIR_ON_WALLS_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, low)                        /* corners of the grid of points, world space */ \
    FIELD(float, scale)                     /* scale of the surfaces' picture relative to the air */ \
    FIELD(vec3, high)
BLOCK_STRUCT(AirOnWalls, AIR_ON_WALLS_FIELDS)
