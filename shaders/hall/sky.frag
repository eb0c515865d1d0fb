// Draws the sky where nothing else was drawn: at the far plane, so that the depth test masks it.
#include "lib/frame.glsl"
#include "lib/sky.glsl"

layout(location = 0) out vec4 radiance;

void main()
{
    radiance = vec4(min(skyRadiance(frameRay(gl_FragCoord.xy), frame.pixelAngle), vec3(6e4)), 1.0);
}
