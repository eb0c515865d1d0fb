// Writes the surfaces of the small world: color with glow, exact normal with the object's number, and emission.
// Permutations: those of kit/material.glsl, EMISSION, UNLIT (some parts are; with EMISSION).
#include "lib/hash.glsl"
#include "pixel_art/object.glsl"
#include "pixel_art/pixel_block.glsl"
#include "pixel_art/patterns.glsl"
#include "kit/material.glsl"

layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};

in vec3 modelPosition;
in vec3 viewNormal;
in vec2 uvAt;
flat in vec4 paintColor;
flat in vec2 paintExtra;

layout(location = 0) out vec4 colorOut;   // a: 1 plus glow
layout(location = 1) out vec4 normalOut;  // view space; a: the object's number, from 1
#ifdef EMISSION
layout(location = 2) out vec4 emissionOut;
#endif

void main()
{
    // A user's model may have normals of length 0.
    vec3 n = dot(viewNormal, viewNormal) > 0.0 ? normalize(viewNormal) : vec3(0.0, 0.0, 1.0);
    float id = part.id;
    vec4 base = materialColor(uvAt);
    vec3 materialLight = materialEmission(uvAt);
    vec3 color;
    vec3 emitted = vec3(0.0);
    float glow = 0.0;
    if (part.painted) {
        PatternedColor made = patterned(int(paintExtra.y + 0.5), paintColor.rgb, modelPosition, uvAt, pixel.time);
        color = made.color;
        glow = paintExtra.x + made.glow;
        id += paintColor.a;
    } else {
        if (base.a < object.alphaCutoff) discard;
        color = base.rgb;
        emitted = materialLight;
        if (!gl_FrontFacing) n = -n;
#ifdef UNLIT
        if (object.unlit) {
            emitted = base.rgb;
            color = vec3(0.0);
        }
#endif
    }
    colorOut = vec4(color, 1.0 + glow);
    normalOut = vec4(n, id);
#ifdef EMISSION
    emissionOut = vec4(min(emitted, vec3(6e4)), 1.0);
#endif
}
