// Reflection on the plastic surface. The slopes of the lenses spread it across them; ribs, noise stretched along the
// lenses, break it into streaks.
#include "lib/surface.glsl"
#include "lib/hash.glsl"

// Smooth noise between -1 and 1 on a lattice, with its gradient: x: value, yz: gradient.
vec3 latticeNoise(vec2 p, uint seed)
{
    vec2 cell = floor(p);
    vec2 f = p - cell;
    vec2 u = f * f * (3.0 - 2.0 * f);
    vec2 du = 6.0 * f * (1.0 - f);
    ivec2 c = ivec2(cell);
    float a = unitFromBits(hashCell(ivec3(c, 0), seed).x) * 2.0 - 1.0;
    float b = unitFromBits(hashCell(ivec3(c + ivec2(1, 0), 0), seed).x) * 2.0 - 1.0;
    float d = unitFromBits(hashCell(ivec3(c + ivec2(0, 1), 0), seed).x) * 2.0 - 1.0;
    float e = unitFromBits(hashCell(ivec3(c + ivec2(1, 1), 0), seed).x) * 2.0 - 1.0;
    float k = a - b - d + e;
    return vec3(a + (b - a) * u.x + (d - a) * u.y + k * u.x * u.y, du * vec2(b - a + k * u.y, d - a + k * u.x));
}

// Slopes of the ribs across and along the lenses. Octaves finer than the pixel fade out; z is their mean square slope.
vec3 ribs(vec2 place, vec2 pixel)
{
    vec2 slope = vec2(0.0);
    float faded = 0.0;
    float width = parameters.ribWidth;
    float height = 0.05;
    for (int octave = 0; octave < 3; ++octave) {
        vec2 size = vec2(width, width * parameters.ribStretch);
        float seen = 1.0 - smoothStep(0.4, 1.2, pixel.x / size.x);
        vec2 gradient = latticeNoise(place / size, 11u + uint(octave)).yz * vec2(1.0, 1.0 / parameters.ribStretch);
        slope += gradient * (height * seen);
        faded += height * height * (1.0 - seen * seen);
        width *= 0.41;
        height *= 0.7;
    }
    return vec3(slope * parameters.normalScale, faded * parameters.normalScale * parameters.normalScale);
}

// Radiance that the plastic reflects towards `toEye`, for light from direction `l` with this irradiance on a plane that
// faces it: the highlight of lib/surface.glsl with a width across the lenses and another along them.
vec3 highlight(Surface s, vec3 across, vec2 alpha, vec3 toEye, vec3 l, vec3 irradiance)
{
    float cosL = dot(s.normal, l);
    if (cosL <= 0.0) return vec3(0.0);
    vec3 h = safeNormalize(l + toEye, s.normal);
    vec3 t = safeNormalize(across - s.normal * dot(s.normal, across), across);
    mat3 local = mat3(t, cross(s.normal, t), s.normal);
    vec3 eye = toEye * local;
    eye.z = max(eye.z, 1.0e-3);
    float lobe = highlightLobe(max(alpha, vec2(0.0004)), h * local, l * local, eye);
    vec3 f = fresnelSchlick(surfaceF0(s), clamp(dot(toEye, h), 0.0, 1.0));
    return limitedHighlight(f * lobe) * irradiance * cosL;
}

// Irradiance of the lamp on a plane that faces it.
vec3 lampIrradiance(vec2 place)
{
    vec3 to = object.lamp - vec3(place, 0.0);
    return vec3(1.0, 0.90, 0.76) * (parameters.lamp * dot(object.lamp, object.lamp) / dot(to, to));
}

// Reflected light and, in w, its share of all light. `eye` is in the card's space.
vec4 gloss(vec2 place, vec3 eye, vec2 stepX, vec2 stepY, float visibility, vec3 worldPosition)
{
    CardPrintBlock print = object.prints[0];
    vec3 offset = eye - vec3(place, 0.0);
    vec3 toEye = normalize(offset);
    vec2 across = object.across;
    vec2 along = object.along;
    vec2 pixel = vec2(abs(dot(stepX, across)) + abs(dot(stepY, across)), abs(dot(stepX, along)) + abs(dot(stepY, along)));
    vec3 rib = ribs(vec2(dot(place, across), dot(place, along)), pixel);
    float lenses = dot(place, across) / print.pitch;
    float width = pixel.x / print.pitch;
    // From a distance, a quarter of the lens's slopes is sufficient: roughness accounts for the rest.
    float wide = min(width + (1.0 - width) * smoothStep(0.25, 0.5, width), 1.0);
    // A whole lens is always divided at the same places, or moire patterns with the pixels would appear.
    if (width >= 0.5) {
        wide = 1.0;
        lenses = 0.0;
    }
    int normals = wide < 0.2 ? 1 : clamp(parameters.glossSamples, 1, 32);
    LensShape s = lensShape(print, print.index.g, 0.0);
    mat3 worldFromCard = mat3(object.worldFromCard);
    mat3 normals3 = transpose(mat3(object.cardFromWorld));
    float own = parameters.roughness;
    // A wider highlight bridges the gap between two sampled slopes, and stands for ribs finer than a pixel. Both slope
    // across the lenses only, and so does what is added.
    float gap = 2.0 * parameters.lensGloss * lensSlope(s, 0.5) * wide / float(normals);
    float added = 0.5 * rib.z + 0.25 * gap * gap;
    // Along the lenses a narrow highlight is as wide as a pixel at least: the change of the half vector over the pixel.
    float turn = 0.5 * pixel.y * (1.0 / length(offset) + 1.0 / length(object.lamp - vec3(place, 0.0)));
    vec2 alpha = sqrt(own * own * own * own + vec2(added, turn * turn / 6.0));
    float roughness = clamp(sqrt(sqrt(alpha.x * alpha.y)), 0.03, 1.0);
    Surface surface;
    surface.position = worldPosition;
    surface.baseColor = vec3(0.0);
    surface.metalness = 0.0;
    surface.roughness = roughness;
    surface.specular = parameters.specular;
    surface.occlusion = 1.0;
    surface.ambient = vec3(0.0);
    vec3 toLamp = normalize(worldFromCard * normalize(object.lamp - vec3(place, 0.0)));
    vec3 lamp = lampIrradiance(place);
    vec3 sun = visibility > 0.0 ? light.sunIrradiance * sunThroughGlass(worldPosition) * visibility : vec3(0.0);
    vec3 worldAcross = normalize(worldFromCard * vec3(across, 0.0));
    vec3 sum = vec3(0.0);
    float mirrored = 0.0;
    float total = 0.0;
    float index = print.index.g;
    for (int i = 0; i < normals; ++i) {
        float x = lenses + ((float(i) + 0.5) / float(normals) - 0.5) * wide;
        x -= floor(x + 0.5);
        float slope = lensSlope(s, x) * parameters.lensGloss;
        vec2 tilt = across * (slope - rib.x) - along * rib.y;
        vec3 n = normalize(vec3(tilt, 1.0));
        float facing = dot(n, toEye);
        if (facing <= 1.0e-3) continue;
        float weight = facing / n.z;
        float f = min(fresnelDielectric(min(facing, 1.0), index) * 2.0 * parameters.specular, 1.0);
        surface.normal = normalize(normals3 * n);
        vec3 worldToEye = normalize(worldFromCard * toEye);
        vec3 direction = reflect(-worldToEye, surface.normal);
        sum += weight * (f * probeRadiance(worldPosition, direction, roughness) +
                         highlight(surface, worldAcross, alpha, worldToEye, light.sunDirection, sun) +
                         highlight(surface, worldAcross, alpha, worldToEye, toLamp, lamp));
        mirrored += weight * f;
        total += weight;
    }
    if (total <= 0.0) {
        vec3 n = normalize(normals3[2]);
        vec3 direction = reflect(-normalize(worldFromCard * toEye), n);
        return vec4(probeRadiance(worldPosition, direction, roughness) * min(2.0 * parameters.specular, 1.0), min(2.0 * parameters.specular, 1.0));
    }
    return vec4(sum, mirrored) / total;
}
