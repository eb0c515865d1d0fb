// A floor at y = 0 with objects on it (lib/standing_shape_block.glsl). GLSL and C++: render/glsl/std140.h.
#ifndef __cplusplus
#include "lib/standing_shape_block.glsl"
#endif

// One shape as drawn into the map of contact shadows.
#define CONTACT_FIELDS(FIELD, ARRAY) \
    FIELD(StandingShape, shape) \
    FIELD(vec4, area)         /* part of the floor that is drawn: least x, least z, greatest x, greatest z, meters */ \
    FIELD(vec4, mapArea)      /* part of the floor that the map covers */
BLOCK_STRUCT(ContactBlock, CONTACT_FIELDS)

#define MOST_MIRRORED_SHAPES 32
#define MOST_UPRIGHT_BARS 8
#define MIRROR_AZIMUTHS 128

// Objects that the floor reflects exactly. The window is in a wall along x and ends in a semicircle.
#define FLOOR_MIRROR_FIELDS(FIELD, ARRAY) \
    FIELD(vec4, mapArea)      /* part of the floor that the map of contact shadows covers, as above */ \
    FIELD(vec4, window)       /* least x, greatest x, sill's y, greatest y, meters; none if greatest x <= least x */ \
    FIELD(vec4, oculus)       /* round opening above: center, radius; none if the radius is 0 */ \
    FIELD(vec2, windowZ)      /* z of the sill's inner edge and of the panes */ \
    FIELD(float, behindBars)  /* share of the panes that horizontal bars leave free; any lobe is higher than a bar */ \
    FIELD(int, uprightBars)   /* number of vertical bars */ \
    ARRAY(vec2, bars, MOST_UPRIGHT_BARS)             /* x and half width of each */ \
    ARRAY(uint, shapesAt, MIRROR_AZIMUTHS)           /* bit mask of shapes by azimuth from the eye: bit i: shape i */ \
    ARRAY(StandingShape, shapes, MOST_MIRRORED_SHAPES)  /* sorted from near to far */
BLOCK_STRUCT(FloorMirrorBlock, FLOOR_MIRROR_FIELDS)
