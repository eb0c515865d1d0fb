// Arithmetic that is defined for inputs where GLSL's is not. Each comment names the symptom that the function avoids;
// "llvmpipe" means Mesa 22.3.6. Other drivers misbehave differently for the same inputs.
//
// This file is GLSL 4.50 and C++ (render/glsl/cpu.h): no swizzles beyond one component, no `inout`,
// literals with a point.

const float PI = 3.14159265358979323846;

// `v` scaled to unit length, or `fallback` when v is too short to have a direction.
// Guards: normalize(0) is 0 * inf = NaN, and one NaN texel spreads through every filter after it.
vec3 safeNormalize(vec3 v, vec3 fallback)
{
    float squared = dot(v, v);
    return squared > 1.0e-30 ? v * inversesqrt(squared) : fallback;
}

// Square root, 0 below 0. Guards: 1 - c*c can be -1e-7 for a unit vector; its root is NaN.
float safeSqrt(float x)
{
    return sqrt(max(x, 0.0));
}

// Angle in [0, pi] of a cosine that rounding may have moved above 1.
// Guards: acos(1 + 1e-7) is NaN; acos near 1 loses half its digits, and llvmpipe's polynomial is off by
// 6e-5 even at 0.5. The two-argument arc tangent has neither fault.
float safeAcos(float cosine)
{
    float c = clamp(cosine, -1.0, 1.0);
    return atan(safeSqrt((1.0 - c) * (1.0 + c)), c);
}

// Angle in (-pi, pi] of (x, y); 0 at the origin. Guards: atan(0, 0) is 2.356 on llvmpipe, 0 in C.
float angleOf(float y, float x)
{
    return x == 0.0 && y == 0.0 ? 0.0 : atan(y, x);
}

// base^exponent; a base at or below zero counts as zero: 0^0 = 1, 0^e = 0 for e > 0.
// Guards: llvmpipe gives pow(0, 0) = 0 and pow(-1, 2) = NaN; C gives 1 and 1.
float powPositive(float base, float exponent)
{
    if (exponent == 0.0) return 1.0;
    return base > 0.0 ? pow(base, exponent) : 0.0;
}

// Cubic step from 0 at `low` to 1 at `high`; with equal edges a hard step that is 1 from `low` on.
// Guards: smoothstep(a, a, x) is undefined; llvmpipe returns 0 on both sides.
float smoothStep(float low, float high, float x)
{
    if (!(low < high)) return x < low ? 0.0 : 1.0;
    float u = clamp((x - low) / (high - low), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

// a at 0 and b at 1, both bitwise. Guards: drivers may compute mix as a + (b - a) t, which misses b.
float lerpExact(float a, float b, float t)
{
    return a * (1.0 - t) + b * t;
}

// Reflectance of a smooth surface, 1 at grazing angles. Schlick 1994, with the cosine clamped and the power multiplied
// out. Guards: pow(1 - cosine, 5) is NaN if rounding makes the cosine 1 + 1e-7.
float schlick(float cosine, float atNormalIncidence)
{
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return atNormalIncidence + (1.0 - atNormalIncidence) * (m2 * m2 * m);
}

// Reflectance of a transparent surface for unpolarized light, 0 to 1. `cosine` of the incoming ray, 0 to 1; `index`:
// refractive index of the far side over that of the near side. 1 on total reflection, 0 for index 1. Cook and Torrance
// 1982, "A Reflectance Model for Computer Graphics".
float fresnelDielectric(float cosine, float index)
{
    float g2 = index * index - 1.0 + cosine * cosine;
    if (g2 <= 0.0) return index == 1.0 ? 0.0 : 1.0;
    float g = sqrt(g2);
    float a = (g - cosine) / (g + cosine);
    float b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

// Fractional part in [0, 1), never 1. Guards: fract(-1e-9) rounds to 1.0 and indexes past a table.
float fractBelowOne(float x)
{
    float f = x - floor(x);
    return f < 1.0 ? f : 0.0;
}

// x, or `fallback` where x is NaN or infinite. Written with comparisons because a driver that assumes
// finite arithmetic may fold isnan() to false.
float finiteOr(float x, float fallback)
{
    return abs(x) <= 3.0e38 ? x : fallback;
}
