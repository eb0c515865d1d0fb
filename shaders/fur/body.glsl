// Data of one body and its coat.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"
#include "lib/hash.glsl"
#include "fur/strand.glsl"
#include "fur/body_block.glsl"

// Height of shell `i` before `distanceAttenuation`. The outermost shell is 0, the skin the last one.
float shellHeight(float i, float count)
{
    return count > 1.0 ? max(1.0 - i / (count - 1.0), 0.0) : 0.0;
}
