// What of a frame before may still be in a pixel.

// Luma, and how orange and how green a color is: its neighbors lie along luma for the most part, so that a box around
// them is smaller here than among red, green and blue (Karis 2014, "High-Quality Temporal Supersampling").
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

// How far a color is from the middle of a box of these half sides: up to 1 within it.
float boxDistance(vec3 offset, vec3 halfSize)
{
    vec3 unit = abs(offset) / max(halfSize, vec3(1e-4));
    return max(unit.x, max(unit.y, unit.z));
}
