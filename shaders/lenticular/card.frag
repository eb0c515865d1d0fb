// Shades the lenticular card in the hall: the print through its lenses under a glossy surface; transparent edges, a
// labeled back. Permutations: those of print.glsl, ANAGLYPH, WRITE_NORMAL, COUNT (writes the number of rays traced
// instead of light).
#include "lib/frame.glsl"
#include "lenticular/card.glsl"
#include "lenticular/print.glsl"
#include "lenticular/gloss.glsl"

in vec3 cardPosition;
in vec3 cardNormal;

layout(location = 0) out vec4 radiance;
#ifdef WRITE_NORMAL
layout(location = 1) out vec4 normalOut;
#endif
#ifdef WRITE_ALBEDO
layout(location = WRITE_ALBEDO) out vec4 albedoOut;
#endif

// A pixel of the picture on the plane of the card's front: its center, and its change per pixel to the right and up.
// Computed from gl_FragCoord, so that adjacent tiles match bit by bit.
struct Patch {
    vec2 place, stepX, stepY;
};

Patch patchOf(vec3 eye)
{
    mat3 turn = mat3(object.cardFromWorld);
    vec3 d = turn * frameRay(gl_FragCoord.xy);
    vec3 dx = turn * (mat3(frame.worldFromView) * vec3(2.0 * frame.tanHalfFov.x * frame.inverseSize.x, 0.0, 0.0));
    vec3 dy = turn * (mat3(frame.worldFromView) * vec3(0.0, 2.0 * frame.tanHalfFov.y * frame.inverseSize.y, 0.0));
    float dz = min(d.z, -1.0e-5);
    float t = -eye.z / dz;
    Patch p;
    p.place = clamp(eye.xy + d.xy * t, -object.halfSize.xy, object.halfSize.xy);
    p.stepX = clamp(t * (dx.xy - d.xy * (dx.z / dz)), -1.0, 1.0);
    p.stepY = clamp(t * (dy.xy - d.xy * (dy.z / dz)), -1.0, 1.0);
    return p;
}

// Share of a pixel that lies within a rectangle: `p` from its middle, `halfSize` and the pixel's width in meters.
float within(vec2 p, vec2 halfSize, float pixel)
{
    vec2 inside = clamp((halfSize - abs(p)) / pixel + 0.5, 0.0, 1.0);
    return inside.x * inside.y;
}

// Color of the back at a place of it: hardboard with a wooden strip along its edge, and a paper label with lines of
// writing. `pixel` is the width of a pixel there, in meters; what is finer fades to its mean.
vec3 backColor(vec2 p, float pixel)
{
    float seen = 1.0 - smoothStep(0.0006, 0.003, pixel);
    float grain = latticeNoise(p * vec2(90.0, 900.0), 3u).x + latticeNoise(p * vec2(31.0, 310.0), 4u).x;
    vec3 board = vec3(0.20, 0.118, 0.062) * (1.0 + 0.16 * seen * grain);
    vec2 edge = object.halfSize.xy - vec2(0.022);
    vec3 strip = vec3(0.36, 0.235, 0.125) * (1.0 + 0.1 * seen * grain);
    vec3 color = mix(strip, board, within(p, edge, pixel));
    color *= 1.0 - 0.45 * within(p, edge + 0.003, pixel) * (1.0 - within(p, edge, pixel));
    vec2 label = p - vec2(0.0, 0.03);
    color = mix(color, vec3(0.70, 0.67, 0.58), within(label, vec2(0.085, 0.05), pixel));
    float ink = within(label - vec2(0.0, 0.03), vec2(0.055, 0.0055), pixel);
    for (int i = 0; i < 4; ++i) {
        float length = i == 3 ? 0.038 : 0.068 - 0.004 * float(i & 1);
        vec2 line = label + vec2(0.07 - length, 0.0145 * float(i) - 0.008);
        // Writing is a row of words: three quarters of its line are ink, its letters half of that.
        ink = max(ink, 0.55 * within(line, vec2(length, 0.0025), pixel));
    }
    return mix(color, vec3(0.05, 0.045, 0.04), ink);
}

// Color of edges and back.
vec3 slabColor(vec3 world)
{
    float pixel = 2.0 * frame.tanHalfFov.y * frame.inverseSize.y * length(frame.eye - world);
    return cardNormal.z < -0.5 ? backColor(cardPosition.xy, pixel) : vec3(0.62, 0.66, 0.65);
}

// Shades edges and back: a slab of plastic, mounted on a board.
vec3 slabLight(vec3 world, vec3 normal, vec3 worldToEye, vec3 base)
{
    Surface s;
    s.position = world;
    s.normal = normal;
    bool back = cardNormal.z < -0.5;
    s.baseColor = base;
    s.metalness = 0.0;
    s.roughness = back ? 0.6 : 0.16;
    s.specular = parameters.specular;
    s.occlusion = 1.0;
    s.ambient = ambientAt(world, normal);
    return shadeSurface(s, worldToEye);
}

void main()
{
    turnDisk(framePixel(gl_FragCoord.xy));
    vec3 world = (object.worldFromCard * vec4(cardPosition, 1.0)).xyz;
    vec3 worldNormal = normalize(transpose(mat3(object.cardFromWorld)) * normalize(cardNormal));
    vec3 eye = (object.cardFromWorld * vec4(frame.eye, 1.0)).xyz;
    vec3 color = vec3(0.0);
    vec3 base = vec3(0.0);  // Before any light; that of a print is what its lenses show.
    if (cardNormal.z < 0.999 || eye.z <= 0.0) {
#ifndef COUNT
        base = slabColor(world);
        color = slabLight(world, worldNormal, normalize(frame.eye - world), base);
#endif
    } else {
        Patch p = patchOf(eye);
#ifdef ANAGLYPH
        vec3 left = printedColor(p.place, object.leftEye, p.stepX, p.stepY);
        vec3 right = printedColor(p.place, object.rightEye, p.stepX, p.stepY);
        vec3 printed = vec3(dot(left, vec3(0.45, 0.5, 0.05)), right.gb);
#else
        vec3 printed = printedColor(p.place, object.leftEye, p.stepX, p.stepY);
#endif
        base = printed;
#ifndef COUNT
        world = (object.worldFromCard * vec4(p.place, 0.0, 1.0)).xyz;
        float visibility = sunVisibility(world, worldNormal);
        vec4 mirrored = gloss(p.place, eye, p.stepX, p.stepY, visibility, world);
        // The paper under the plastic scatters the light that reaches it.
        float cosL = max(dot(worldNormal, light.sunDirection), 0.0);
        float into = 1.0 - fresnelDielectric(cosL, object.prints[0].index.g);
        vec3 falls = ambientAt(world, worldNormal) + light.sunIrradiance * sunThroughGlass(world) * (cosL * visibility * into / PI);
        vec3 toLamp = normalize(object.lamp - vec3(p.place, 0.0));
        falls += lampIrradiance(p.place) * (toLamp.z * (1.0 - fresnelDielectric(toLamp.z, object.prints[0].index.g)) / PI);
        color = printed * falls * (1.0 - mirrored.a) + mirrored.rgb;
#endif
    }
#ifdef COUNT
    radiance = vec4(float(traces), 0.0, 0.0, 0.0);
#else
    radiance = vec4(color, 1.0);
#endif
#ifdef WRITE_NORMAL
    normalOut = vec4(worldNormal, 1.0);
#endif
#ifdef WRITE_ALBEDO
    albedoOut = vec4(base, 1.0);
#endif
}
