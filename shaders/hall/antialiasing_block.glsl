// Constants of temporal antialiasing. GLSL and C++: render/glsl/std140.h.
#define ANTIALIASING_FIELDS(FIELD, ARRAY) \
    FIELD(float, frames)        /* most frames that a pixel is the mean of; keep_history.frag: their number */
BLOCK_STRUCT(AntialiasingBlock, ANTIALIASING_FIELDS)
