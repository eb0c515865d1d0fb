// The plain loop: one look at the mask per sample, from the pixel towards the sun. Permutations: PLAIN_SUM (the
// original's: no mean, exponential in the number of the sample, ends at the edge of the picture).
#include "crepuscular_rays/gather.glsl"
#include "crepuscular_rays/coarse.glsl"

layout(location = 0) out vec4 gathered;

void main()
{
    vec2 cell = cellOf(gl_FragCoord.xy);
    vec2 from = maskPixel(cell);
    vec2 way = from - rays.source.xy;
    float shift = grainAt(cell);
    int samples = int(rays.taps.x);
    vec3 sum = vec3(0.0);
#ifdef PLAIN_SUM
    float share = 1.0;
    for (int i = 0; i < samples; ++i) {
        sum += maskAt(rays.source.xy + way * (1.0 - rays.source.w * (float(i) + shift + 0.5 * rays.mask.w) / float(samples))) * share;
        share *= rays.taps.y;
    }
#else
    for (int i = 0; i < samples; ++i) {
        float t = shaftStep(float(i), float(samples), rays.source.w, shift);
        sum += maskAt(rays.source.xy + way * t) * shaftStepWeight(float(i), float(samples), rays.source.w, rays.source.z);
    }
#endif
    gathered = vec4(sum, coarseDepth(cell));
}
