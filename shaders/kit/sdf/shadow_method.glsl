// One of the shadow methods of lib/sphere_tracing.glsl. SHADOW_METHOD is the number of the parameter's option, 1 to 5;
// 0: no shadow. It is a compile-time constant, because otherwise the field would be compiled five times.
//
// `tanRadius`: tangent of half the light's apparent angle. `rayCount` and `turn` (radians) are used only by the method
// with many rays.
Shadow shadowByMethod(vec3 p, vec3 toLight, float tanRadius, float tMin, float tMax, int stepLimit, int rayCount, float turn)
{
#if SHADOW_METHOD == 1
    return shadowHard(p, toLight, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == 2
    return shadowClassic(p, toLight, tanRadius, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == 3
    return shadowAaltonen(p, toLight, tanRadius, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == 4
    return shadowSigned(p, toLight, tanRadius, tMin, tMax, stepLimit);
#elif SHADOW_METHOD == 5
    return shadowArea(p, toLight, tanRadius, tMin, tMax, stepLimit, rayCount, turn);
#else
    return Shadow(1.0, 0);
#endif
}
