// The visitor's panorama. Who includes this has `light`, a LightBlock, and binds the picture.
#include "lib/bindings.glsl"
#include "lib/numerics.glsl"

layout(binding = UNIT_ENVIRONMENT) uniform sampler2D environmentPicture;

// Equirectangular lookup; the derivative jump at the seam is avoided by naming the level.
// At the poles atan(0, 0) is arbitrary (2.356 on llvmpipe), so u is defined there as one half.
vec2 equirectangular(vec3 d)
{
    bool pole = abs(d.x) + abs(d.z) < 1e-6;
    float u = pole ? 0.5 : fract(atan(d.x, -d.z) / (2.0 * PI) + 0.5 + light.environmentRotation / (2.0 * PI));
    return vec2(u, acos(clamp(d.y, -1.0, 1.0)) / PI);
}

// Mean of the panorama over a pixel that is `angle` radians wide. Towards a pole it holds ever more columns of
// texels, at the pole itself all of them: they are looked up side by side, as coarse as the pixel is high; beyond 16
// looks, coarser.
vec3 panoramaRadiance(vec3 d, float angle)
{
    vec2 size = vec2(textureSize(environmentPicture, 0));
    vec2 uv = equirectangular(d);
    float across = min(angle / max(2.0 * PI * safeSqrt(1.0 - d.y * d.y), 1e-6), 1.0);  // of the whole width
    float rows = max(angle / PI * size.y, 1.0);
    float columns = across * size.x;
    float looks = clamp(ceil(columns / rows), 1.0, 16.0);
    float level = log2(max(rows, columns / looks));
    // The picture repeats downwards, too: what is above its first row is not its last one.
    float edge = min(0.5 * exp2(ceil(level)) / size.y, 0.5);
    float v = clamp(uv.y, edge, 1.0 - edge);
    vec3 sum = vec3(0.0);
    for (float i = 0.0; i < looks; i += 1.0)
        sum += textureLod(environmentPicture, vec2(uv.x + across * ((i + 0.5) / looks - 0.5), v), level).rgb;
    return max(sum / looks, vec3(0.0));  // Files may hold negative light.
}
