// Shades the lenticular card in the hall: the print through its lenses under a glossy surface; transparent edges, a
// white back. Permutations: those of print.glsl, ANAGLYPH, WRITE_NORMAL, COUNT (writes the number of rays traced
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

// Shades edges and back: a slab of plastic with white paper behind it.
vec3 slabColor(vec3 world, vec3 normal, vec3 worldToEye)
{
    Surface s;
    s.position = world;
    s.normal = normal;
    bool back = cardNormal.z < -0.5;
    s.baseColor = back ? vec3(0.80, 0.79, 0.77) : vec3(0.62, 0.66, 0.65);
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
    if (cardNormal.z < 0.999 || eye.z <= 0.0) {
#ifndef COUNT
        color = slabColor(world, worldNormal, normalize(frame.eye - world));
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
#ifndef COUNT
        world = (object.worldFromCard * vec4(p.place, 0.0, 1.0)).xyz;
        vec3 toEye = normalize(eye - vec3(p.place, 0.0));
        float visibility = sunVisibility(world, worldNormal);
        vec4 mirrored = gloss(p.place, toEye, p.stepX, p.stepY, visibility, world);
        // The paper under the plastic scatters the light that reaches it.
        float cosL = max(dot(worldNormal, light.sunDirection), 0.0);
        float into = 1.0 - fresnelDielectric(cosL, object.prints[0].index.g);
        vec3 falls = ambientAt(world, worldNormal) + light.sunIrradiance * sunThroughGlass(world) * (cosL * visibility * into / PI);
        vec3 toLamp = normalize(LAMP - vec3(p.place, 0.0));
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
}
