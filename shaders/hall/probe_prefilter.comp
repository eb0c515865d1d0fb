// Computes one mip level of a reflection probe: the captured cube map convolved with a GGX lobe whose normal and view
// direction are the lookup direction (Karis 2013). Importance sampling reads the mip level whose texels are as wide as
// the distance between samples (Krivanek and Colbert 2008). Permutation: WORKS (with the works behind openings in the
// walls).
#include "lib/bindings.glsl"
#include "lib/cube.glsl"
#include "lib/hash.glsl"
#include "hall/probe_block.glsl"

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    ProbeLevel object;
};

layout(binding = UNIT_SOURCE) uniform samplerCube captured;
#ifdef WORKS
layout(binding = UNIT_EXHIBIT_A) uniform samplerCube works;
#endif
layout(rgba16f, binding = 0) uniform writeonly imageCube filtered;

const float PI = 3.14159265358979;

vec3 capturedRadiance(vec3 direction, float mip)
{
    vec3 radiance = textureLod(captured, direction, mip).rgb;
#ifdef WORKS
    vec4 work = textureLod(works, direction, mip);
    radiance = radiance * (1.0 - work.a) + work.rgb;
#endif
    return radiance;
}

void main()
{
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec2 size = imageSize(filtered);
    if (any(greaterThanEqual(texel.xy, size))) return;
    vec3 n = normalize(cubeDirection(texel.z, cubeTexel(vec2(texel.xy), float(size.x))));
    float roughness = object.roughness;
    int count = object.samples;
    if (roughness <= 0.0 || count <= 1) {
        imageStore(filtered, texel, vec4(capturedRadiance(n, 0.0), 1.0));
        return;
    }
    vec3 t = normalize(abs(n.y) < 0.99 ? cross(vec3(0.0, 1.0, 0.0), n) : cross(vec3(1.0, 0.0, 0.0), n));
    vec3 b = cross(n, t);
    float a = roughness * roughness;
    float turn = float(pcg(uint(texel.x + 251 * texel.y + 65521 * texel.z)) & 0xFFFFu) / 65536.0;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    float faceSize = float(object.capturedSize);
    float texelSolidAngle = 4.0 * PI / (6.0 * faceSize * faceSize);
    for (int i = 0; i < count; ++i) {
        float u = (float(i) + 0.5) / float(count);
        float phi = 2.0 * PI * fract(float(i) * 0.61803398875 + turn);
        float cosH = sqrt((1.0 - u) / (1.0 + (a * a - 1.0) * u));
        float sinH = sqrt(max(1.0 - cosH * cosH, 0.0));
        vec3 h = t * (sinH * cos(phi)) + b * (sinH * sin(phi)) + n * cosH;
        vec3 l = 2.0 * cosH * h - n;
        float cosL = dot(n, l);
        if (cosL <= 0.0) continue;
        float denominator = cosH * cosH * (a * a - 1.0) + 1.0;
        float density = a * a / (PI * denominator * denominator) * 0.25;
        float mip = max(0.5 * log2(1.0 / (float(count) * density * texelSolidAngle)) + 1.0, 0.0);
        sum += capturedRadiance(l, mip) * cosL;
        weights += cosL;
    }
    imageStore(filtered, texel, vec4(sum / max(weights, 1e-4), 1.0));
}
