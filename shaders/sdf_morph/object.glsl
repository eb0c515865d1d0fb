// Where the object is, what it is marched in, and its shape: mirrored by SdfObject in
// exhibits/sdf_morph/sdf_shape.h.
#include "lib/bindings.glsl"
#include "lib/torus_mug.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    mat4 worldFromLocal;
    mat4 localFromWorld;
    vec4 boxLow;    // w: largest scale of worldFromLocal
    vec4 boxHigh;
    vec4 shape[7];  // TorusMugShape, field after field
    vec4 wipe;      // x: pixels from the left edge at which the marched half ends
} object;

TorusMugShape objectShape()
{
    TorusMugShape s;
    s.morph = object.shape[0].x;
    s.bodyCenter = object.shape[0].yzw;
    s.bodyRadius = object.shape[1].x;
    s.bodyHalfHeight = object.shape[1].y;
    s.bodyRoundingAbove = object.shape[1].z;
    s.bodyRoundingBelow = object.shape[1].w;
    s.cavityRadius = object.shape[2].x;
    s.cavityBottom = object.shape[2].y;
    s.cavityRounding = object.shape[2].z;
    s.footRadius = object.shape[2].w;
    s.footHeight = object.shape[3].x;
    s.footTube = object.shape[3].y;
    s.ringCenter = object.shape[3].zw;
    s.ringRadius = object.shape[4].x;
    s.ringTube = object.shape[4].y;
    s.ringStretch = object.shape[4].z;
    s.joint = object.shape[4].w;
    s.lip = object.shape[5].x;
    return s;
}

TorusMugShape shape = objectShape();

float fieldDistance(vec3 p)
{
    return sdfTorusMug(p, shape);
}

#include "lib/sphere_tracing.glsl"

// The table's accuracy, for a ray that spans [tMin, tMax] in the object's own space. `halfPixel` is half a
// pixel's width at distance 1 there.
MarchSettings tableSettings(float tMin, float tMax, float halfPixel)
{
    MarchSettings s = marchSettings(tMin, tMax, halfPixel);
    s.tolerance = parameters.hitTolerance;
    s.stepLimit = parameters.stepLimit;
    s.relaxation = parameters.relaxation;
    s.omega = parameters.relaxationFactor;
    return s;
}
