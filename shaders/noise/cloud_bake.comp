// Bakes the clouds' noise into a periodic volume texture.
#include "lib/noise_sums.glsl"
#include "noise/cloud_noise.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(rg16f, binding = 0) uniform writeonly image3D baked;

void main()
{
    ivec3 size = imageSize(baked);
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 n = cloudNoiseAt((vec3(texel) + 0.5) / vec3(size), uint(parameters.seed), parameters.cloudOctaves);
    imageStore(baked, texel, vec4(n, 0.0, 0.0));
}
