// Transform, field and material of the body.
#include "lib/bindings.glsl"
#include "lib/frame.glsl"
#include "kit/sdf/object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    SdfObject object;
};

struct FieldMaterial {
    vec3 baseColor;         // linear; for glass: color of white light after 10 cm
    float metalness;        // 0 to 1
    float roughness;        // perceptual, 0 to 1
    float specular;         // 0.5 is 4 % reflectance at normal incidence
    float refractiveIndex;  // for glass
};

// Part of the body that fieldDistance found last, if the field has several parts. A hit's material uses the part of its
// march.
int fieldPart = 0;

#include "kit/sdf/field.glsl"
#include "kit/sdf/material.glsl"
#include "lib/sphere_tracing.glsl"

// Transforms a normal by the inverse transpose, as scaled objects need.
vec3 worldNormalOf(vec3 localNormal)
{
    return normalize(transpose(mat3(object.localFromWorld)) * localNormal);
}

// Returns the accuracy set by the parameters, for a ray over [tMin, tMax] in the object's own space. `halfPixel` is
// half a pixel's width at distance 1 there.
MarchSettings tableSettings(float tMin, float tMax, float halfPixel)
{
    MarchSettings s = marchSettings(tMin, tMax, halfPixel);
    s.tolerance = parameters.hitTolerance;
    s.stepLimit = parameters.stepLimit;
    s.relaxation = parameters.relaxation;
    s.omega = parameters.relaxationFactor;
    return s;
}
