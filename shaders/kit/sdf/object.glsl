// The body at its place, its field and its material.
#include "lib/bindings.glsl"
#include "lib/frame.glsl"
#include "kit/sdf/object_block.glsl"

layout(std140, binding = BLOCK_OBJECT) uniform Object {
    SdfObject object;
};

struct FieldMaterial {
    vec3 baseColor;         // linear; of glass: what 10 cm of it leave of white
    float metalness;        // 0 to 1
    float roughness;        // perceptual, 0 to 1
    float specular;         // 0.5 is 4 % reflectance at normal incidence
    float refractiveIndex;  // of glass
};

// Which part of the body fieldDistance found last, where the field tells parts: the material of a hit reads that of its
// march.
int fieldPart = 0;

#include "kit/sdf/field.glsl"
#include "kit/sdf/material.glsl"
#include "lib/sphere_tracing.glsl"

// Normals go by the inverse transpose, or a scaled object would be lit as if it were not.
vec3 worldNormalOf(vec3 localNormal)
{
    return normalize(transpose(mat3(object.localFromWorld)) * localNormal);
}

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
