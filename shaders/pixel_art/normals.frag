// Computes surfaces with normals by the methods of both halves of the picture. Permutations: LEFT_METHOD and
// RIGHT_METHOD, values of the parameter `method`.
#include "pixel_art/picture.glsl"
#include "pixel_art/surface.glsl"

layout(binding = UNIT_NORMAL) uniform sampler2D trueNormals;
layout(location = 0) out vec4 surfaceOut;

vec3 normalBy(int method, DepthLens lens, ivec2 p, vec3 drawn)
{
    if (method == method_true) return drawn;
    if (method == method_3Tap) return normal3Tap(lens, p);
    if (method == method_4Tap) return normal4Tap(lens, p);
    if (method == method_5Tap) return normal5Tap(lens, p);
    if (method == method_9Tap) return normal9Tap(lens, p);
    if (method == method_9PlusTap) return normal9TapPlus(lens, p);
    if (method == method_parabola) return normalCurved(lens, p);
    return normalVoted(lens, p);
}

void main()
{
    DepthLens lens = pictureLens();
    ivec2 p = ivec2(gl_FragCoord.xy);
    float depth = depthAt(p);
    vec4 drawn = texelFetch(trueNormals, p, 0);
#if LEFT_METHOD == RIGHT_METHOD
    vec3 n = normalBy(LEFT_METHOD, lens, p, drawn.xyz);
#else
    vec3 n = p.x < pixel.divider ? normalBy(LEFT_METHOD, lens, p, drawn.xyz) : normalBy(RIGHT_METHOD, lens, p, drawn.xyz);
#endif
    bool sky = isSky(lens, depth);
    surfaceOut = packedSurface(sky ? vec3(0.0, 0.0, parameters.fixVoid ? 1.0 : 0.0) : n, sky ? 0.0 : drawn.a, depth);
}
