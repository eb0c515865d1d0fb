// A polished floor at y = 0 with objects on it: POLISHED_FLOOR of kit/surface.frag. Permutations: CONTACT_SHADOWS,
// MIRROR_SHAPES, MIRROR_PICTURE (with MIRROR_SHAPES: of what the picture shows, too).
#include "lib/floor_reflection.glsl"
#include "kit/floor_block.glsl"
#ifdef MIRROR_SHAPES
#include "lib/sky.glsl"
#endif
#ifdef MIRROR_PICTURE
#include "kit/blur_level.glsl"

layout(binding = UNIT_BACKDROP) uniform sampler2D mirroredPicture;
layout(binding = UNIT_BACKDROP_DEPTH) uniform sampler2D mirroredWay;
#endif

layout(std140, binding = BLOCK_EXHIBIT) uniform FloorMirror {
    FloorMirrorBlock floorMirror;
};

#ifdef CONTACT_SHADOWS
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D contactMap;

// Share of the ambient light that reaches a point of the floor past the objects around it.
float contactLight(vec3 position)
{
    vec4 area = floorMirror.mapArea;
    vec2 place = (vec2(position.x, position.z) - area.xy) / (area.zw - area.xy);
    return textureLod(contactMap, place, 0.0).r;
}
#endif

#ifdef MIRROR_SHAPES
// Share of the lobe that meets a vertical bar of the window.
float windowBars(MirroredWindow window)
{
    float bars = 0.0;
    for (int i = 0; i < floorMirror.uprightBars; ++i)
        bars += mirroredBar(floorMirror.bars[i], window.place.x, window.width.x);
    return clamp(bars, 0.0, 1.0);
}

// Part of the lobe that all shapes take up, weighted by their shares; near shapes hide far ones.
struct MirroredShapes {
    float share;
    // sums over the shapes, each value multiplied by the shape's share
    float ahead;
    vec2 outwards;
    vec3 color;
};

// A ray that the floor reflects stays in the vertical plane through the eye. So it can only hit shapes that the eye has
// in this direction. A loop over these is used, not a test for each: llvmpipe executes both sides of an `if` for every
// pixel, but leaves a loop when no pixel of a group needs it.
MirroredShapes mirroredShapes(MirrorLobe lobe)
{
    MirroredShapes all = MirroredShapes(0.0, 0.0, vec2(0.0), vec3(0.0));
    int azimuth = clamp(int(azimuthTurn(lobe.ahead) * float(MIRROR_AZIMUTHS)), 0, MIRROR_AZIMUTHS - 1);
    for (uint left = floorMirror.shapesAt[azimuth]; left != 0u; left &= left - 1u) {
        int i = max(findLSB(left), 0);
        MirroredShape met = mirroredShape(floorMirror.shapes[i], lobe);
        float share = met.share * (1.0 - all.share);
        all.share += share;
        all.ahead += met.ahead * share;
        all.outwards += met.outwards * share;
        all.color += floorMirror.shapes[i].color * share;
    }
    return all;
}

// Radiance of the shapes times their share. They are assumed to be lit like the floor in front of them.
vec3 shapesRadiance(MirroredShapes all, MirrorLobe lobe, Surface s, vec3 roomAmbient)
{
    vec3 normal = safeNormalize(vec3(all.outwards.x, 0.0, all.outwards.y), vec3(0.0, 1.0, 0.0));
    vec3 here = s.ambient / max(roomAmbient, vec3(1e-4));
    vec3 lit = probeAmbient(normal) * clamp(here, 0.1, 2.0);
    float towardsSun = dot(normal, light.sunDirection);
    if (towardsSun > 0.0) {
        float ahead = all.ahead / all.share;
        vec3 place = vec3(lobe.place + lobe.ahead * ahead, lobe.rise * ahead).xzy;
        place += normal * (2.0 * light.hallShadowTexel);
        float visible = 1.0;
        if (light.hallCastsShadow)
            visible = shadowMapLight(hallShadow, shadowPosition(light.hallShadowFromWorld, place));
        lit += light.sunIrradiance * (visible * towardsSun / PI);
    }
    return all.color * lit;
}

// Radiance that the floor reflects: the shapes, in front of window and oculus, in front of the room as captured by the
// probe.
vec3 floorMirrored(Surface s, vec3 toEye, vec3 roomAmbient)
{
    vec3 mirrored = vec3(-toEye.x, max(toEye.y, 1e-3), -toEye.z);
    float perMeter = inversesqrt(max(dot(mirrored.xz, mirrored.xz), 1e-8));
    MirrorLobe lobe =
        MirrorLobe(s.position.xz, mirrored.xz * perMeter, mirrored.y * perMeter, 2.0 * s.roughness * s.roughness);

    // Shapes and window have exact edges; the probe supplies only the soft colors of the room.
    vec3 radiance = probeRadiance(s.position, mirrored, 0.5 * s.roughness) * s.occlusion;
    MirroredWindow window = mirroredWindow(floorMirror.window, floorMirror.windowZ, lobe);
    float oculus = mirroredOculus(floorMirror.oculus, lobe);
    vec3 sky = blurredSkyRadiance(mirrored, lobe.slope);
    radiance = mix(radiance, sky * (floorMirror.behindBars * (1.0 - windowBars(window))), window.share);
    radiance = mix(radiance, sky, oculus);
    MirroredShapes shapes = mirroredShapes(lobe);
    if (shapes.share > 2e-3)
        radiance = radiance * (1.0 - min(shapes.share, 1.0)) + shapesRadiance(shapes, lobe, s, roomAmbient);
    return radiance;
}
#endif

#ifdef MIRROR_PICTURE
// Radiance that the floor reflects of what the picture shows (kit/mirrored.frag), blurred as far as the lobe spreads;
// `otherwise` where the picture shows nothing.
vec3 floorMirroredPicture(Surface s, vec3 otherwise)
{
    const float wide = 4.0;  // Mip level at which the way is read: its mean varies smoothly.
    vec2 at = gl_FragCoord.xy / vec2(textureSize(mirroredPicture, 0));
    float coverage = textureLod(mirroredPicture, at, wide).a;
    float way = textureLod(mirroredWay, at, wide).r / max(coverage, 1e-4);
    vec4 shown = textureLod(mirroredPicture, at, blurLevel(way, 2.0 * s.roughness * s.roughness));
    return otherwise * (1.0 - shown.a) + shown.rgb;
}
#endif

// Radiance towards the eye. `roomAmbient`: irradiance over pi of the probe for the floor's normal. Distant, dim light
// is reflected as by polish. The sun's highlight uses a higher roughness, because it would otherwise saturate.
vec3 shadeFloor(Surface s, vec3 toEye, vec3 roomAmbient)
{
    Surface worn = s;
    worn.roughness = max(s.roughness, 0.45);
#ifdef MIRROR_SHAPES
    vec3 mirrored = floorMirrored(s, toEye, roomAmbient);
#ifdef MIRROR_PICTURE
    mirrored = floorMirroredPicture(s, mirrored);
#endif
#else
    vec3 mirrored = probeRadiance(s.position, reflect(-toEye, s.normal), s.roughness) * s.occlusion;
#endif
    vec3 scattered = shadeWithoutReflection(worn, toEye, sunVisibility(s.position, s.normal));
    return scattered + reflectance(s, toEye) * mirrored;
}
