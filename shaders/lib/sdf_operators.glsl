// Operators on signed distances and on the points at which they are evaluated.
//
// "Keeps 1" means: if the input fields are 1-Lipschitz, so is the output, so that sphere tracing, mixing and pruning
// stay safe. All of them lose exactness except where stated.
//
// GLSL 4.50 and C++ (render/glsl/cpu.h).

// Limits of a blend's width. A wider one would swallow the scene; a narrower one has no effect and would divide by
// numbers that GPUs flush to zero.
const float SDF_WIDEST_BLEND = 1000.0;
const float SDF_NARROWEST_BLEND = 1.0e-20;

// ---- Combining two fields: 1-Lipschitz if both are ----------------------------------------------

// a without b. Bound. If a face of b coincides with a face of a, a sheet of distance zero remains: see
// sdfCleanSubtraction.
float sdfSubtraction(float a, float b)
{
    return max(a, -b);
}

// a without b grown by `gap`: coinciding faces leave nothing behind (a minus a is nowhere closer than gap / 2). A gap
// of at least twice the hit tolerance makes the sheet invisible.
float sdfCleanSubtraction(float a, float b, float gap)
{
    return max(a, gap - b);
}

// Union with a fillet that starts where the two distances differ by k meters, and adds at most k / 4. k = 0 (or less)
// is the hard union, bitwise; k is clamped to SDF_WIDEST_BLEND. Quilez 2013, "Smooth minimum", quadratic.
float sdfSmoothUnion(float a, float b, float k)
{
    if (!(k > SDF_NARROWEST_BLEND)) return min(a, b);
    float width = min(k, SDF_WIDEST_BLEND);
    float h = max(width - abs(a - b), 0.0) / width;
    return min(a, b) - h * h * width * 0.25;
}

// The same for a without b.
float sdfSmoothSubtraction(float a, float b, float k)
{
    return -sdfSmoothUnion(-a, b, k);
}

// Cubic fillet: curvature is continuous at its edge; adds at most k / 6.
float sdfSmoothUnionCubic(float a, float b, float k)
{
    if (!(k > SDF_NARROWEST_BLEND)) return min(a, b);
    float width = min(k, SDF_WIDEST_BLEND);
    float h = max(width - abs(a - b), 0.0) / width;
    return min(a, b) - h * h * h * width * (1.0 / 6.0);
}

// -k log2(2^(-a/k) + 2^(-b/k)): independent of the order of three or more operands; adds at most k. Computed relative
// to the smaller value, because 2^(|a|/k) overflows float32 once |a| / k exceeds 128.
float sdfSmoothUnionExponential(float a, float b, float k)
{
    if (!(k > SDF_NARROWEST_BLEND)) return min(a, b);
    float width = min(k, SDF_WIDEST_BLEND);
    return min(a, b) - width * log2(1.0 + exp2(max(-abs(a - b) / width, -126.0)));
}

// Interpolates two fields: exactly a at t = 0 and b at t = 1, bitwise. Outside [0, 1] the result is divided by |1 - t|
// + |t|, the slope that extrapolation could reach, so that it keeps 1 there as well.
float sdfMix(float a, float b, float t)
{
    if (t == 0.0) return a;
    if (t == 1.0) return b;
    return (a * (1.0 - t) + b * t) / (abs(1.0 - t) + abs(t));
}

// ---- Changing one field: 1-Lipschitz if it is ---------------------------------------------------

// Wall of `thickness` around the surface.
float sdfOnion(float d, float thickness)
{
    return abs(d) - 0.5 * thickness;
}

// Grows the solid by `radius` with rounded edges. Exact where d is exact outside.
float sdfRound(float d, float radius)
{
    return d - radius;
}

// Scales a field that was evaluated at p / scale. `scale` > 0; exact stays exact.
float sdfScaled(float d, float scale)
{
    return d * scale;
}

// Extrudes a profile in the plane from -halfHeight to +halfHeight. Exact if the profile is.
float sdfExtrude(float profile, float z, float halfHeight)
{
    vec2 d = vec2(profile, abs(z) - halfHeight);
    return length(max(d, vec2(0.0))) + min(max(d.x, d.y), 0.0);
}

// ---- Changing the point: 1-Lipschitz if the field is --------------------------------------------

// Stretches a solid along the axes by `halfSize` each way; flat pieces fill the gap. Exact outside for solids that are
// symmetric about the origin.
vec3 sdfElongate(vec3 p, vec3 halfSize)
{
    return p - clamp(p, -halfSize, halfSize);
}
