// The clear sky, looked up in a table over direction (exhibits/kit/sky_view.h).
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"

layout(binding = UNIT_ENVIRONMENT) uniform sampler2D skyView;

// Radiance of the sky without the sun's disk, from the unit vector `d`; below the horizon that at the horizon. The
// square of one coordinate is the sine of the elevation, that of the other the sine of half the azimuth from the sun:
// texels are dense near the horizon and near the sun.
vec3 skyViewRadiance(vec3 d, vec3 sunDirection)
{
    vec3 level = safeNormalize(vec3(d.x, 0.0, d.z), vec3(0.0, 0.0, -1.0));
    vec3 sunLevel = safeNormalize(vec3(sunDirection.x, 0.0, sunDirection.z), vec3(0.0, 0.0, -1.0));
    float halfSine = sqrt(max(0.5 - 0.5 * dot(level, sunLevel), 0.0));
    vec2 at = sqrt(clamp(vec2(halfSine, d.y), 0.0, 1.0));
    float side = float(textureSize(skyView, 0).x);
    return textureLod(skyView, (at * (side - 1.0) + 0.5) / side, 0.0).rgb;
}
