// Current shape of the torus-mug as a field for the kit's march. The shape is precomputed; the parameters that it was
// made from are in `parameters`, too, but not used here.
#include "lib/bindings.glsl"
#include "sdf_morph/torus_mug.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Shape {
    TorusMugShape shape;
};

float fieldDistance(vec3 p)
{
    return sdfTorusMug(p, shape);
}
