// Tone mapping: a filmic curve that keeps hue. Colors are first mixed a little with their other channels, so that a
// saturated bright color becomes paler instead of clipping. Each channel then follows a sigmoid in log exposure, and
// the mixing is undone: the idea of AgX (Sobotka 2022) with a Naka-Rushton sigmoid (1966). The log exposure is bent at
// both ends. A long shoulder keeps detail in the sunlit floor, which is a hundred times brighter than walls in the
// shade; a toe keeps shadows deep.

const float TONEMAP_INSET = 0.10;      // share of the other channels mixed into each channel
const float TONEMAP_GRAY = 0.18;       // maps to itself
const float TONEMAP_CONTRAST = 1.25;   // slope of the sigmoid in log-log at middle gray
const float TONEMAP_SHOULDER = 0.36;   // share of that slope that remains far above middle gray
const float TONEMAP_TOE = 0.08;        // half the increase of the slope for each factor of e below it

vec3 tonemapMix(vec3 c, float share)
{
    float mean = (c.r + c.g + c.b) / 3.0;
    return mix(c, vec3(mean), share);
}

vec3 tonemap(vec3 radiance)
{
    // Infinite light becomes white: infinity over infinity below would be NaN.
    vec3 c = tonemapMix(clamp(radiance, 0.0, 1e9), TONEMAP_INSET);
    vec3 u = log(max(c, vec3(1e-7)) / TONEMAP_GRAY);
    vec3 above = max(u, vec3(0.0));
    vec3 below = min(u, vec3(0.0));
    vec3 bent = above * (TONEMAP_SHOULDER + (1.0 - TONEMAP_SHOULDER) / (1.0 + above)) + below * (1.0 - TONEMAP_TOE * below);
    vec3 y = 1.0 / (1.0 + (1.0 - TONEMAP_GRAY) / TONEMAP_GRAY * exp(-TONEMAP_CONTRAST * bent));
    return clamp(tonemapMix(y, -TONEMAP_INSET / (1.0 - TONEMAP_INSET)), 0.0, 1.0);
}

// Alpha of a pixel whose color is display light already: a debug view, or a data plot. No scene light of 0 or more maps
// to saturated bright display colors.
const float DISPLAY_LIGHT = 2.0;

// Display light of a pixel. `exposed`: radiance times exposure. `alpha`: as opaque passes and blending left it; 1 is
// scene light, DISPLAY_LIGHT is display light.
vec3 displayLight(vec3 exposed, float alpha)
{
    float share = clamp(alpha - 1.0, 0.0, 1.0);
    vec3 shown = share < 1.0 ? tonemap(exposed) : vec3(0.0);
    return share > 0.0 ? mix(shown, clamp(exposed, 0.0, 1.0), share) : shown;
}
