// Draws the box around one body's fur, so that no other pixel is shaded, and computes values that are constant over it.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "fur/bodies.glsl"
#include "fur/hair.glsl"

layout(location = 0) in vec3 position;

flat out vec3 keyDirection;  // direction of most of the hall's light
flat out vec3 toLamp;
flat out float cover;        // share of the skin that the coat covers

vec3 firstOrder(int coefficient)
{
    return texelFetch(probeIrradiance, ivec2(coefficient, 0), 0).rgb;
}

void main()
{
    // The first-order coefficients give this direction (Sloan 2008, "Stupid Spherical Harmonics Tricks").
    keyDirection = vec3(0.0, 1.0, 0.0);
    if (light.hasProbe) {
        vec3 weights = vec3(0.2126, 0.7152, 0.0722);
        keyDirection = safeNormalize(vec3(dot(firstOrder(3), weights), dot(firstOrder(1), weights), dot(firstOrder(2), weights)), keyDirection);
    }
    toLamp = lampDirection();
    FurBody body = fur.bodies[0];
    cover = body.shellCount > 1.0 ? coatCover(body.cellSize, body.strandRadius, body.strandLength) : 0.0;
    gl_Position = frame.clipFromWorld * (fur.bodies[0].worldFromBody * vec4(fur.boxCenter + fur.boxHalfSize * position, 1.0));
}
