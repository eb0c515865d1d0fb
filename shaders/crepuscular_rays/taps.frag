// One of the passes with geometric spacing: taps at ratios 1, r, r^2 ... of the way to the sun. The next pass reads the
// result of this one, with the ratio raised to the number of taps. So taps^passes samples need only taps times passes
// lookups.
#include "crepuscular_rays/gather.glsl"
#include "crepuscular_rays/coarse.glsl"

layout(location = 0) out vec4 gathered;

void main()
{
    vec2 cell = cellOf(gl_FragCoord.xy);
    vec2 from = (floor(gl_FragCoord.xy) + 0.5 + (rays.isFirstPass ? rays.firstCell : vec2(0.0))) * (rays.isFirstPass ? rays.cellSize * rays.maskScale : 1.0);
    vec2 source = rays.isFirstPass ? rays.sun : rays.sun / (rays.cellSize * rays.maskScale) - rays.firstCell;
    // The first pass samples the middle of each step's weight.
    float ratio = rays.ratio;
    float t = rays.isFirstPass ? shaftTapPlace(ratio, rays.exponent, 0.5 + grainAt(cell)) : 1.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < rays.samples; ++i) {
        sum += maskAt(source + (from - source) * t) * shaftTapWeight(float(i), float(rays.samples), ratio, rays.exponent);
        t *= ratio;
    }
    gathered = vec4(sum, coarseDepth(cell));
}
