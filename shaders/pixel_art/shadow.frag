// What a model's mask cuts out throws no shadow. After pixel_art/shadow.vert with MASKED. Permutations: those of
// kit/material.glsl.
#include "pixel_art/object.glsl"
#include "kit/material.glsl"

in vec2 uvAt;

void main()
{
    if (materialColor(uvAt).a < object.alphaCutoff) discard;
}
