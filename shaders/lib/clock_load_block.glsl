// Size of the known load for testing clocks. GLSL and C++: render/glsl/std140.h.
#define CLOCK_LOAD_FIELDS(FIELD, ARRAY) \
    FIELD(int, rounds)  /* per pixel */
BLOCK_STRUCT(ClockLoadBlock, CLOCK_LOAD_FIELDS)
