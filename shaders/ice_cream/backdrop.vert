// A sheet that covers the back of the niche and sweeps forward onto its floor.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "ice_cream/backdrop_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    IceCreamBackdrop backdrop;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 place;  // exhibit space
out vec3 world;
out vec3 worldNormal;
out vec3 roomLight;  // irradiance over pi from the room, which varies slowly

void main()
{
    place = position;
    vec4 p = backdrop.worldFromExhibit * vec4(position, 1.0);
    world = p.xyz;
    worldNormal = normalize(mat3(backdrop.worldFromExhibit) * normal);
    roomLight = ambientAt(world, worldNormal);
    gl_Position = frame.clipFromWorld * p;
}
