// One filtering step from the probe's captured cube map to a mip level that surfaces read. GLSL and C++:
// render/glsl/std140.h.
#define PROBE_LEVEL_FIELDS(FIELD, ARRAY) \
    FIELD(float, roughness)     /* perceptual, 0 to 1 */ \
    FIELD(int, samples)         /* number of directions in the lobe */ \
    FIELD(int, capturedLevel)   /* mip level of the captured cube to read */ \
    FIELD(int, capturedSize)    /* width of that level's faces, texels */
BLOCK_STRUCT(ProbeLevel, PROBE_LEVEL_FIELDS)
