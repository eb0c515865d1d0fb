// The clear sky, looked up in a table over direction (exhibits/kit/sky_view.h).
#include "lib/bindings.glsl"
#include "lib/sky_view_place.glsl"

layout(binding = UNIT_ENVIRONMENT) uniform sampler2D skyView;

// Radiance of the sky without the sun's disk, from the unit vector `d`; below the horizon that at the horizon.
vec3 skyViewRadiance(vec3 d, vec3 sunDirection)
{
    vec2 at = skyViewPlace(d, sunDirection);
    float side = float(textureSize(skyView, 0).x);
    return textureLod(skyView, (at * (side - 1.0) + 0.5) / side, 0.0).rgb;
}
