// Transforms the card: a slab with rounded corners and beveled edges.
#include "lib/frame.glsl"
#include "lenticular/card.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

invariant gl_Position;  // The counting pass needs exactly the same depth as the first pass.

out vec3 cardPosition;
out vec3 cardNormal;

void main()
{
    cardPosition = position;
    cardNormal = normal;
    gl_Position = frame.clipFromWorld * (object.worldFromCard * vec4(position, 1.0));
}
