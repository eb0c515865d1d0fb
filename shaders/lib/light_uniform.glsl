// The light block. With FLAT_LIGHT, for passes of few vertices on software renderers, it comes as flat varyings: a
// fragment shader of llvmpipe reads each number of a block pixel by pixel. The vertex shader then defines
// FLAT_LIGHT_OUT before it includes this, and calls passLight.
#include "lib/bindings.glsl"
#include "lib/light_block.glsl"

#if !defined(FLAT_LIGHT) || defined(FLAT_LIGHT_OUT)
layout(std140, binding = BLOCK_LIGHT) uniform Light {
    LightBlock light;
};
#endif

#ifdef FLAT_LIGHT
#ifdef FLAT_LIGHT_OUT
#define FLAT_LIGHT_DIRECTION out
#else
#define FLAT_LIGHT_DIRECTION in
#endif
#define FLAT_FIELD(type, name) flat type name;
#define FLAT_ARRAY(type, name, count) flat type name[count];
#define bool int  // No varying is a bool.
FLAT_LIGHT_DIRECTION FlatLight {
    LIGHT_FIELDS(FLAT_FIELD, FLAT_ARRAY)
} flatLight;

#ifdef FLAT_LIGHT_OUT
#define PASS_FIELD(type, name) flatLight.name = type(light.name);
#define PASS_ARRAY(type, name, count) flatLight.name = light.name;
void passLight()
{
    LIGHT_FIELDS(PASS_FIELD, PASS_ARRAY)
}
#undef bool
#else
#undef bool
#define TAKE_FIELD(type, name) all.name = type(flatLight.name);
#define TAKE_ARRAY(type, name, count) all.name = flatLight.name;
LightBlock passedLight()
{
    LightBlock all;
    LIGHT_FIELDS(TAKE_FIELD, TAKE_ARRAY)
    return all;
}
LightBlock light = passedLight();
#endif
#endif
