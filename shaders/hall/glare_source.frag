// Light that causes glare, at a quarter of the resolution per side. The image is larger than the picture, so that its
// size can be halved exactly; beyond the picture's edge it shows the mirror image of the picture.
#include "lib/bindings.glsl"
#include "lib/light_uniform.glsl"
#include "lib/tonemap.glsl"
#include "lib/glare.glsl"

layout(binding = UNIT_SOURCE) uniform sampler2D source;
layout(location = 0) out vec4 bright;

void main()
{
    ivec2 size = textureSize(source, 0);
    ivec2 corner = ivec2(gl_FragCoord.xy) * GLARE_DIVISOR;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < GLARE_DIVISOR * GLARE_DIVISOR; ++i) {
        ivec2 at = corner + ivec2(i % GLARE_DIVISOR, i / GLARE_DIVISOR);
        at = max(min(at, 2 * size - 1 - at), ivec2(0));
        sum += glareSource(toneInput(texelFetch(source, at, 0).rgb * light.exposure));
    }
    bright = vec4(sum / float(GLARE_DIVISOR * GLARE_DIVISOR), 1.0);
}
