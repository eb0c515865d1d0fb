// A shell of the coat, or a fin along an edge of the mesh (FIN): the skin, moved outwards along bent strands. One
// instance per shell. With BY_ANGLE n, places that are turned away from the eye have more shells, up to n times as
// many. They lie closer together, and all end on the skin.
#include "lib/frame.glsl"
#include "fur/body.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    FurBody body;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 4) in vec2 form;  // x: mean curvature of the skin, 1/meter; y: height of a fin

out vec3 skin;       // at rest, body space
out vec3 skinNormal;
out vec3 coatNormal; // smooth normal of the skin, moved out to this shell
out vec3 strandWay;  // derivative of the place by height, strand lengths: a unit vector except for the matrix mix
out float curvature;
out vec3 place;      // body space
flat out vec3 eye;   // body space
#ifndef BY_ANGLE
#define BY_ANGLE 1
#endif
#if defined(FIN) || BY_ANGLE > 1
out float height;
#else
flat out float height;
flat out float above;  // from this shell up to the midpoint to the next outer one, in height
flat out float below;  // from this shell down to the midpoint to the next inner one, in height
out vec3 strandTurn;   // change of strandWay from the lower to the upper midpoint
#endif

// Smooth vector noise that does not repeat within a body: makes the coat swirl.
vec3 swirl(vec3 p)
{
    return vec3(sin(p.y * 1.7 + 2.1 * sin(p.z * 1.3 + 0.4)), sin(p.z * 1.9 + 1.8 * sin(p.x * 1.1 + 1.9)), sin(p.x * 1.6 + 2.3 * sin(p.y * 1.2 + 3.1)));
}

void main()
{
    float skinScale = body.skinScale;
    float strandLength = body.strandLength;
    vec3 n = safeNormalize(normal, safeNormalize(position, vec3(0.0, 1.0, 0.0)));
    vec3 root = position * skinScale;
    eye = (body.bodyFromWorld * vec4(frame.eye, 1.0)).xyz;

    vec3 tipOffset = body.tipOffset + swirl(position * 7.0) * parameters.disorder;
    vec3 gust = body.wind;
    if (dot(gust, gust) > 0.0) {
        float wave = sin(body.gustPhase + dot(root, gust) * 9.0 / length(gust)) + 0.6 * sin(2.7 * body.gustPhase + root.y * 13.0 + root.x * 7.0);
        tipOffset += gust * max(1.0 + parameters.gustiness * 0.6 * wave, 0.0);
    }
    vec3 combed = parameters.comb * (vec3(0.45, -0.75, 0.3) - n * dot(n, vec3(0.45, -0.75, 0.3)));
    vec3 tip = safeNormalize(turned(body.tipRotation, n) + tipOffset + combed, n);
    float bend = parameters.curvature;
    for (int i = 0; i < body.planeCount; ++i) {
        vec4 plane = body.planes[i];
        float room = (dot(plane.xyz, root) - plane.w) / max(strandLength, 1e-6);
        tip = strandPressed(n, tip, plane.xyz, room);
        // A strand that lies on the ground is bent from its root on.
        float pressed = clamp(1.0 - max(room, 0.0), 0.0, 1.0) * clamp(-dot(n, plane.xyz), 0.0, 1.0);
        bend *= 1.0 - 0.85 * pressed * pressed;
    }

#ifdef FIN
    height = form.y;
#else
    int instance = body.firstShell + gl_InstanceID;
    int shell = body.innerFirst ? int(ceil(body.shellCount)) * BY_ANGLE - 1 - instance : instance;
    float count = body.shellCount;
    vec3 fromEye = root - eye;
    if (BY_ANGLE > 1 && count > 1.0) count *= clamp(1.0 / max(abs(dot(n, safeNormalize(fromEye, n))), 1e-3), 1.0, float(BY_ANGLE));
    height = powPositive(shellHeight(float(shell), count), parameters.distanceAttenuation);
#if BY_ANGLE > 1
    // The first shell that lies on the skin everywhere in a triangle is the last one drawn of it.
    gl_CullDistance[0] = shell == 0 || float(shell) < count ? 1.0 : -1.0;
#else
    float attenuation = parameters.distanceAttenuation;
    above = shell > 0 ? 0.5 * (powPositive(shellHeight(float(shell) - 1.0, count), attenuation) - height) : 0.0;
    below = 0.5 * (height - powPositive(shellHeight(float(shell) + 1.0, count), attenuation));
#endif
#endif
    int model = parameters.rotationModel;
    vec3 p = root + strandLength * strandPoint(n, tip, height, bend, model);
    skin = position;
    skinNormal = n;
    coatNormal = n + (p - root) * (form.x / skinScale);
#if defined(FIN) || BY_ANGLE > 1
    strandWay = strandDirection(n, tip, powPositive(height, bend), model);
#else
    strandWay = strandDirection(n, tip, powPositive(height - below, bend), model);
    strandTurn = strandDirection(n, tip, powPositive(height + above, bend), model) - strandWay;
    if (above + below > 0.0) strandWay += strandTurn * (below / (above + below));
#endif
    place = p;
    curvature = form.x / skinScale;
    gl_Position = frame.clipFromWorld * (body.worldFromBody * vec4(p, 1.0));
}
