// What a pass may know of the frames before. GLSL and C++: render/glsl/std140.h.
#define TEMPORAL_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, previousClipFromWorld)  /* of the frame that drew the histories, without its jitter */ \
    FIELD(bool, isValid)                /* all that the pass reads of the frames before can be used */ \
    FIELD(int, part)                    /* of work over several frames, from 0 */ \
    FIELD(int, parts)
BLOCK_STRUCT(TemporalBlock, TEMPORAL_FIELDS)
