// Scene light to display light, and back: a filmic curve that keeps hue. Colors are first drawn a little
// towards each other (so that a saturated bright color pales instead of clipping), each channel follows a
// sigmoid in log exposure, and the drawing-together is undone: the idea of AgX (Sobotka 2022) with a
// Naka-Rushton sigmoid (1966), which has an exact inverse.

const float TONEMAP_INSET = 0.10;      // share of the neighbors mixed into each channel
const float TONEMAP_CONTRAST = 1.32;   // slope of the sigmoid in log-log at middle gray
const float TONEMAP_GRAY = 0.18;       // maps to itself

vec3 tonemapMix(vec3 c, float share)
{
    float mean = (c.r + c.g + c.b) / 3.0;
    return mix(c, vec3(mean), share);
}

vec3 tonemap(vec3 radiance)
{
    // Infinite light is white: infinity over infinity below would be NaN.
    vec3 c = tonemapMix(clamp(radiance, 0.0, 1e9), TONEMAP_INSET);
    float half_ = pow(TONEMAP_GRAY, TONEMAP_CONTRAST) * (1.0 - TONEMAP_GRAY) / TONEMAP_GRAY;
    vec3 x = pow(max(c, vec3(1e-7)), vec3(TONEMAP_CONTRAST));
    vec3 y = x / (x + half_);
    return clamp(tonemapMix(y, -TONEMAP_INSET / (1.0 - TONEMAP_INSET)), 0.0, 1.0);
}

// The scene light that `tonemap` shows as `display`: for colors that mean something, such as heat maps.
vec3 inverseTonemap(vec3 display)
{
    vec3 y = clamp(tonemapMix(display, TONEMAP_INSET), 1e-5, 0.995);
    float half_ = pow(TONEMAP_GRAY, TONEMAP_CONTRAST) * (1.0 - TONEMAP_GRAY) / TONEMAP_GRAY;
    vec3 x = half_ * y / (1.0 - y);
    return max(tonemapMix(pow(x, vec3(1.0 / TONEMAP_CONTRAST)), -TONEMAP_INSET / (1.0 - TONEMAP_INSET)), 0.0);
}
