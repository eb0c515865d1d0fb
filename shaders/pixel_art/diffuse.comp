// Maps to the palette by error diffusion (Floyd and Steinberg 1976, "An adaptive algorithm for spatial grayscale").
// Each invocation processes a row, two texels behind the row above, which supplies all errors that it needs.
#include "lib/bindings.glsl"
#include "pixel_art/palette.glsl"

layout(local_size_x = 256) in;
layout(rgba16f, binding = 0) uniform writeonly image2D shown;
layout(binding = UNIT_SOURCE) uniform sampler2D litPicture;
layout(std430, binding = STORAGE_EXHIBIT_A) buffer Errors {
    // errors passed down by row i of 256, at i + 1; those of the last row go to the first of the next 256
    vec4 errors[];
};

void main()
{
    ivec2 size = textureSize(litPicture, 0);
    int lane = int(gl_LocalInvocationID.x);
    int bands = (size.y + 255) / 256;
    for (int band = 0; band < bands; ++band) {
        int row = band * 256 + lane;
        int from = (lane > 0 ? lane : band > 0 ? 256 : 0) * size.x;
        int to = (lane + 1) * size.x;
        vec3 right = vec3(0.0);
        vec3 below = vec3(0.0);
        vec3 belowRight = vec3(0.0);
        for (int tick = 0; tick < size.x + 2 * 256; ++tick) {
            int x = tick - 2 * lane;
            if (row < size.y && x >= 0 && x < size.x) {
                ivec2 p = ivec2(x, size.y - 1 - row);
                vec4 color = texelFetch(litPicture, p, 0);
                vec3 handed = lane + band > 0 ? errors[from + x].rgb : vec3(0.0);
                vec3 wanted = color.rgb + (right + handed) * parameters.ditherStrength;
                vec3 chosen = color.a < 1.5 ? paletteColor(nearestInPalette(wanted)) : color.rgb;
                imageStore(shown, p, vec4(chosen, min(color.a, 1.0)));
                vec3 error = clamp(wanted - chosen, vec3(-1.0), vec3(1.0));
                right = error * (7.0 / 16.0);
                if (x > 0) errors[to + x - 1] = vec4(below + error * (3.0 / 16.0), 0.0);
                below = belowRight + error * (5.0 / 16.0);
                belowRight = error * (1.0 / 16.0);
                if (x == size.x - 1) errors[to + x] = vec4(below, 0.0);
            }
            memoryBarrierBuffer();
            barrier();
        }
    }
}
