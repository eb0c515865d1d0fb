// Ray marches the sunbeams in dusty air, in half or full resolution. Every ray is marched where it crosses a beam of
// window or oculus, with lookups in the shadow maps. The light that a step scatters equals the light that its dust
// removes from the ray, in closed form. So the result does not depend on the number of steps.
#define COPY_BLOCKS
#include "lib/light.glsl"
#include "crepuscular_rays/participating_media.glsl"
#include "crepuscular_rays/gather.glsl"
#include "crepuscular_rays/coarse.glsl"
#include "crepuscular_rays/dust.glsl"

layout(location = 0) out vec4 scattered;

float sunInAir(vec3 world)
{
    float lit = light.hallCastsShadow ? shadowMapLight(hallShadow, shadowPosition(light.hallShadowFromWorld, world)) : 1.0;
    if (light.exhibitsCastShadow && lit > 0.0) lit *= shadowMapLight(exhibitShadow, shadowPosition(light.exhibitShadowFromWorld, world));
    return lit;
}

void main()
{
    vec2 cell = cellOf(gl_FragCoord.xy);
    float depth = coarseDepth(cell);
    vec3 ray = frameRay((cell + 0.5) * rays.cellSize - frameTile());
    float stretch = length(ray);
    vec3 direction = ray / stretch;
    vec3 eye = frame.eye;
    vec2 air = airStretch(eye, direction);
    float end = depth * stretch;
    float shift = grainAt(cell);
    float sum = 0.0;
    vec2 before = vec2(1.0, -1.0);
    for (int b = 0; b < rays.beamCount; ++b) {
        BeamBlock beam = rays.beams[b];
        vec3 along = light.sunDirection / light.sunDirection[beam.axis];
        vec2 inside = airBeam(eye, direction, beam.openingLow, beam.openingHigh, beam.axis, beam.plane, along, beam.airLow, beam.airHigh);
        float first = max(inside.x, 0.0);
        float path = min(inside.y, end) - first;
        if (!(path > 0.0)) continue;
        float stride = path / float(parameters.volumeSteps);
        float through = airThrough(eye, direction, air, first);
        for (int i = 0; i < parameters.volumeSteps; ++i) {
            float at = first + (float(i) + 0.5 + shift) * stride;
            float throughEnd = airThrough(eye, direction, air, first + float(i + 1) * stride);
            // In the overlap of two beams, only the first counts.
            if (at < before.x || at > before.y) {
                vec3 world = eye + direction * at;
                float lit = sunInAir(world);
                if (lit > 0.0) sum += lit * airScattered(through, throughEnd) * dustDrift(world);
            }
            through = throughEnd;
        }
        before = vec2(first, first + path);
    }
    float phase = airPhase(dot(direction, light.sunDirection), parameters.anisotropy);
    scattered = vec4(min(parameters.airColor * light.sunIrradiance * (sum * phase * parameters.beamStrength), vec3(6e4)), depth);
}
