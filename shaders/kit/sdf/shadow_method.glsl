#include "kit/sdf/shadow_methods.glsl"

// One of the shadow methods of lib/sphere_tracing.glsl. SHADOW_METHOD is one of the values of
// shadow_methods.glsl. It is a compile-time constant, because otherwise the field would be compiled five times.
//
// `tanRadius`: tangent of half the light's apparent angle. `rayCount` and `turn` (radians) are used only by the method
// with many rays.
Shadow shadowByMethod(vec3 p, vec3 toLight, float tanRadius, float tMin, float tMax, int stepLimit, int rayCount, float turn)
{
#if SHADOW_METHOD == SHADOW_METHOD_HARD
    return shadowHard(p, toLight, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == SHADOW_METHOD_CLASSIC
    return shadowClassic(p, toLight, tanRadius, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == SHADOW_METHOD_IMPROVED
    return shadowAaltonen(p, toLight, tanRadius, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == SHADOW_METHOD_SIGNED
    return shadowSigned(p, toLight, tanRadius, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == SHADOW_METHOD_AREA
    return shadowArea(p, toLight, tanRadius, tMin, tMax, stepLimit, rayCount, turn);
#else
    return Shadow(1.0, 0);
#endif
}
