// Discards fragments that a model's alpha mask removes, so that they cast no shadow. Use it with pixel_art/shadow.vert
// and MASKED. Permutations: those of kit/material.glsl.
#include "pixel_art/object.glsl"
#include "kit/material.glsl"

in vec2 uvAt;

void main()
{
    float opacity = materialColor(uvAt).a;
    if (opacity < object.alphaCutoff) discard;
}
