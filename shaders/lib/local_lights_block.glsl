// The local lights of a frame. GLSL and C++: render/glsl/std140.h.
#define MOST_LOCAL_LIGHTS 32

// Cells of the grid that tells where lights may reach: along x, y and z, and all of them, by four.
#define LIGHT_CELLS_X 16
#define LIGHT_CELLS_Y 4
#define LIGHT_CELLS_Z 8
#define LIGHT_CELL_FOURS 128

// One local light: a point, or a sphere of uniform radiance.
#define LOCAL_LIGHT_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, position)     /* world space, meters */ \
    FIELD(float, radius)      /* radius of the sphere, meters; 0: a point */ \
    FIELD(vec3, intensity)    /* radiant intensity, W/sr: for a sphere pi radius^2 times its radiance */ \
    FIELD(float, range)       /* meters: no effect beyond; 0: unlimited */ \
    FIELD(bool, castsShadow)  /* it has shadow maps */ \
    FIELD(int, firstLayer)    /* first of its six layers in the shadow maps */ \
    FIELD(float, nearPlane)   /* near plane of these maps, meters */ \
    FIELD(vec3, axis)         /* axis of its cone, unit */ \
    FIELD(float, coneCosine)  /* cosine of the half angle of full intensity */ \
    FIELD(float, coneScale)   /* 1 over the decrease of the cosine to zero intensity; 0: no cone */ \
    FIELD(float, nearest)     /* meters: closer surfaces get the irradiance of this distance; 0: no limit */
BLOCK_STRUCT(LocalLightEntry, LOCAL_LIGHT_FIELDS)

#define LOCAL_LIGHTS_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, cellsLow)       /* corner of the grid, world space; cells at its faces extend beyond it */ \
    FIELD(int, count) \
    FIELD(vec3, cellsPerMeter)  /* 0: one cell for all places */ \
    ARRAY(ivec4, cells, LIGHT_CELL_FOURS)  /* by x, then y, then z: bit i: light i may reach a place in the cell */ \
    ARRAY(LocalLightEntry, lights, MOST_LOCAL_LIGHTS)  /* only the first `count` are used */
BLOCK_STRUCT(LocalLightsBlock, LOCAL_LIGHTS_FIELDS)
