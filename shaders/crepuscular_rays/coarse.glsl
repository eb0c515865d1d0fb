// Downsampled images of the frame: depth of a cell, and depth-aware upsampling to pixels.

layout(binding = UNIT_SOURCE) uniform sampler2D depthOfPicture;

const float COARSE_FARTHEST = 60.0;  // meters: beyond the hall, differences of depth are ignored

float depthAt(vec2 pixel)
{
    ivec2 inside = ivec2(clamp(pixel - frameTile(), vec2(0.0), vec2(textureSize(depthOfPicture, 0)) - 1.0));
    return min(frameViewDepth(texelFetch(depthOfPicture, inside, 0).r), COARSE_FARTHEST);
}

// Distance of a cell along the view axis, meters: alternately the nearest and the farthest of its corner pixels. So
// along an edge there is always a neighboring cell on either side of it.
float coarseDepth(vec2 cell)
{
    float last = rays.cellSize - 1.0;
    vec2 first = cell * rays.cellSize;
    float a = depthAt(first);
    if (last < 0.5) return a;
    vec4 corners = vec4(a, depthAt(first + vec2(last, 0.0)), depthAt(first + vec2(0.0, last)), depthAt(first + vec2(last)));
    bool nearest = mod(cell.x + cell.y, 2.0) < 0.5;
    return nearest ? min(min(corners.x, corners.y), min(corners.z, corners.w)) : max(max(corners.x, corners.y), max(corners.z, corners.w));
}

// Upsamples the light of a downsampled image (rgb; its depth in a) at a pixel of the tile: nine cells with a tent of
// two cells' width. The weight of a cell decreases with its difference in depth from the pixel.
vec3 broughtUp(sampler2D coarse, vec2 pixel, float depth)
{
    ivec2 size = textureSize(coarse, 0);
    if (rays.cellSize < 1.5) return texelFetch(coarse, ivec2(pixel), 0).rgb;
    vec2 at = (floor(pixel) + 0.5 + frameTile()) / rays.cellSize - rays.firstCell;
    vec2 middle = floor(at);
    vec3 sum = vec3(0.0);
    float all = 0.0;
    vec3 nearest = vec3(0.0);
    float nearestDifference = 1e9;
    float steepness = 40.0 / depth;
    for (int i = 0; i < 9; ++i) {
        vec2 cell = middle + vec2(float(i % 3) - 1.0, float(i / 3) - 1.0);
        vec4 light = texelFetch(coarse, clamp(ivec2(cell), ivec2(0), size - 1), 0);
        vec2 away = max(1.5 - abs(cell + 0.5 - at), vec2(0.0));
        float difference = abs(light.a - depth);
        float weight = away.x * away.y * exp2(-steepness * difference);
        sum += light.rgb * weight;
        all += weight;
        if (difference < nearestDifference) {
            nearestDifference = difference;
            nearest = light.rgb;
        }
    }
    return all > 1e-4 ? sum / all : nearest;
}
