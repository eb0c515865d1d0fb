// Bakes one octave of the field's noise into a periodic volume texture.
#include "lib/noise_sums.glsl"
#include "lib/bindings.glsl"
#include "noise/noise_block.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(r16f, binding = 0) uniform writeonly image3D baked;

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    vec3 p = (vec3(texel) + 0.5) / float(FIELD_TEXELS);
    float value = noiseNear(FIELD_KIND, p, ivec3(0), vec3(0.0), ivec3(FIELD_REPEAT), uint(parameters.seed)).value;
    imageStore(baked, texel, vec4(value, 0.0, 0.0, 0.0));
}
