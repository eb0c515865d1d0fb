// One of the ways of lib/sphere_tracing.glsl to find a shadow, by the number of a table's choice: SHADOW_METHOD, 1 to 5, is
// known when the shader is compiled, since five ways to ask the field would be compiled otherwise. 0: no shadow.
//
// `tanRadius`: tangent of half the angle that the light takes; `rayCount` and `turn` (radians) are of the method with
// many rays.
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
