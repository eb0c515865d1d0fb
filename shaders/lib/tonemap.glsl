// Scene light to display light, and back: a filmic curve that keeps hue. Colors are first drawn a little
// towards each other (so that a saturated bright color pales instead of clipping), each channel follows a
// sigmoid in log exposure, and the drawing-together is undone: the idea of AgX (Sobotka 2022) with a
// Naka-Rushton sigmoid (1966). Its log exposure is bent at both ends: a long shoulder leaves the sunlit floor,
// which has a hundred times the light of walls in the shade, its stone, and a toe keeps shadows deep. Both bends have
// an exact inverse.

const float TONEMAP_INSET = 0.10;      // share of the neighbors mixed into each channel
const float TONEMAP_GRAY = 0.18;       // maps to itself
const float TONEMAP_CONTRAST = 1.25;   // slope of the sigmoid in log-log at middle gray
const float TONEMAP_SHOULDER = 0.36;   // share of that slope that is left far above middle gray
const float TONEMAP_TOE = 0.08;        // half of what the slope gains for each factor of e below it

vec3 tonemapMix(vec3 c, float share)
{
    float mean = (c.r + c.g + c.b) / 3.0;
    return mix(c, vec3(mean), share);
}

vec3 tonemap(vec3 radiance)
{
    // Infinite light is white: infinity over infinity below would be NaN. What `inverseTonemap` makes of saturated
    // colors is below 0 in some channels.
    vec3 c = tonemapMix(clamp(radiance, -1e9, 1e9), TONEMAP_INSET);
    vec3 u = log(max(c, vec3(1e-7)) / TONEMAP_GRAY);
    vec3 above = max(u, vec3(0.0));
    vec3 below = min(u, vec3(0.0));
    vec3 bent = above * (TONEMAP_SHOULDER + (1.0 - TONEMAP_SHOULDER) / (1.0 + above)) + below * (1.0 - TONEMAP_TOE * below);
    vec3 y = 1.0 / (1.0 + (1.0 - TONEMAP_GRAY) / TONEMAP_GRAY * exp(-TONEMAP_CONTRAST * bent));
    return clamp(tonemapMix(y, -TONEMAP_INSET / (1.0 - TONEMAP_INSET)), 0.0, 1.0);
}

// The scene light that `tonemap` shows as `display`: for colors that mean something, such as heat maps.
vec3 inverseTonemap(vec3 display)
{
    vec3 y = clamp(tonemapMix(display, TONEMAP_INSET), 1e-5, 0.995);
    vec3 bent = log(y / (1.0 - y) * ((1.0 - TONEMAP_GRAY) / TONEMAP_GRAY)) / TONEMAP_CONTRAST;
    vec3 above = max(bent, vec3(0.0)) - 1.0;
    vec3 below = min(bent, vec3(0.0));
    vec3 u = mix((1.0 - sqrt(1.0 - 4.0 * TONEMAP_TOE * below)) / (2.0 * TONEMAP_TOE),
                 (above + sqrt(above * above + 4.0 * TONEMAP_SHOULDER * (above + 1.0))) / (2.0 * TONEMAP_SHOULDER),
                 greaterThan(bent, vec3(0.0)));
    return tonemapMix(TONEMAP_GRAY * exp(u), -TONEMAP_INSET / (1.0 - TONEMAP_INSET));
}
