// A file that is included.
#include "include_tint.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = tint(fragCoord);
}
