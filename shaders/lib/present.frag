// Copies display-referred linear light to the window, encoded as sRGB, scaled if the sizes differ.
#include "lib/bindings.glsl"
#include "lib/hash.glsl"
#include "lib/srgb.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;

in vec2 textureCoordinate;
layout(location = 0) out vec4 encoded;

void main()
{
    vec4 color = textureLod(source, textureCoordinate, 0.0);
    // Dithering: triangular noise of one level would hide banding completely; half a level is enough and less visible.
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    float noise = float(pcg(pixel.x + 4096u * pixel.y) & 0xFFFFu) / 65535.0 - 0.5;
    encoded = vec4(srgbFromLinear(color.rgb) + noise / 255.0, 1.0);
}
