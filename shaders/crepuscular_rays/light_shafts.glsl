// Weights of light gathered along a line of the screen towards a light source.
//
// At position p, with the light at L, the gathered light is the mean of the mask M over the way there,
//
//     I(p) = integral from 1 - density to 1 of M(L + (p - L) t) a t^(a-1) dt / (1 - (1 - density)^a),
//
// where t is the remaining share of the way: 1 at p, 0 at the light. The weight is a power of t. Mitchell 2007
// ("Volumetric Light Scattering as a Post-Process", GPU Gems 3, chapter 13) uses an exponential of the number of steps
// instead. Both agree near p, and both are uniform for decay 1. A power depends on p and L only by their ratio. So
// geometric steps compose exactly, and a running sum along log-polar lines gives I with one lookup.
//
// This file is GLSL 4.50 and C++ (exhibits/crepuscular_rays/rays_cpu.h); needs lib/numerics.glsl.

// Decay is per step of a march of this many steps, as in the reference (Mitchell 2007 leaves it free).
const float SHAFT_STEPS = 128.0;
// Above this, the weight lies within a thousandth of the way from p: the mask itself.
const float SHAFT_LARGEST_EXPONENT = 4096.0;
// Share of the weight next to the light that geometric steps may omit.
const float SHAFT_REST = 0.002;

// Exponent a of the weight: 1 is uniform, large values concentrate near p. `decay` per step of SHAFT_STEPS, 0 to 1.
float shaftExponent(float decay)
{
    if (!(decay > 0.0)) return SHAFT_LARGEST_EXPONENT;
    return clamp(1.0 - SHAFT_STEPS * log(decay), 1.0, SHAFT_LARGEST_EXPONENT);
}

// Density for a light that is `reach` times as far away as a streak is long: the same streak is then a smaller share of
// the way. Density is the gathered share of the way; the exponent keeps the decay per length.
float shaftDensity(float density, float reach)
{
    return clamp(density, 0.0, 1.0) / max(reach, 1.0);
}

float shaftExponentAt(float decay, float reach)
{
    return min(1.0 + (shaftExponent(decay) - 1.0) * max(reach, 1.0), SHAFT_LARGEST_EXPONENT);
}

// Weight of the part of the way that remains at t: t^a, exactly 0 and 1 at the ends.
float shaftWeightBelow(float t, float exponent)
{
    return t >= 1.0 ? 1.0 : powPositive(t, exponent);
}

// Center of step i of n, as the remaining share of the way; `shift` in [-0.5, 0.5] moves it within its step.
float shaftStep(float i, float n, float density, float shift)
{
    return 1.0 - density * ((i + 0.5 + shift) / n);
}

// Weight of step i of n, exact for a mask that is constant over the step; all n add up to 1.
float shaftStepWeight(float i, float n, float density, float exponent)
{
    float all = 1.0 - shaftWeightBelow(1.0 - density, exponent);
    if (!(all > 1.0e-6)) return 1.0 / n;  // No way to go: equal weights.
    float near = shaftWeightBelow(1.0 - density * (i / n), exponent);
    return (near - shaftWeightBelow(1.0 - density * ((i + 1.0) / n), exponent)) / all;
}

// Geometric steps: the remaining share of the way after all passes, and the ratio of neighboring steps.
float shaftLeft(float density, float exponent)
{
    return max(1.0 - density, pow(SHAFT_REST, 1.0 / exponent));
}

float shaftRatio(float density, float exponent, float taps, float passes)
{
    return pow(shaftLeft(density, exponent), 1.0 / pow(taps, passes));
}

// Weight of tap i of a pass with ratio `ratio` between neighbors; all taps add up to 1.
float shaftTapWeight(float i, float taps, float ratio, float exponent)
{
    float d = powPositive(ratio, exponent);
    float all = 1.0 - powPositive(d, taps);
    return all > 1.0e-6 ? powPositive(d, i) * (1.0 - d) / all : 1.0 / taps;
}

// Sample position within a geometric step, relative to its beginning, so that `share` of the step's weight lies before
// it. Uniformly distributed shares give the mean of every step, however long the steps are.
float shaftTapPlace(float ratio, float exponent, float share)
{
    return powPositive(1.0 - share * (1.0 - powPositive(ratio, exponent)), 1.0 / exponent);
}

// Remaining strength of the rays if the light is `beyond` the picture's edge, in halves of the picture: 1 inside, 0
// from `margin` on. `beyond` is max(|x|, |y|) - 1 in normalized device coordinates; infinite on the camera's plane.
float shaftEdgeFade(float beyond, float margin)
{
    return 1.0 - smoothStep(0.0, max(margin, 1.0e-4), beyond);
}
