// Covers the target, for lighting stored surfaces (kit/stored_surface.glsl).
#define FLAT_LIGHT_OUT
#include "lib/covering_triangle.glsl"
#include "lib/light_uniform.glsl"

void main()
{
    gl_Position = coveringPosition();
    passLight();
}
