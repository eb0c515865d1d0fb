// Makes the next mip level of a cube map, all faces at once: the mean of four texels each. Sizes are powers of two.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f, binding = 0) uniform readonly imageCube larger;
layout(rgba16f, binding = 1) uniform writeonly imageCube smaller;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel.xy, imageSize(smaller)))) return;
    ivec3 at = ivec3(2 * texel.xy, texel.z);
    vec4 sum = imageLoad(larger, at) + imageLoad(larger, at + ivec3(1, 0, 0)) + imageLoad(larger, at + ivec3(0, 1, 0)) +
               imageLoad(larger, at + ivec3(1, 1, 0));
    imageStore(smaller, texel, 0.25 * sum);
}
