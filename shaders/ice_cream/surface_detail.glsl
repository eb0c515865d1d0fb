// Details of the surface that are no shape: pores and toasted edges of the wafer, melted places of the cream. Only in
// the hall's light on opaque material; lengths in meters, in the body's own space.

int shadedPart = 0;  // Part whose material was asked for last: that of the surface being shaded.

bool isDetailed()
{
    return parameters.lighting == lighting_hall && parameters.material == material_opaque && shape.stage >= STAGE_COLORS;
}

bool isCream(int part)
{
    return part >= PART_CREAM && part < PART_CREAM + CREAM_LAYERS && isDetailed();
}

bool isWafer(int part)
{
    return part < PART_CREAM && isDetailed();
}

// Smooth noise of a few waves, -1 to 1, without repetition on the ice cream.
float softNoise(vec3 p)
{
    vec3 q = p + 0.6 * sin(p.yzx * 1.3 + vec3(0.3, 1.7, 2.9));
    return sin(q.x * 1.1 + 1.9 * sin(q.z * 0.7)) * 0.5 + sin(q.y * 1.3 + 1.3 * sin(q.x * 0.9 + 2.0)) * sin(q.z * 1.2 + 0.7) * 0.5;
}

// Pores of a wafer: depth 0 to 1 and its slope, from the nearest of the holes of two sizes in cells of a lattice.
vec4 waferPores(vec3 p)
{
    vec4 pores = vec4(0.0);
    float cell = 0.017;
    for (int octave = 0; octave < 2; ++octave) {
        vec3 q = p / cell;
        vec3 base = floor(q);
        uvec3 bits = pcg3d(uvec3(ivec3(base) + ivec3(1024)));
        vec3 center = 0.5 + 0.36 * (vec3(bits & 65535u) * (2.0 / 65535.0) - 1.0);
        float radius = 0.14 + 0.34 * float(bits.x >> 16u) * (1.0 / 65535.0);
        vec3 off = q - base - center;
        float far = dot(off, off) / (radius * radius);
        float kept = bits.y >> 31u == 0u ? 1.0 : 0.0;
        float deep = max(1.0 - far, 0.0);
        pores += kept * vec4(off * (-4.0 * deep / radius), deep * deep);
        cell *= 0.45;
    }
    return pores;
}

// How much of the details of this size (meters) a pixel of this width still shows.
float shownDetail(float size, float pixel)
{
    return 1.0 - smoothStep(0.25 * size, size, pixel);
}

// Color of the wafer: darker and redder where it was hotter (ridges, rims, blotches), and in its pores.
vec3 bakedColor(vec3 p, int part)
{
    if (!isWafer(part)) return parameters.waferColor;
    float ridge = part == PART_RINGS || part == PART_BARS ? 0.85 : 0.0;
    float toRim = min(abs(p.y - shape.collar.z), abs(p.y - shape.collar.w));
    ridge = max(ridge, 0.9 * (1.0 - smoothStep(0.0, 0.018, toRim)));
    float blotch = softNoise(p * 16.0) * 0.5 + softNoise(p * 43.0 + vec3(5.0)) * 0.3;
    float heat = clamp(ridge * 0.75 + 0.35 + 0.6 * blotch, 0.0, 1.2) * parameters.toast;
    float pixel = frame.pixelAngle * length((object.localFromWorld * vec4(frame.eye, 1.0)).xyz - p);
    float pores = waferPores(p).w * parameters.pores * shownDetail(0.012, pixel);
    return parameters.waferColor * exp(-vec3(0.65, 0.8, 1.1) * heat) * (1.0 - 0.55 * clamp(pores, 0.0, 1.0));
}

// Share of the cream's surface at a point that has melted, 0 to 1: patches that run down, more of them near the wafer.
float meltedShare(vec3 p)
{
    if (!isDetailed()) return 0.0;
    float low = smoothStep(shape.bowl.w + 0.35, shape.bowl.w, p.y);
    float patches = 0.5 + 0.5 * softNoise(p * vec3(19.0, 8.0, 19.0));
    return smoothStep(1.0 - parameters.melt, 1.35 - parameters.melt, 0.75 * patches + 0.35 * low) * min(4.0 * parameters.melt, 1.0);
}

// Normal for shading.
vec3 detailedNormal(vec3 p, vec3 n, float pixel)
{
    vec3 slope = vec3(0.0);
    if (isWafer(shadedPart)) slope = waferPores(p).xyz * (0.22 * parameters.pores * shownDetail(0.012, pixel));
    return normalize(n - slope + n * dot(n, slope));
}

// A niche gets the room's light from the front only; its walls reflect some of it.
float nicheLight(vec3 n)
{
    if (!isDetailed() || parameters.backdrop <= 0.0) return 1.0;
    return mix(0.15, 0.7, smoothStep(-0.6, 1.0, dot(n, shape.towardsHall)));
}

#define FIELD_BUMP detailedNormal
#define FIELD_AMBIENT nicheLight
