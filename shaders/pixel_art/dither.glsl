// Maps to the palette with ordered or blue-noise dithering. Sixteen palette colors have the requested color as their
// mean. In order of luminance, a pattern selects one of them for the texel (Knoll 1999, US patent 6,606,166, expired).
// Permutations: ORDERED, BLUE_NOISE; with neither, the nearest color.
#include "pixel_art/palette.glsl"

layout(binding = UNIT_EMISSIVE) uniform sampler2D blueNoise;

const int DITHER_COLORS = 16;

// Bayer matrix: 0 to 15, each once in 4 x 4 texels.
int bayer(ivec2 p)
{
    int x = p.x & 3;
    int y = p.y & 3;
    int q = x ^ y;
    return ((q & 1) << 3) | ((y & 1) << 2) | (q & 2) | ((y & 2) >> 1);
}

int rankAt(ivec2 p)
{
#ifdef ORDERED
    return bayer(p);
#else
    return clamp(int(texelFetch(blueNoise, p & 63, 0).r * 16.0), 0, DITHER_COLORS - 1);
#endif
}

// Index of the palette color with the nearest linear light. Used for the last of the sixteen, so that the remaining
// error of the mean is balanced. The others are nearest perceptually.
int nearestLight(vec3 light)
{
    int best = 0;
    float least = 1e9;
    for (int i = 0; i < textureSize(paletteColors, 0).x; ++i) {
        vec3 d = paletteColor(i) - light;
        if (dot(d, d) < least) {
            least = dot(d, d);
            best = i;
        }
    }
    return best;
}

// Index of the palette color for a color at this texel.
int ditheredIndex(vec3 color, ivec2 p)
{
#if !defined(ORDERED) && !defined(BLUE_NOISE)
    return nearestInPalette(color);
#else
    int sorted[DITHER_COLORS];
    vec3 error = vec3(0.0);
    for (int i = 0; i < DITHER_COLORS; ++i) {
        vec3 wanted = color + error * parameters.ditherStrength;
        int index = i < DITHER_COLORS - 1 ? nearestInPalette(wanted) : nearestLight(wanted);
        error += color - paletteColor(index);
        int j = i;
        while (j > 0 && sorted[j - 1] > index) {
            sorted[j] = sorted[j - 1];
            --j;
        }
        sorted[j] = index;
    }
    return sorted[rankAt(p)];
#endif
}
