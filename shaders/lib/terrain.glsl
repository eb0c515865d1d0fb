// Scenery outside the museum's window: a lawn, an avenue of old trees that opens towards the hills, roofs of a town.
#include "lib/hash.glsl"
#include "lib/light.glsl"

// Pseudo-random number in [0, 1) for cell `i` of a row.
float terrainRandom(int i, uint row)
{
    return unitFromBits(hashCell(ivec3(i, 0, 0), row).x);
}

// Value noise along a line, 0 to 1.
float terrainNoise(float x, uint row)
{
    float base = floor(x);
    float f = x - base;
    f = f * f * (3.0 - 2.0 * f);
    return mix(terrainRandom(int(base), row), terrainRandom(int(base) + 1, row), f);
}

// Share of a pixel that lies below an edge. `above`: height of the pixel above the edge; both in tangents of angles.
float terrainBelow(float above, float width)
{
    return clamp(0.5 - above / width, 0.0, 1.0);
}

// Height of the roofs: gables, some with a chimney, one cell each.
float terrainRoof(float x)
{
    float cell = floor(x * 50.0);
    float within = x * 50.0 - cell;
    float high = 0.008 + 0.012 * terrainRandom(int(cell), 11u);
    float gable = 1.0 - abs(2.0 * within - 1.0);
    bool chimney = terrainRandom(int(cell), 12u) > 0.6 && abs(within - 0.3) < 0.05;
    return high + 0.009 * gable + (chimney ? 0.006 : 0.0);
}

// Distance of (x, y) from the crowns of a row of trees, in tangents; negative inside. Crowns are disks with irregular
// rims, on trunks.
float terrainCrowns(vec2 p, float spacing, float size, uint row)
{
    int cell = int(floor(p.x / spacing));
    float nearest = 1.0;
    for (int i = cell - 2; i <= cell + 2; ++i) {
        float grown = 0.65 + 0.6 * terrainRandom(i, row);
        // Trees near the middle, where the avenue opens, are farther away.
        float x = (float(i) + 0.2 + 0.6 * terrainRandom(i, row + 1u)) * spacing;
        float open = clamp(abs(x) * 7.0 - 0.1, 0.15, 1.0);
        float radius = size * grown * open;
        vec2 d = p - vec2(x, radius * 1.15);
        float angle = angleOf(d.y, d.x);
        float rim = 1.0 + 0.16 * (terrainNoise(angle * 7.0 + 40.0 * float(i), row + 2u) - 0.5) +
                    0.07 * (terrainNoise(angle * 31.0 + 40.0 * float(i), row + 3u) - 0.5);
        float trunk = max(abs(d.x) - 0.07 * radius, d.y);
        nearest = min(nearest, min(length(d * vec2(1.0, 0.9)) - radius * rim, trunk));
    }
    return nearest;
}

// Light of hazy air, which glows below a low sun, and light on the ground; `pane` as in behindGrounds.
vec3 terrainHaze(vec3 d, float pane)
{
    float towardsSun = 0.5 + 0.5 * dot(safeNormalize(vec3(d.x, 0.0, d.z), vec3(0.0, 0.0, -1.0)), light.sunDirection);
    return pane * (mix(light.skyZenith, light.skyHorizon, 0.8) + light.skySunward * (towardsSun * towardsSun));
}

vec3 terrainLight(vec3 d, float pane)
{
    float towardsSun = max(dot(d, light.sunDirection), 0.0);
    return pane * (0.3 * light.skyHorizon + 0.05 * light.sunIrradiance * (1.0 + 2.0 * towardsSun));
}

// The same as behindGrounds for very wide pixels: hills, and the crowns of all trees as a hedge of their mean height
// that opens in the middle.
vec3 behindBlurredGrounds(vec3 sky, vec3 d, float angle, float pane)
{
    float level = max(length(d.xz), 1e-4);
    vec2 p = vec2(d.x / max(-d.z, 0.2 * level), d.y / level);
    float width = max(angle, 1e-4) * 1.5;
    vec3 haze = terrainHaze(d, pane);
    vec3 lit = terrainLight(d, pane);
    vec3 color = mix(sky, mix(vec3(0.12, 0.12, 0.10) * lit, haze, 0.2), terrainBelow(p.y - 0.04, width));
    float crowns = 0.17 * clamp(abs(p.x) * 7.0 - 0.1, 0.25, 1.0);
    color = mix(color, mix(vec3(0.08, 0.10, 0.04) * lit, haze, 0.04), 0.85 * terrainBelow(p.y - crowns, width));
    return mix(color, mix(vec3(0.12, 0.14, 0.06) * lit, haze, 0.2), terrainBelow(p.y + 0.004, width));
}

// Blends the scenery over the sky's radiance `sky` in the direction of the unit vector `d`, for a pixel `angle` radians
// wide. `pane` is the transmittance of the window's glass, already included in `sky`. The lightmaps ignore the scenery,
// because it is low and dark against the sky.
vec3 behindGrounds(vec3 sky, vec3 d, float angle, float pane)
{
    if (d.y > 0.5) return sky;
    float level = max(length(d.xz), 1e-4);
    vec2 p = vec2(atan(d.x, -d.z), d.y / level);
    float width = max(angle, 1e-4) * 1.5;
    vec3 haze = terrainHaze(d, pane);
    vec3 lit = terrainLight(d, pane);
    // Hills, roofs and trees are blended from far to near, each with less haze than the one behind it.
    float hills = 0.020 + 0.035 * terrainNoise(p.x * 3.0 + 7.0, 21u) + 0.006 * terrainNoise(p.x * 17.0, 22u);
    vec3 color = mix(sky, mix(vec3(0.10, 0.13, 0.15) * lit, haze, 0.34), terrainBelow(p.y - hills, width));
    vec3 roofs = mix(vec3(0.17, 0.12, 0.10) * lit, haze, 0.16);
    color = mix(color, roofs, terrainBelow(p.y - terrainRoof(p.x), width));
    float far = terrainCrowns(p, 0.035, 0.026, 31u);
    color = mix(color, mix(vec3(0.07, 0.10, 0.05) * lit, haze, 0.09), terrainBelow(far, width + 0.002));
    float near = terrainCrowns(p, 0.12, 0.085, 41u);
    // Darker where leaves are dense, brighter at the rim, where light shines through.
    float depth = clamp(-near * 18.0, 0.0, 1.0);
    float leaves = 0.75 + 0.5 * terrainNoise(p.x * 160.0 + 37.0 * floor(p.y * 130.0), 51u);
    vec3 tree = mix(vec3(0.16, 0.19, 0.06), vec3(0.035, 0.055, 0.028), depth) * lit * leaves;
    color = mix(color, mix(tree, haze, 0.025), terrainBelow(near, width + 0.003));
    // Color of the lawn, with a gravel path along its middle.
    vec3 lawn = vec3(0.10, 0.13, 0.045) * lit * (0.85 + 0.3 * terrainNoise(p.x / max(-p.y, 0.01) * 6.0, 61u));
    float path = terrainBelow(abs(p.x) - 1.1 * max(-p.y, 0.0) * 0.35, width);
    lawn = mix(lawn, vec3(0.33, 0.30, 0.25) * lit, path);
    return mix(color, mix(lawn, haze, 0.25 * exp2(40.0 * min(p.y, 0.0))), terrainBelow(p.y + 0.004, width));
}
