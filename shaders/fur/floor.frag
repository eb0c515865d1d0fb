// What the bodies hide from the floor's light, laid over it; alone (ALONE), the floor itself, fading out.
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
    vec3 color = vec3(0.34, 0.31, 0.28) * (ambient * open + light.sunIrradiance * (lit / PI) + lamp);
    radiance = vec4(color, 1.0) * there;
#else
    // Premultiplied: it darkens what is there, and adds the lamp's light on a dark felt, out to the wall.
    radiance = vec4(lamp * vec3(0.05, 0.045, 0.04) * (1.0 - smoothStep(0.55, 1.0, r)), 1.0 - open);
#endif
}
