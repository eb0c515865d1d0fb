// One triangle at the far plane that covers the target, for lighting stored surfaces (kit/stored_surface.glsl).
#include "lib/bindings.glsl"
#define FLAT_LIGHT_OUT
#include "lib/flat_light.glsl"

layout(std140, binding = BLOCK_LIGHT) uniform Light {
    LightBlock light;
};

void main()
{
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
#define bool int
#define PASS_FIELD(type, name) flatLight.name = type(light.name);
#define PASS_ARRAY(type, name, count) flatLight.name = light.name;
    LIGHT_FIELDS(PASS_FIELD, PASS_ARRAY)
#undef bool
}
