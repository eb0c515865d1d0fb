// Glare: light that eye or lens scatters around bright places. GLSL and C++: render/glsl/std140.h.
#define GLARE_DIVISOR 4  // A texel of the widest image covers this many pixels of the picture along each side.
#define GLARE_FIELDS(FIELD, ARRAY) \
    FIELD(float, share) /* share of the light that each level scatters */ \
    FIELD(int, levels) \
    FIELD(vec2, offset) /* lower left corner of what is drawn, in pixels of the whole picture */ \
    FIELD(vec2, scale)  /* position in the image of halos for each pixel of the whole picture */
BLOCK_STRUCT(GlareBlock, GLARE_FIELDS)
