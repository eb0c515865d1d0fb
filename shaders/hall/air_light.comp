// Light of the sky in the air and, with BOUNCED_LIGHT, of the sun and, with LAMP_LIGHT, of the vault's lamps.
// Irradiance over pi on six sides of each point, the sides one behind the other. lib/light.glsl reads it for surfaces
// without lightmap.
#include "lib/bindings.glsl"
#include "hall/air_light_block.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(std140, binding = BLOCK_EXHIBIT) uniform AirLight {
    AirLightBlock air;
};

layout(binding = UNIT_SOURCE) uniform sampler2D sent;
#ifdef BOUNCED_LIGHT
layout(binding = UNIT_EXHIBIT_A) uniform sampler3D bounced;
#endif
#ifdef LAMP_LIGHT
layout(binding = UNIT_EXHIBIT_B) uniform sampler2D lampsSent;
#endif
layout(rgba16f, binding = 0) uniform writeonly image3D volume;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec3 size = air.size;
    if (any(greaterThanEqual(texel, ivec3(size.xy, 6 * size.z)))) return;
    int side = texel.z / size.z;
    int column = 6 * (((texel.z - side * size.z) * size.y + texel.y) * size.x + texel.x) + side;
    vec3 root;
    for (int c = 0; c < 3; ++c) root[c] = texelFetch(sent, ivec2(column, air.skyRow + c), 0).r;
    vec3 light = root * root * air.sky;
#ifdef BOUNCED_LIGHT
    light += texelFetch(bounced, texel, 0).rgb * air.sun;
#endif
#ifdef LAMP_LIGHT
    float lampRoot = texelFetch(lampsSent, ivec2(column, 0), 0).r;
    light += lampRoot * lampRoot * air.lamps;
#endif
    imageStore(volume, texel, vec4(light, 1.0));
}
