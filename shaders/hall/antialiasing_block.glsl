// Of a picture in motion. GLSL and C++: render/glsl/std140.h.
#define ANTIALIASING_FIELDS(FIELD, ARRAY) \
    FIELD(float, frames)        /* at most, that a pixel is the mean of; that it is, where one begins */
BLOCK_STRUCT(AntialiasingBlock, ANTIALIASING_FIELDS)
