// What the small world is made of: color with glow, and the true normal with the object's number.
#include "lib/bindings.glsl"
#include "lib/hash.glsl"
#include "pixel_art/object_block.glsl"
#include "pixel_art/pixel_block.glsl"
#include "pixel_art/patterns.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    PixelObjectBlock object;
};
layout(std140, binding = BLOCK_EXHIBIT) uniform Exhibit {
    PixelBlock pixel;
};
layout(binding = UNIT_BASE_COLOR) uniform sampler2D baseColorMap;

in vec3 modelPosition;
in vec3 viewNormal;
in vec2 uvAt;
flat in vec4 vertexColor;
flat in vec2 vertexExtra;

layout(location = 0) out vec4 colorOut;   // a: 1, and glow on top of it
layout(location = 1) out vec4 normalOut;  // view space; a: the object's number, from 1

void main()
{
    // A visitor's model may have normals of no length.
    vec3 n = dot(viewNormal, viewNormal) > 0.0 ? normalize(viewNormal) : vec3(0.0, 0.0, 1.0);
    float id = object.id;
    vec3 color;
    float glow = 0.0;
    if (object.colored) {
        PatternedColor made = patterned(int(vertexExtra.y + 0.5), vertexColor.rgb, modelPosition, uvAt, pixel.time);
        color = made.color;
        glow = vertexExtra.x + made.glow;
        id += vertexColor.a;
    } else {
        vec4 base = object.color * texture(baseColorMap, uvAt);
        if (base.a < object.alphaCutoff) discard;
        color = base.rgb + object.emissive;
        glow = clamp(max(object.emissive.r, max(object.emissive.g, object.emissive.b)), 0.0, 1.0);
        if (!gl_FrontFacing) n = -n;
    }
    colorOut = vec4(color, 1.0 + glow);
    normalOut = vec4(n, id);
}
