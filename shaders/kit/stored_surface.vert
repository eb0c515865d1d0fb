// One triangle that covers the target, for lighting stored surfaces (kit/stored_surface.glsl).
#define FLAT_LIGHT_OUT
#include "lib/light_uniform.glsl"

void main()
{
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
    passLight();
}
