// Color space and box test for clamping a history to the neighborhood of a pixel.

// Converts to YCoCg: luma, orange and green chroma. Neighboring colors vary mostly in luma, so that their bounding box
// is smaller than in RGB (Karis 2014, "High-Quality Temporal Supersampling").
vec3 ycocgOf(vec3 rgb)
{
    return vec3(0.25 * rgb.r + 0.5 * rgb.g + 0.25 * rgb.b, 0.5 * (rgb.r - rgb.b),
                0.5 * rgb.g - 0.25 * (rgb.r + rgb.b));
}

vec3 rgbOfYcocg(vec3 c)
{
    float rest = c.x - c.z;
    return vec3(rest + c.y, c.x + c.z, rest - c.y);
}

// Distance of a color from the center of a box, relative to its half sides: up to 1 inside.
float boxDistance(vec3 offset, vec3 halfSize)
{
    vec3 unit = abs(offset) / max(halfSize, vec3(1e-4));
    return max(unit.x, max(unit.y, unit.z));
}
