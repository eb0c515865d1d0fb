// Background outside the hall: a clear sky that depends on the sun's height, with scenery, or the studio, or the user's
// panorama.
#include "lib/light.glsl"
#include "lib/terrain.glsl"
#ifndef BACKGROUND
#define BACKGROUND BACKGROUND_SKY
#endif
#if BACKGROUND == BACKGROUND_SKY
#include "lib/sky_view.glsl"
#else
#include "lib/panorama.glsl"
#endif

// A soft box of the studio: a bright rectangle `size` (tangents of half angles) around `center`.
float softBox(vec3 d, vec3 center, vec2 size)
{
    vec3 z = normalize(center);
    vec3 x = normalize(cross(vec3(0.0, 1.0, 0.0), z));
    vec3 y = cross(z, x);
    float along = dot(d, z);
    if (along <= 0.0) return 0.0;
    vec2 p = abs(vec2(dot(d, x), dot(d, y))) / along;
    vec2 edge = 1.0 - smoothstep(size * 0.82, size, p);
    return edge.x * edge.y;
}

// Background of an exhibit that is shown alone: a gray room with a large key, a rim and a low fill light.
vec3 studioRadiance(vec3 d)
{
    vec3 room = mix(vec3(0.10, 0.098, 0.095), vec3(0.62, 0.63, 0.66), smoothstep(-0.6, 0.9, d.y));
    room *= 0.8 + 0.2 * d.z;
#ifndef CAPTURE
    return room * 0.55;  // The lamps are not visible in the picture.
#endif
    vec3 key = vec3(7.0, 6.6, 6.0) * softBox(d, vec3(0.75, 0.75, 0.6), vec2(0.55, 0.4));
    vec3 rim = vec3(3.6, 4.0, 4.6) * softBox(d, vec3(-0.9, 0.35, -0.5), vec2(0.22, 0.9));
    vec3 fill = vec3(1.7, 1.6, 1.5) * softBox(d, vec3(-0.7, 0.1, 0.9), vec2(0.5, 0.5));
    return room + key + rim + fill;
}

#ifndef CAPTURE
// Transmittance of the panes of a tall old window, for the view only; light that enters the room is not dimmed.
const float SKY_PANE = 0.4;
#else
const float SKY_PANE = 1.0;
#endif

#if BACKGROUND == BACKGROUND_SKY
// Clear sky without the sun's disk, with thin streaks of cloud, so that the window does not look like paper. The glow
// of the air at a low sun colors them.
vec3 clearSky(vec3 d)
{
    float up = max(d.y, 0.0);
    vec2 level = safeNormalize(vec3(d.x, 0.0, d.z), vec3(0.0, 0.0, -1.0)).xz;
    vec2 sunLevel = safeNormalize(vec3(light.sunDirection.x, 0.0, light.sunDirection.z), vec3(0.0, 0.0, -1.0)).xz;
    float beside = 0.5 + 0.5 * dot(level, sunLevel);
    vec2 high = d.xz / (up + 0.12) * 1.7;
    float streaks = 0.5 + 0.5 * sin(high.x * 1.3 + 1.7 * sin(high.y * 0.7) + 0.6 * sin(high.x * 3.1 - high.y * 1.9));
    vec3 glow = light.skySunward * (0.35 * (1.0 - streaks) * beside * exp2(-3.0 * up));
    return skyViewRadiance(d, light.sunDirection) * mix(0.8, 1.0, streaks) + glow;
}

// Radiance of the sky alone from the unit vector `d`, through the panes. Haze and panes spread the sun's light around it.
vec3 skyThroughPanes(vec3 d)
{
    float toSun = max(dot(d, light.sunDirection), 0.0);
    return SKY_PANE * (clearSky(d) + light.sunIrradiance * (0.06 * pow(toSun, 14.0) + 0.3 * pow(toSun, 400.0)));
}
#endif

// Radiance from `direction`, for a pixel that is `angle` radians wide.
vec3 skyRadiance(vec3 direction, float angle)
{
    vec3 d = normalize(direction);
#if BACKGROUND == BACKGROUND_STUDIO
    return studioRadiance(d);
#elif BACKGROUND == BACKGROUND_PANORAMA
    return panoramaRadiance(d, angle);
#else
    return behindGrounds(skyThroughPanes(d), d, angle, SKY_PANE);
#endif
}

// The same for views that are blurred by far more than a tree's width.
vec3 blurredSkyRadiance(vec3 direction, float angle)
{
#if BACKGROUND == BACKGROUND_SKY
    vec3 d = normalize(direction);
    return behindBlurredGrounds(skyThroughPanes(d), d, angle, SKY_PANE);
#else
    return skyRadiance(direction, angle);
#endif
}
