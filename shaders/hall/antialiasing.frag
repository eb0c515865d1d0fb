// Temporal antialiasing: the running mean of a picture in motion. Each frame draws another sample of its pixels. The
// result of earlier frames is reprojected, clamped to the colors around the pixel, and mixed with the new sample.
//
// The clamping box is given by mean and deviation of the pixel and its neighbors (Salvi 2016, "An Excursion in Temporal
// Supersampling"), in YCoCg (Karis 2014). For the method see Yang, Liu, Salvi 2020, "A Survey of Temporal Antialiasing
// Techniques".
#include "lib/frame.glsl"
#include "hall/antialiasing_block.glsl"
#include "lib/history.glsl"
#include "lib/temporal.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Antialiasing {
    AntialiasingBlock antialiasing;
};
layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(binding = UNIT_EXHIBIT_A) uniform sampler2D history;  // Alpha: number of frames that it is the mean of.
layout(binding = UNIT_EXHIBIT_B) uniform sampler2D depths;
layout(location = 0) out vec4 kept;
layout(location = 1) out vec4 shown;

// Catmull-Rom filter over 4 x 4 texels by bilinear lookups, without the corners.
vec4 sharpHistory(vec2 at)
{
    vec2 size = vec2(textureSize(history, 0));
    vec2 position = at * size;
    vec2 center = floor(position - 0.5) + 0.5;
    vec2 f = position - center;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
    vec2 w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 p0 = (center - 1.0) / size;
    vec2 p12 = (center + w2 / w12) / size;
    vec2 p3 = (center + 2.0) / size;
    vec4 sum = textureLod(history, p12, 0.0) * (w12.x * w12.y);
    sum += textureLod(history, vec2(p12.x, p0.y), 0.0) * (w12.x * w0.y);
    sum += textureLod(history, vec2(p0.x, p12.y), 0.0) * (w0.x * w12.y);
    sum += textureLod(history, vec2(p3.x, p12.y), 0.0) * (w3.x * w12.y);
    sum += textureLod(history, vec2(p12.x, p3.y), 0.0) * (w12.x * w3.y);
    float weight = w12.x * w12.y + w12.x * w0.y + w0.x * w12.y + w3.x * w12.y + w12.x * w3.y;
    return sum / weight;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 now = texelFetch(source, pixel, 0);
    shown = now;
    kept = vec4(now.rgb, 1.0);
    if (!temporalIsValid()) return;

    ivec2 last = textureSize(source, 0) - 1;
    vec3 sum = vec3(0.0);
    vec3 squares = vec3(0.0);
    float nearest = 0.0;
    for (int i = 0; i < 9; ++i) {  // The closest of the pixel and its diagonal neighbors gives the motion of an edge.
        ivec2 at = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        vec3 c = ycocgOf(texelFetch(source, at, 0).rgb);
        sum += c;
        squares += c * c;
        if (i % 2 == 0) nearest = max(nearest, texelFetch(depths, at, 0).r);
    }
    vec3 mean = sum / 9.0;
    vec3 deviation = sqrt(max(squares / 9.0 - mean * mean, 0.0));

    vec2 ndc = (gl_FragCoord.xy + frameTile()) * frame.inverseSize * 2.0 - 1.0;
    vec3 ray = mat3(frame.worldFromView) * vec3(ndc * frame.tanHalfFov + frame.tanShift, -1.0);
    vec3 place = frame.eye + ray * min(frameViewDepth(nearest), 1e5);
    vec2 before = temporalCoordinate(place);
    if (any(lessThan(before, vec2(0.0))) || any(greaterThan(before, vec2(1.0)))) return;

    vec4 past = sharpHistory(before);
    vec3 c = ycocgOf(max(past.rgb, 0.0));
    vec3 halfSize = deviation * 1.25;
    vec3 offset = c - mean;
    float far = boxDistance(offset, halfSize);
    if (far > 1.0) c = mean + offset / far;
    float frames = clamp(past.a, 1.0, antialiasing.frames - 1.0) + 1.0;
    vec3 mixed = mix(rgbOfYcocg(c), now.rgb, 1.0 / frames);
    kept = vec4(mixed, frames);
    shown = vec4(mixed, now.a);
}
