// Coordinates of the clear sky's table (exhibits/kit/sky_view.h).
#include "lib/numerics.glsl"

// Place of a unit vector in the table, 0 to 1; below the horizon that at the horizon. The square of one coordinate is
// the sine of half the azimuth from the sun, that of the other the sine of the elevation: texels are dense near the
// horizon and near the sun.
vec2 skyViewPlace(vec3 d, vec3 sunDirection)
{
    vec3 level = safeNormalize(vec3(d.x, 0.0, d.z), vec3(0.0, 0.0, -1.0));
    vec3 sunLevel = safeNormalize(vec3(sunDirection.x, 0.0, sunDirection.z), vec3(0.0, 0.0, -1.0));
    float halfSine = sqrt(max(0.5 - 0.5 * dot(level, sunLevel), 0.0));
    return sqrt(clamp(vec2(halfSine, d.y), 0.0, 1.0));
}
