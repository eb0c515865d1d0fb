// Makes the next mip level of a picture or, with CUBE, of all faces of a cube map: the mean of four texels each. Both
// sides of the larger level are even.
layout(local_size_x = 8, local_size_y = 8) in;

#ifdef CUBE
#define LEVEL imageCube
#define TEXEL(xy) ivec3(xy, gl_GlobalInvocationID.z)
#else
#define LEVEL image2D
#define TEXEL(xy) (xy)
#endif

layout(rgba16f, binding = 0) uniform readonly LEVEL larger;
layout(rgba16f, binding = 1) uniform writeonly LEVEL smaller;

void main()
{
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(smaller).xy))) return;
    ivec2 at = 2 * texel;
    vec4 sum = imageLoad(larger, TEXEL(at)) + imageLoad(larger, TEXEL(at + ivec2(1, 0))) +
               imageLoad(larger, TEXEL(at + ivec2(0, 1))) + imageLoad(larger, TEXEL(at + ivec2(1, 1)));
    imageStore(smaller, TEXEL(texel), 0.25 * sum);
}
