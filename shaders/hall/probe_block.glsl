// Blocks of the reflection probe. GLSL and C++: render/glsl/std140.h.

// One filtering step from the probe's captured cube map to a mip level that surfaces read.
#define PROBE_LEVEL_FIELDS(FIELD, ARRAY) \
    FIELD(float, roughness)     /* perceptual, 0 to 1 */ \
    FIELD(int, samples)         /* number of directions in the lobe */ \
    FIELD(int, capturedLevel)   /* mip level of the captured cube to read */ \
    FIELD(int, capturedSize)    /* width of that level's faces, texels */
BLOCK_STRUCT(ProbeLevel, PROBE_LEVEL_FIELDS)

// A work behind an opening in the wall.
#define PROBE_WORK_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromBox)      /* a box from -1 to 1 that covers the opening */ \
    FIELD(mat4, pictureFromWorld)  /* to clip space of the work's picture */
BLOCK_STRUCT(ProbeWork, PROBE_WORK_FIELDS)
