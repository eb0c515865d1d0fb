// Bounced sunlight in the air: the sum of all sources on six sides of each point. The sides lie one behind the other,
// each with all points. Irradiance over pi, for a sun of irradiance 1: rgb with color, a without.
#include "lib/bindings.glsl"
#include "hall/bounce_block.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(std140, binding = BLOCK_EXHIBIT) uniform Bounce {
    BounceBlock bounce;
};

layout(binding = UNIT_SOURCE) uniform sampler2D sent;
layout(rgba16f, binding = 0) uniform writeonly image3D volume;

float squared(float x)
{
    return x * x;
}

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec3 size = bounce.size;
    if (any(greaterThanEqual(texel, ivec3(size.xy, 6 * size.z)))) return;
    int side = texel.z / size.z;
    int column = 6 * (((texel.z - side * size.z) * size.y + texel.y) * size.x + texel.x) + side;
    float sum = 0.0;
    for (int i = 0; i < min(bounce.sources, MOST_BOUNCE_SOURCES); ++i)
        sum += squared(texelFetch(sent, ivec2(column, int(bounce.shining[i].x)), 0).r) * bounce.shining[i].y;
    vec3 tint;
    for (int c = 0; c < 3; ++c) tint[c] = squared(texelFetch(sent, ivec2(column, bounce.tintRow + c), 0).r);
    imageStore(volume, texel, vec4(tint * bounce.tintScale * sum, sum));
}
