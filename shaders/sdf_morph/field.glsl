// The torus-mug of this moment as a field for the kit's march. Its shape comes ready made: the rows of the table that it
// was made of are in `parameters`, too, and nothing here reads them.
#include "lib/bindings.glsl"
#include "sdf_morph/torus_mug.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Shape {
    TorusMugShape shape;
};

float fieldDistance(vec3 p)
{
    return sdfTorusMug(p, shape);
}
