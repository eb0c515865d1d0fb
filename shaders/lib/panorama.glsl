// The user's panorama. A shader that includes this has `light`, a LightBlock, and binds the picture.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"

layout(binding = UNIT_ENVIRONMENT) uniform sampler2D environmentPicture;

// Equirectangular texture coordinates. Use them with an explicit mip level: their derivative jumps at the seam. At the
// poles atan(0, 0) is undefined (2.356 on llvmpipe), so u is set to one half there.
vec2 equirectangular(vec3 d)
{
    bool pole = abs(d.x) + abs(d.z) < 1e-6;
    float u = pole ? 0.5 : fract(atan(d.x, -d.z) / (2.0 * PI) + 0.5 + light.environmentRotation / (2.0 * PI));
    return vec2(u, acos(clamp(d.y, -1.0, 1.0)) / PI);
}

// Mean of the panorama over a pixel that is `angle` radians wide. Near a pole the pixel covers many columns of texels,
// at the pole all of them. They are sampled side by side, at the mip level of the pixel's height; if that needs more
// than 16 samples, at a coarser level.
vec3 panoramaRadiance(vec3 d, float angle)
{
    vec2 size = vec2(textureSize(environmentPicture, 0));
    vec2 uv = equirectangular(d);
    float across = min(angle / max(2.0 * PI * safeSqrt(1.0 - d.y * d.y), 1e-6), 1.0);  // Share of the whole width.
    float rows = max(angle / PI * size.y, 1.0);
    float columns = across * size.x;
    float looks = clamp(ceil(columns / rows), 1.0, 16.0);
    float level = log2(max(rows, columns / looks));
    // The texture repeats vertically, too, so the lookup must not mix the first row with the last one.
    float edge = min(0.5 * exp2(ceil(level)) / size.y, 0.5);
    float v = clamp(uv.y, edge, 1.0 - edge);
    vec3 sum = vec3(0.0);
    for (float i = 0.0; i < looks; i += 1.0)
        sum += textureLod(environmentPicture, vec2(uv.x + across * ((i + 0.5) / looks - 0.5), v), level).rgb;
    return max(sum / looks, vec3(0.0));  // Files may contain negative light.
}
