// The light block as flat varyings, for passes of few vertices: software renderers read each number of a block pixel by
// pixel. FLAT_LIGHT is `in` or `out`.
#include "lib/light_block.glsl"

#define FLAT_FIELD(type, name) flat type name;
#define FLAT_ARRAY(type, name, count) flat type name[count];
#define bool int  // No varying is a bool.
FLAT_LIGHT FlatLight {
    LIGHT_FIELDS(FLAT_FIELD, FLAT_ARRAY)
} flatLight;
#undef bool
