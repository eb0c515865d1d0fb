// Darkens the floor by the light that the bodies block, blended over it; with ALONE, draws the floor itself, fading
// out.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "fur/bodies.glsl"

in vec3 world;
in vec2 left;
flat in vec3 upwards;
flat in vec3 ambient;
flat in vec3 lampOnFloor;

layout(location = 0) out vec4 radiance;

void main()
{
    turnDisk(framePixel(gl_FragCoord.xy));
    float open = left.x * left.x;
    float r = length((fur.pitFromWorld * vec4(world, 1.0)).xz) / fur.pitRadius;
    vec3 lamp = lampOnFloor * (left.y * open);
#ifdef ALONE
    float there = 1.0 - smoothStep(0.35, 1.0, r);
    float lit = sunVisibility(world, upwards) * max(dot(upwards, light.sunDirection), 0.0);
    vec3 color = vec3(0.34, 0.31, 0.28) * (ambient * open + light.sunIrradiance * sunThroughGlass(world) * (lit / PI) + lamp);
    radiance = vec4(color, 1.0) * there;
#else
    // The hall has lit the floor with both lights already. The output is the share of their light that the bodies do
    // not block.
    vec3 gray = vec3(0.2126, 0.7152, 0.0722);
    float all = dot(ambient + lampOnFloor, gray);
    float there = dot(ambient * open + lamp, gray);
    radiance = vec4(0.0, 0.0, 0.0, all > 0.0 ? 1.0 - min(there / all, 1.0) : 1.0 - open);
#endif
}
