// A floor at y = 0 with things that stand on it (lib/standing_block.glsl). GLSL and C++: render/glsl/std140.h.
#ifndef __cplusplus
#include "lib/standing_block.glsl"
#endif

// One shape as it is drawn into the map of contact shadows.
#define CONTACT_FIELDS(FIELD, ARRAY) \
    FIELD(StandingShape, shape) \
    FIELD(vec4, area)         /* of the floor that is drawn: least x, least z, greatest x, greatest z, meters */ \
    FIELD(vec4, mapArea)      /* of the floor that the map covers */
BLOCK_STRUCT(ContactBlock, CONTACT_FIELDS)

#define MOST_MIRRORED_SHAPES 32
#define MOST_UPRIGHT_BARS 8
#define MIRROR_AZIMUTHS 128

// What the floor mirrors exactly. The window is in a wall along x and ends in a semicircle.
#define FLOOR_MIRROR_FIELDS(FIELD, ARRAY) \
    FIELD(vec4, mapArea)      /* of the floor that the map of contact shadows covers, as above */ \
    FIELD(vec4, window)       /* least x, greatest x, sill's y, greatest y, meters; none where x <= least x */ \
    FIELD(vec4, oculus)       /* of the round opening above: center, radius; none where it is 0 */ \
    FIELD(vec2, windowZ)      /* of the sill's inner edge and of the panes */ \
    FIELD(float, behindBars)  /* share of the panes that level bars leave: they are thinner than any lobe is high */ \
    FIELD(int, uprightBars)   /* their number */ \
    ARRAY(vec2, bars, MOST_UPRIGHT_BARS)             /* of each its x and half its width */ \
    ARRAY(uint, shapesAt, MIRROR_AZIMUTHS)           /* by azimuth seen from the eye: bit i for shape i */ \
    ARRAY(StandingShape, shapes, MOST_MIRRORED_SHAPES)  /* from near to far */
BLOCK_STRUCT(FloorMirrorBlock, FLOOR_MIRROR_FIELDS)
