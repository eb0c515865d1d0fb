// Transforms a part of the small world for the sun's shadow map. Permutations: MASKED, if the part has an alpha mask
// (pixel_art/shadow.frag), and with it VERTEX_COLOR and SECOND_UV.
#include "lib/frame.glsl"
#include "pixel_art/object.glsl"

layout(location = 0) in vec3 position;
#ifdef MASKED
layout(location = 3) in vec2 uv;
out vec2 uvAt;
#endif
#ifdef SECOND_UV
layout(location = 4) in vec2 extra;
out vec2 secondUv;
#endif
#ifdef VERTEX_COLOR
layout(location = 5) in vec4 color;
out vec4 vertexColor;
#endif

void main()
{
#ifdef MASKED
    uvAt = uv;
#endif
#ifdef SECOND_UV
    secondUv = extra;
#endif
#ifdef VERTEX_COLOR
    vertexColor = color;
#endif
    gl_Position = frame.clipFromWorld * (object.worldFromModel * vec4(position, 1.0));
}
