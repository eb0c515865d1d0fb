// The light block as flat varyings, for passes of few vertices: software renderers read each number of a block pixel by
// pixel. Permutation: FLAT_LIGHT_OUT, in the vertex shader.
#include "lib/light_block.glsl"

#ifdef FLAT_LIGHT_OUT
#define FLAT_LIGHT_DIRECTION out
#else
#define FLAT_LIGHT_DIRECTION in
#endif
#define FLAT_FIELD(type, name) flat type name;
#define FLAT_ARRAY(type, name, count) flat type name[count];
#define bool int  // No varying is a bool.
FLAT_LIGHT_DIRECTION FlatLight {
    LIGHT_FIELDS(FLAT_FIELD, FLAT_ARRAY)
} flatLight;
#undef bool
