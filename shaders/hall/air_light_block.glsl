// Light in the air of sky and sun. GLSL and C++: render/glsl/std140.h.
#define AIR_LIGHT_FIELDS(FIELD, ARRAY) \
    FIELD(ivec3, size)          /* points along x, y and z */ \
    FIELD(int, skyRow)          /* of the picture, the first of three */ \
    FIELD(vec3, sky)            /* radiance times the rows' scales */ \
    FIELD(vec3, sun)            /* irradiance on what faces it */ \
    FIELD(vec3, lamps)          /* radiance of those in the vault times the scale of their picture */
BLOCK_STRUCT(AirLightBlock, AIR_LIGHT_FIELDS)
