// Computes nine spherical-harmonic coefficients of the irradiance over pi around the probe. Basis constants and cosine
// lobe are folded in, so that lib/light.glsl evaluates a plain polynomial of the normal. Ramamoorthi and Hanrahan 2001.
// One group of 64 threads reads one small mip level.
#include "lib/bindings.glsl"
#include "lib/cube.glsl"
#include "hall/probe_block.glsl"

layout(local_size_x = 64) in;

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    ProbeLevel object;
};

layout(binding = UNIT_SOURCE) uniform samplerCube captured;
layout(rgba32f, binding = 0) uniform writeonly image2D coefficients;

shared vec3 sums[64][9];
shared float weights[64];

void main()
{
    int me = int(gl_LocalInvocationIndex);
    int size = object.capturedSize;
    for (int k = 0; k < 9; ++k) sums[me][k] = vec3(0.0);
    float weight = 0.0;
    for (int i = me; i < 6 * size * size; i += 64) {
        int face = i / (size * size), rest = i % (size * size);
        vec3 d = cubeDirection(face, cubeTexel(vec2(float(rest % size), float(rest / size)), float(size)));
        float length2 = dot(d, d);
        float solidAngle = 1.0 / (length2 * sqrt(length2));
        vec3 n = d * inversesqrt(length2);
        vec3 radiance = textureLod(captured, n, float(object.capturedLevel)).rgb * solidAngle;
        sums[me][0] += radiance;
        sums[me][1] += radiance * n.y;
        sums[me][2] += radiance * n.z;
        sums[me][3] += radiance * n.x;
        sums[me][4] += radiance * (n.x * n.y);
        sums[me][5] += radiance * (n.y * n.z);
        sums[me][6] += radiance * (3.0 * n.z * n.z - 1.0);
        sums[me][7] += radiance * (n.x * n.z);
        sums[me][8] += radiance * (n.x * n.x - n.y * n.y);
        weight += solidAngle;
    }
    weights[me] = weight;
    barrier();
    if (me < 9) {
        vec3 total = vec3(0.0);
        float whole = 0.0;
        for (int i = 0; i < 64; ++i) {
            total += sums[i][me];
            whole += weights[i];
        }
        // Mean over the sphere times 4 pi Y² A_l / pi: 1; 2 for the linear terms; 15/4, 5/16 and 15/16 for the quadratic.
        float factor = me == 0 ? 1.0 : me < 4 ? 2.0 : me == 6 ? 5.0 / 16.0 : me == 8 ? 15.0 / 16.0 : 15.0 / 4.0;
        imageStore(coefficients, ivec2(me, 0), vec4(total / whole * factor, 1.0));
    }
}
