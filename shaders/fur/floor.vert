// Floor of the pit under the bodies, with their occlusion, which is smooth enough to be computed per vertex.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "fur/bodies.glsl"

layout(location = 0) in vec3 position;

out vec3 world;
out vec2 left;  // visible share, x: of the sky, y: of the lamp
out vec3 inPit;
out vec3 onRug;  // irradiance over pi from the room, without the bodies
flat out vec3 upwards;
flat out vec3 ambient;  // from the room, on a surface that faces up
flat out vec3 lampOnFloor;

void main()
{
    vec4 p = fur.worldFromPit * vec4(position.x * fur.pitRadius, 0.003, position.z * fur.pitRadius, 1.0);
    world = p.xyz;
    inPit = vec3(position.x, 0.0, position.z) * fur.pitRadius;
    vec3 up = normalize(mat3(fur.worldFromPit) * vec3(0.0, 1.0, 0.0));
    vec3 toLamp = lampDirection();
    upwards = up;
    onRug = fur.rugRadius > 0.0 ? ambientAt(world, up) : vec3(0.0);
    ambient = probeAmbient(up);
    lampOnFloor = lampLight() * (max(dot(up, toLamp), 0.0) / PI);
    left = vec2(1.0);
    for (int i = 0; i < FUR_BODIES; ++i) left *= openTo(fur.bodies[i], world, up, toLamp);
    gl_Position = frame.clipFromWorld * p;
}
