// Built-in volume of visitors' shaders: a random number in each texel and channel, or with GRAY in red only.
#include "lib/hash.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(rgba8, binding = 0) uniform writeonly image3D volume;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, imageSize(volume)))) return;
    uvec4 bits = pcg4d(uvec4(texel, 42));
    vec4 value = vec4(bits >> 24u) / 255.0;
#ifdef GRAY
    value = vec4(value.r, 0.0, 0.0, 1.0);
#endif
    imageStore(volume, texel, value);
}
