// State of earlier frames for a pass. GLSL and C++: render/glsl/std140.h.
#define TEMPORAL_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, previousClipFromWorld)  /* that of the frame that drew the histories, without its jitter */ \
    FIELD(bool, isValid)                /* everything that the pass reads of earlier frames is usable */ \
    FIELD(int, slice)                   /* slice of a sliced pass, from 0 */ \
    FIELD(int, sliceCount)
BLOCK_STRUCT(TemporalBlock, TEMPORAL_FIELDS)
