// One of the passes with geometric spacing: taps at ratios 1, r, r^2 ... of the way to the sun. The next pass reads
// what this one wrote, with its ratio raised to the number of taps, so that taps^passes samples are gathered by
// taps times passes looks.
#include "crepuscular_rays/gather.glsl"
#include "crepuscular_rays/coarse.glsl"

layout(location = 0) out vec4 gathered;

void main()
{
    vec2 cell = cellOf(gl_FragCoord.xy);
    vec2 from = (floor(gl_FragCoord.xy) + 0.5 + (rays.taps.z > 0.5 ? rays.grid.yz : vec2(0.0))) * (rays.taps.z > 0.5 ? rays.grid.x * rays.grid.w : 1.0);
    vec2 source = rays.taps.z > 0.5 ? rays.source.xy : rays.source.xy / (rays.grid.x * rays.grid.w) - rays.grid.yz;
    // The first pass looks into the middle of each step's weight.
    float ratio = rays.taps.y;
    float t = rays.taps.z > 0.5 ? shaftTapPlace(ratio, rays.source.z, 0.5 + grainAt(cell)) : 1.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < int(rays.taps.x); ++i) {
        sum += maskAt(source + (from - source) * t) * shaftTapWeight(float(i), rays.taps.x, ratio, rays.source.z);
        t *= ratio;
    }
    gathered = vec4(sum, coarseDepth(cell));
}
