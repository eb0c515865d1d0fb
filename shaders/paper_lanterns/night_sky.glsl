// The sky over the lake: remaining daylight, moon and stars; or the user's panorama.
#ifdef PANORAMA
#include "lib/panorama.glsl"

// The panorama's center is straight ahead through the frame, between +x and -z.
vec3 panoramaSky(vec3 d, float angle)
{
    return min(panoramaRadiance(vec3(0.70710678 * (d.x + d.z), d.y, 0.70710678 * (d.z - d.x)), angle), vec3(60.0));
}
#else
#include "lib/sky_view.glsl"
#endif

// Moonlight from directions around `d`, for a ray blurred by these standard deviations, vertical and horizontal.
vec3 moonGlow(vec3 d, vec2 blur)
{
#ifdef MOON
    vec3 m = lake.towardsMoon;
    vec3 side = safeNormalize(cross(vec3(0.0, 1.0, 0.0), m), vec3(1.0, 0.0, 0.0));
    vec3 up = cross(m, side);
    if (dot(d, m) <= 0.0) return vec3(0.0);
    vec2 at = vec2(dot(d, up), dot(d, side));
    float r = lake.moonTanRadius;
    vec3 color = lake.moonLight / max(max(lake.moonLight.x, lake.moonLight.z), 1e-6);
    float angle = length(at);
    // Halo in thin mist.
    vec3 around = lake.moonLight * (0.14 * exp(-angle * 9.0) + 0.5 * exp(-angle * 45.0));
    vec2 wide = sqrt(blur * blur + 0.25 * r * r);
    float lobe = exp(-0.5 * dot(at / wide, at / wide)) / (2.0 * PI * wide.x * wide.y);
    vec3 mirrored = min(lake.moonLight * lobe, color * 1.7);
    if (max(blur.x, blur.y) > 0.3 * r) return mirrored + around;
    // Dark plains (maria) on the moon's face.
    Noise3 n = gradientNoise(ivec3(8), vec3(0.5), ivec3(64), 5u);
    vec2 q = at / r * 1.9 + 7.3;
    n = gradientNoise(ivec3(ivec2(floor(q)), 0), vec3(q - floor(q), 0.3), ivec3(64), 5u);
    vec2 fine = q * 2.7;
    Noise3 m2 = gradientNoise(ivec3(ivec2(floor(fine)), 3), vec3(fine - floor(fine), 0.3), ivec3(64), 5u);
    float basalt = smoothstep(-0.05, 0.45, n.value + 0.4 * m2.value);
    float rim = 1.0 - smoothstep(r - max(blur.x, 0.04 * r), r + max(blur.x, 0.04 * r), angle);
    vec3 face = color * min(5.0, 20.0 * max(lake.moonLight.x, lake.moonLight.z) + 0.5) * mix(1.0, 0.5, basalt);
    return mix(around, face, rim);
#else
    return vec3(0.0);
#endif
}

// Irradiance of a star of magnitude 7.2 at the brightness 1, in the scene's units: most are faint specks.
const float FAINTEST_STAR = 1.1e-7;

// Color of a star for a random number from 0 to 1, linear: as many blue-white, white, yellow and orange ones as among
// the stars that the eye sees (spectral classes B and A 42 %, F and G 28 %, K and M 30 %).
vec3 starColor(float x)
{
    vec3 hot = mix(vec3(0.55, 0.72, 1.0), vec3(0.82, 0.9, 1.0), min(x / 0.42, 1.0));
    vec3 cool = mix(vec3(1.0, 0.93, 0.78), vec3(1.0, 0.62, 0.33), clamp((x - 0.56) / 0.44, 0.0, 1.0));
    return mix(hot, cool, smoothstep(0.42, 0.56, x));
}

// At most one star in each cell of a cube's faces: some 22,000, down to magnitude 7.2. Each is drawn as a Gaussian of
// half a pixel, which is wide enough to move between pixels without flicker; its light is independent of the width.
vec3 starLight(vec3 d, float pixel)
{
    const float cells = 84.0;
    vec3 a = abs(d);
    int face = a.x >= a.y && a.x >= a.z ? 0 : (a.y >= a.z ? 1 : 2);
    vec2 uv = face == 0 ? d.yz / a.x : (face == 1 ? d.xz / a.y : d.xy / a.z);
    vec2 q = (uv * 0.5 + 0.5) * cells;
    ivec2 cell = ivec2(floor(q));
    int side = 2 * face + (d[face] > 0.0 ? 1 : 0);
    uvec3 bits = hashCell(ivec3(cell, side), lake.seed + 77u);
    uvec3 more = pcg3d(bits);
    vec2 at = vec2(cell) + 0.25 + 0.5 * vec2(unitFromBits(bits.x), unitFromBits(bits.y));
    float largest = a[face];
    float perCell = 2.0 / cells * largest * largest;  // radians, about
    vec2 starAt = (at / cells * 2.0 - 1.0) * a[face];
    vec3 star = face == 0 ? vec3(d.x, starAt) : (face == 1 ? vec3(starAt.x, d.y, starAt.y) : vec3(starAt, d.z));
    float off = length(normalize(star) - d);
    float wide = clamp(0.5 * pixel, 1e-5, 0.1 * perCell);
    float lobe = exp(-0.5 * off * off / (wide * wide));
    // Magnitudes as in the sky: 3.2 times as many stars with each magnitude, so that 1.25 is the exponent of the number
    // of stars over their brightness.
    float light_ = FAINTEST_STAR * pow(max(unitFromBits(bits.z), 1e-5), -0.8);
    float power = light_ / (2.0 * PI * wide * wide);
    float coarse = min(wide / (0.5 * pixel), 1.0);
    // Uniform density over the sky: cells are smaller towards the edges of a face.
    if (unitFromBits(more.y) > largest * largest * largest) return vec3(0.0);
    return starColor(unitFromBits(more.x)) * (min(power * lobe, 30.0) * coarse * coarse * smoothstep(0.0, 0.25, d.y));
}

// Direction of the sun below the horizon: to the right of straight ahead.
const vec3 SUN_BELOW = vec3(0.857493, 0.0, -0.514496);

// The sky without moon and stars: that of the night, and what is left of the day.
vec3 nightAir(vec3 d)
{
#ifdef PANORAMA
    return panoramaSky(d, 1.0);
#else
    vec3 night = mix(vec3(0.0016, 0.003, 0.0075), vec3(0.006, 0.008, 0.014), exp(-4.5 * max(d.y, 0.0)));
    return night + parameters.dusk * skyViewRadiance(d, SUN_BELOW);
#endif
}

// Radiance of the sky from a direction; `blur` as above, `pixel` is the width of a pixel.
vec3 skyLight(vec3 d, vec2 blur, float pixel)
{
#ifdef PANORAMA
    vec3 sky = panoramaSky(d, max(pixel, 2.0 * max(blur.x, blur.y)));
#else
    vec3 sky = nightAir(d) + moonGlow(d, blur);
#ifdef STARS
    if (blur.x < 3.0 * pixel) sky += parameters.stars * starLight(d, pixel);
#endif
#endif
#ifdef MIST
    // Optical depth of all mist above the eye, along this direction.
    float depth = parameters.fog * parameters.fogHeight / max(d.y, 1e-4);
    float left = exp(-min(depth, 80.0));
    return mix(mistLight(), sky, left);
#else
    return sky;
#endif
}
