// Light in the air from sky and sun. GLSL and C++: render/glsl/std140.h.
#define AIR_LIGHT_FIELDS(FIELD, ARRAY) \
    FIELD(ivec3, size)          /* number of points along x, y and z */ \
    FIELD(int, skyRow)          /* first of three rows of the picture */ \
    FIELD(vec3, sky)            /* radiance times the rows' scales */ \
    FIELD(vec3, sun)            /* irradiance on a plane that faces it */ \
    FIELD(vec3, lamps)          /* radiance of the vault's lamps times the scale of their picture */
BLOCK_STRUCT(AirLightBlock, AIR_LIGHT_FIELDS)
