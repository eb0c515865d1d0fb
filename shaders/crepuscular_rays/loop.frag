// Plain loop: one lookup in the mask per sample, from the pixel towards the sun. Permutations: PLAIN_SUM (that of the
// reference: no mean, exponential in the sample's number, ends at the edge of the picture).
#include "crepuscular_rays/gather.glsl"
#include "crepuscular_rays/coarse.glsl"

layout(location = 0) out vec4 gathered;

void main()
{
    vec2 cell = cellOf(gl_FragCoord.xy);
    vec2 from = maskPixel(cell);
    vec2 path = from - rays.sun;
    float shift = grainAt(cell);
    int samples = rays.samples;
    vec3 sum = vec3(0.0);
#ifdef PLAIN_SUM
    float share = 1.0;
    for (int i = 0; i < samples; ++i) {
        sum += maskAt(rays.sun + path * (1.0 - rays.gathered * (float(i) + shift + (rays.shiftSamples ? 0.5 : 0.0)) / float(samples))) * share;
        share *= rays.ratio;
    }
#else
    for (int i = 0; i < samples; ++i) {
        float t = shaftStep(float(i), float(samples), rays.gathered, shift);
        sum += maskAt(rays.sun + path * t) * shaftStepWeight(float(i), float(samples), rays.gathered, rays.exponent);
    }
#endif
    gathered = vec4(sum, coarseDepth(cell));
}
