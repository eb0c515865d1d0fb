// Tone curves: from exposed radiance (0 and up, without bound) to display light, 0 to 1. Both are linear, with the
// primaries of sRGB. This file is GLSL 4.50 and C++ (tests/exhibits/hall/tone_curves_test.cpp).
//
// toneAgx follows Sobotka's AgX (github.com/sobotka/AgX, 2022). toneAces is Hill's fit of the reference transforms of
// ACES (TheRealMJP/BakingLab, 2016). toneNeutral is the PBR Neutral tone mapper of Khronos
// (KhronosGroup/ToneMapping, 2024).

const float TONEMAP_INSET = 0.10;     // share of the other channels mixed into each channel
const float TONEMAP_GRAY = 0.18;      // maps to itself
const float TONEMAP_CONTRAST = 1.5;   // slope of the sigmoid's logit per factor of e at middle gray
const float TONEMAP_SHOULDER = 0.45;  // share of that slope that remains far above middle gray
const float TONEMAP_TOE = 0.03;       // half the increase of the slope for each factor of e below it
const float TONEMAP_HUE = 0.7;        // share of the middle channel's shift that is taken back
const float TONEMAP_BRIGHTEST = 1e9;  // Brighter light is not told apart. Its square is a float32, too.

// Returns the light without NaN and without negative values.
vec3 toneInput(vec3 radiance)
{
    return mix(vec3(0.0), min(radiance, vec3(TONEMAP_BRIGHTEST)), greaterThan(radiance, vec3(0.0)));
}

float toneLowest(vec3 c)
{
    return min(c.r, min(c.g, c.b));
}

float toneHighest(vec3 c)
{
    return max(c.r, max(c.g, c.b));
}

float toneMean(vec3 c)
{
    return (c.r + c.g + c.b) / 3.0;
}

vec3 toneNone(vec3 radiance)
{
    return min(toneInput(radiance), vec3(1.0));
}

// Sigmoid of the log exposure (Naka and Rushton 1966). Its argument is bent at both ends: a toe deepens shadows, and a
// shoulder keeps detail up to a hundred times middle gray.
vec3 toneSigmoid(vec3 c)
{
    vec3 u = log(max(c, vec3(1e-7)) / TONEMAP_GRAY);
    vec3 above = max(u, vec3(0.0));
    vec3 below = min(u, vec3(0.0));
    vec3 bent = above * (TONEMAP_SHOULDER + (1.0 - TONEMAP_SHOULDER) / (1.0 + above)) + below * (1.0 - TONEMAP_TOE * below);
    return 1.0 / (1.0 + (1.0 - TONEMAP_GRAY) / TONEMAP_GRAY * exp(-TONEMAP_CONTRAST * bent));
}

// Film with its hue kept. As in AgX, channels are mixed a little, so that a bright saturated color becomes paler instead
// of clipping; each follows a sigmoid, and the mixing is undone as far as the display can show it. A curve for each
// channel turns bright orange to yellow, because it compresses the highest channel most. The middle channel is therefore
// moved towards its old place between the other two, as in the tone curve of Adobe's DNG SDK. The share of 0.7 keeps the
// hue of Oklab within 12 degrees, that of warm colors within 7. A share of 0 shifts it by up to 28, a share of 1 by 12.
vec3 toneVitrine(vec3 radiance)
{
    vec3 c = toneInput(radiance);
    c = mix(c, vec3(toneMean(c)), TONEMAP_INSET);
    vec3 y = toneSigmoid(c);
    vec3 place = (c - toneLowest(c)) / max(toneHighest(c) - toneLowest(c), 1e-12);
    y = mix(y, mix(vec3(toneLowest(y)), vec3(toneHighest(y)), place), TONEMAP_HUE);
    float mean = toneMean(y);
    float toBlack = mean / max(mean - toneLowest(y), 1e-12);
    float toWhite = (1.0 - mean) / max(toneHighest(y) - mean, 1e-12);
    float spread = min(1.0 / (1.0 - TONEMAP_INSET), min(toBlack, toWhite));
    return clamp(mean + (y - mean) * spread, 0.0, 1.0);
}

// The sigmoid of AgX over 16.5 stops, of which 10 are below middle gray. Its ends are 0 and 1.
float toneAgxSigmoid(float c)
{
    const float below = 10.0 / 16.5;
    float x = clamp((log2(max(c, 1e-10) / 0.18) + 10.0) / 16.5, 0.0, 1.0) - below;
    float bent = x < 0.0 ? pow(1.0 + 59.507875 * pow(-x, 3.0), -1.0 / 3.0)
                         : pow(1.0 + 69.862789 * pow(x, 3.25), -1.0 / 3.25);
    return clamp(0.5 + 2.0 * x * bent, 0.0, 1.0);
}

vec3 toneAgx(vec3 radiance)
{
    vec3 c = mat3(0.842401, 0.042401, 0.042401, 0.0784365, 0.8784365, 0.0784365, 0.0791624, 0.0791624, 0.8791624) *
             toneInput(radiance);
    vec3 code = mat3(1.196999, -0.053001, -0.053001, -0.098046, 1.151954, -0.098046, -0.098953, -0.098953, 1.151047) *
                vec3(toneAgxSigmoid(c.r), toneAgxSigmoid(c.g), toneAgxSigmoid(c.b));
    return pow(clamp(code, 0.0, 1.0), vec3(2.2));
}

vec3 toneAces(vec3 radiance)
{
    // The factor gives middle gray about the brightness that the other curves give it.
    vec3 c = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777) *
             (toneInput(radiance) / 0.6);
    vec3 fitted = (c * (c + 0.0245786) - 0.000090537) / (c * (0.983729 * c + 0.4329510) + 0.238081);
    vec3 shown = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602) * fitted;
    return clamp(shown, 0.0, 1.0);
}

vec3 toneNeutral(vec3 radiance)
{
    const float start = 0.76;  // Here the compression of highlights begins.
    vec3 c = toneInput(radiance);
    float lowest = toneLowest(c);
    c -= lowest < 0.08 ? lowest - 6.25 * lowest * lowest : 0.04;
    float peak = toneHighest(c);
    if (peak <= start) return c;
    float compressed = 1.0 - (1.0 - start) * (1.0 - start) / (peak + 1.0 - 2.0 * start);
    float white = 1.0 - 1.0 / (0.15 * (peak - compressed) + 1.0);
    return mix(c * (compressed / peak), vec3(compressed), white);
}
