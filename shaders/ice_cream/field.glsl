// Current ice cream as a field for the kit's march. Its numbers are precomputed; the parameters that they were made
// from are in `parameters`, too, but not used here. Permutation: SPRINKLES.
#include "lib/bindings.glsl"
#include "ice_cream/ice_cream_block.glsl"
#include "lib/numerics.glsl"
#include "lib/sdf.glsl"
#include "lib/sdf_operators.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Shape {
    IceCreamShape shape;
};

int solids = 0;
float levelHere = 0.0;
float unlisted = 0.0;

#ifdef SPRINKLES
layout(binding = UNIT_BUFFER_A) uniform usamplerBuffer sprinkleCells;  // first and end of the list; clear distance
layout(binding = UNIT_BUFFER_B) uniform samplerBuffer sprinkleEnds;
float sprinkleClear(int cell) { return uintBitsToFloat(texelFetch(sprinkleCells, cell).z); }
int sprinkleFirst(int cell) { return int(texelFetch(sprinkleCells, cell).x); }
int sprinkleEnd(int cell) { return int(texelFetch(sprinkleCells, cell).y); }
vec4 sprinkleStart(int i) { return texelFetch(sprinkleEnds, 2 * i); }
vec4 sprinkleFinish(int i) { return texelFetch(sprinkleEnds, 2 * i + 1); }
#else
float sprinkleClear(int cell) { return 1.0e9; }
int sprinkleFirst(int cell) { return 0; }
int sprinkleEnd(int cell) { return 0; }
vec4 sprinkleStart(int i) { return vec4(0.0); }
vec4 sprinkleFinish(int i) { return vec4(0.0); }
#endif

#include "ice_cream/solids.glsl"

// Normals, occlusion and soft shadows use the level: the distance bound has creases where the shape has none.
#define FIELD_LEVEL iceCreamLevel
#define FIELD_CLEARANCE(d) levelHere

float fieldDistance(vec3 p)
{
    return iceCreamDistance(p);
}
