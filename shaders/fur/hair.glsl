// Scattering by a hair, and by a coat of hairs.
//
// GLSL 4.50 and C++ (exhibits/fur/strand_cpu.h).

// Directions of light and eye (unit vectors away from the hair) as angles relative to the hair.
struct HairAngles {
    float sinThetaI;     // sine of the angle of the light to the plane across the hair
    float sinThetaO;     // sine of the angle of the eye to that plane
    float cosHalfThetaD; // cosine of half the difference of these two angles
    float cosPhi;        // cosine of the angle between light and eye around the hair
    float cosine;        // cosine of the angle between light and eye
};

// Scattering lobes of a hair for one pair of directions, 1/steradian: light reflected at the surface (R), transmitted
// (TT), and reflected inside (TRT).
struct HairLobes {
    float r;
    vec3 tt;
    vec3 trt;
};

HairAngles hairAngles(vec3 along, vec3 toLight, vec3 toEye)
{
    HairAngles a;
    a.sinThetaI = clamp(dot(along, toLight), -1.0, 1.0);
    a.sinThetaO = clamp(dot(along, toEye), -1.0, 1.0);
    float cosThetaI = safeSqrt(1.0 - a.sinThetaI * a.sinThetaI);
    float cosThetaO = safeSqrt(1.0 - a.sinThetaO * a.sinThetaO);
    a.cosine = clamp(dot(toLight, toEye), -1.0, 1.0);
    // cos(x/2) of the difference x of two angles within a quarter turn, computed from its cosine.
    a.cosHalfThetaD = max(safeSqrt(0.5 + 0.5 * (cosThetaI * cosThetaO + a.sinThetaI * a.sinThetaO)), 0.05);
    a.cosPhi = clamp((a.cosine - a.sinThetaI * a.sinThetaO) / max(cosThetaI * cosThetaO, 1.0e-3), -1.0, 1.0);
    return a;
}

// Normal distribution of standard deviation `width` around 0.
float hairCone(float width, float x)
{
    return exp(-0.5 * x * x / (width * width)) / (width * 2.5066282746310002);
}

vec3 positivePower(vec3 base, float exponent)
{
    return exp(log(max(base, vec3(1.0e-5))) * exponent);
}

// Lobes R, TT and TRT of a hair with scales (Marschner et al. 2003, "Light Scattering from Human Hair Fibers") in the
// fit of Karis 2016, "Physically Based Hair Shading in Unreal": cones shifted by the tilt of the scales, 2 degrees,
// index 1.55, azimuths in closed form. `roughness` 0 to 1; `color`: white light after passing a hair, linear.
// Multiplied by the irradiance on a plane that faces the light, the result is radiance. The sum of all three over the
// sphere is at most 1.
HairLobes hairLobes(HairAngles a, vec3 color, float roughness)
{
    const float tilt = 0.035;     // radians
    const float atNormal = 0.0465;  // ((1 - 1.55) / (1 + 1.55))^2
    const float kept = 0.94;        // the fit gains up to 6 %
    float width = max(roughness * roughness, 0.02);
    float sum = a.sinThetaI + a.sinThetaO;
    float cosHalfPhi = safeSqrt(0.5 + 0.5 * a.cosPhi);
    HairLobes lobes;

    float cosThetaO = safeSqrt(1.0 - a.sinThetaO * a.sinThetaO);
    float shift = -4.0 * tilt * (cosHalfPhi * cosThetaO - 2.0 * tilt * a.sinThetaO);
    float halfway = safeSqrt(0.5 + 0.5 * a.cosine);
    lobes.r = hairCone(max(width * 1.4142135623730951 * cosHalfPhi, 0.02), sum - shift) * (0.25 * kept) * cosHalfPhi *
              schlick(halfway, atNormal);

    float bent = 1.0 / (1.19 / a.cosHalfThetaD + 0.36 * a.cosHalfThetaD);
    float offset = clamp(cosHalfPhi * (1.0 + bent * (0.6 - 0.8 * a.cosPhi)), -1.0, 1.0);
    float entered = 1.0 - schlick(a.cosHalfThetaD * safeSqrt(1.0 - offset * offset), atNormal);
    float path = 0.5 * safeSqrt(1.0 - offset * offset * bent * bent) / a.cosHalfThetaD;
    lobes.tt = positivePower(color, path) *
               (hairCone(0.5 * width, sum - tilt) * exp(-3.65 * a.cosPhi - 3.98) * kept * entered * entered);

    float mirrored = schlick(a.cosHalfThetaD * 0.5, atNormal);
    lobes.trt = positivePower(color, 0.8 / a.cosHalfThetaD) *
                (hairCone(2.0 * width, sum - 4.0 * tilt) * exp(17.0 * a.cosPhi - 16.78) * kept * mirrored *
                 (1.0 - mirrored) * (1.0 - mirrored));
    return lobes;
}

// Share of the skin that strands cover, 0 to 1, from the number of strands that a line along the skin would cross; 0
// for almost no strands. `cellSize`: that of strandCellSize; all lengths in meters.
float coatCover(float cellSize, float strandRadius, float strandLength)
{
    float crossed = 2.0 * strandRadius * strandLength / (1.7320508075688772 * cellSize * cellSize);
    return 1.0 - exp(-0.7 * crossed);
}

// Forward-scattered light behind `crossed` layers of hairs of this color, of light of which each layer leaves 1/e
// unscattered. Light hair glows where dark hair is dark (after Zinke et al. 2008, "Dual Scattering Approximation for
// Fast Multiple Scattering in Hair", whose forward attenuation is the mean color of the hair).
vec3 forwardScattered(float crossed, vec3 color)
{
    return exp((sqrt(color) * 0.5 - vec3(1.0)) * crossed);
}

// Share of the ambient light that reaches a place whose unoccluded share is `open`, 0 to 1. The occluders are hairs of
// the same color, which scatter some of it on. Always above 0, and 1 for open = 1.
vec3 scatteredOcclusion(float open, vec3 color)
{
    const float least = 0.1;
    float direct = least + (1.0 - least) * clamp(open, 0.0, 1.0);
    return exp((vec3(1.0) - sqrt(color) * 0.2) * log(direct));
}
