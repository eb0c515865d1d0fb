// Physically based surface: diffuse and a GGX highlight, lit by the sun, by baked or probed ambient light, and by the
// reflection probe. Burley 2012 for the roughness scale, Heitz 2014 for the masking term, Schlick 1994 for Fresnel.
#include "lib/light.glsl"

struct Surface {
    vec3 position;   // world space, meters
    vec3 normal;     // unit, facing the viewer
    vec3 baseColor;  // linear
    float metalness;
    float roughness; // perceptual
    float specular;  // 0.5 is 4 % reflectance at normal incidence
    vec3 ambient;    // irradiance over pi, occlusion included
    float occlusion; // occlusion of reflections, 0 to 1
};

vec3 surfaceF0(Surface s)
{
    return mix(vec3(0.08 * s.specular), s.baseColor, s.metalness);
}

vec3 fresnelSchlick(vec3 f0, float cosine)
{
    float m = clamp(1.0 - cosine, 0.0, 1.0);  // Clamped: pow of a negative number is NaN on llvmpipe.
    float m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}

// Directional albedo of the GGX lobe as scale and bias on F0; a fit in the manner of Karis 2014,
// "Physically Based Shading on Mobile".
vec2 environmentBrdf(float roughness, float cosNV)
{
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * cosNV)) * r.x + r.y;
    // The fit falls to -0.0003 for rough surfaces at grazing angles.
    return max(vec2(-1.04, 1.04) * a + r.zw, vec2(0.0));
}

// Highlight of a GGX surface for irradiance 1 on a plane that faces the light, over the cosine of the light and without
// Fresnel's reflectance. `widths` are its roughness squared along two perpendicular directions in the surface; half
// vector, light and eye are in the frame of these directions and the normal. Burley 2012, "Physically Based Shading at
// Disney", for the distribution, and Heitz 2014, equation 86, for the masking.
float highlightLobe(vec2 widths, vec3 h, vec3 toLight, vec3 toEye)
{
    vec3 stretch = vec3(widths, 1.0);
    vec3 slope = h / stretch;
    float steep = dot(slope, slope);
    float d = 1.0 / (PI * stretch.x * stretch.y * steep * steep);
    float v = 0.5 / (toLight.z * length(stretch * toEye) + toEye.z * length(stretch * toLight));
    return d * v;
}

// Unit vector with this cosine to the normal, for a highlight of equal widths, which depends on nothing else.
vec3 atCosine(float cosine)
{
    return vec3(safeSqrt(1.0 - cosine * cosine), 0.0, cosine);
}

// The peak of a near-mirror is limited, because averaging cannot remove an unbounded sample.
vec3 limitedHighlight(vec3 highlight)
{
    return min(highlight, vec3(64.0));
}

// Radiance reflected towards `toEye`, for light from direction `l` with this irradiance on a plane that faces it.
vec3 lightReflected(Surface s, vec3 toEye, vec3 l, vec3 irradiance)
{
    float cosL = dot(s.normal, l);
    if (cosL <= 0.0) return vec3(0.0);
    // The half vector is zero if the view direction is opposite to the light.
    vec3 h = safeNormalize(l + toEye, s.normal);
    float cosV = max(dot(s.normal, toEye), 1e-3);
    float cosH = clamp(dot(s.normal, h), 0.0, 1.0);
    float a = max(s.roughness * s.roughness, 0.003);
    float lobe = highlightLobe(vec2(a), atCosine(cosH), atCosine(cosL), atCosine(cosV));
    vec3 f = fresnelSchlick(surfaceF0(s), clamp(dot(toEye, h), 0.0, 1.0));
    vec3 diffuse = s.baseColor * (1.0 - s.metalness) * (1.0 - f) / PI;
    return (diffuse + limitedHighlight(f * lobe)) * irradiance * cosL;
}

// The same for the sun's light.
vec3 sunReflected(Surface s, vec3 toEye, float visibility)
{
    if (visibility <= 0.0) return vec3(0.0);
    return lightReflected(s, toEye, light.sunDirection, light.sunIrradiance * sunThroughGlass(s.position) * visibility);
}

#ifdef LOCAL_LIGHTS
#include "lib/local_lights.glsl"

// The same for one lamp. The highlight of a sphere is that of its center.
vec3 localLightReflected(Surface s, vec3 toEye, LocalLightEntry lamp)
{
    vec3 irradiance = localLit(lamp, s.position, s.normal);
    vec3 l = safeNormalize(lamp.position - s.position, s.normal);
    float cosL = dot(s.normal, l);
    // A part of a sphere may be visible although its center is below the horizon.
    return cosL > 1e-3 ? lightReflected(s, toEye, l, irradiance / cosL)
                       : s.baseColor * (1.0 - s.metalness) / PI * irradiance;
}

// The same for all lamps. Most places are out of reach of most lamps. The grid leaves few to look at (Olsson et al.
// 2012, "Clustered Deferred and Forward Shading"), and the inner loop skips those of them that do not reach: software
// renderers leave a loop when no pixel needs it, but execute skipped branches.
vec3 localLightsReflected(Surface s, vec3 toEye)
{
    vec3 sum = vec3(0.0);
    uint left = lightsNear(s.position);
    int i = max(findLSB(left), 0);
    while (true) {
        while (left != 0u && !localReaches(localLights.lights[i], s.position)) {
            left &= left - 1u;
            i = max(findLSB(left), 0);
        }
        if (left == 0u) break;
        sum += localLightReflected(s, toEye, localLights.lights[i]);
        left &= left - 1u;
        i = max(findLSB(left), 0);
    }
    return sum;
}
#endif

// Radiance towards the eye without the reflection.
vec3 shadeWithoutReflection(Surface s, vec3 toEye, float visibility)
{
    float cosV = clamp(dot(s.normal, toEye), 0.0, 1.0);
    vec2 brdf = environmentBrdf(s.roughness, cosV);
    vec3 reflectance = surfaceF0(s) * brdf.x + brdf.y;
    vec3 diffuse = s.baseColor * (1.0 - s.metalness) * (1.0 - reflectance) * s.ambient;
    vec3 color = diffuse + sunReflected(s, toEye, visibility);
#ifdef LOCAL_LIGHTS
    color += localLightsReflected(s, toEye);
#endif
    return color;
}

// Factor for the reflected radiance of the environment.
vec3 reflectance(Surface s, vec3 toEye)
{
    float cosV = clamp(dot(s.normal, toEye), 0.0, 1.0);
    vec2 brdf = environmentBrdf(s.roughness, cosV);
    return surfaceF0(s) * brdf.x + brdf.y;
}

vec3 shadeSurface(Surface s, vec3 toEye)
{
    vec3 mirrored = reflect(-toEye, s.normal);
    vec3 environment = probeRadiance(s.position, mirrored, s.roughness) * s.occlusion;
    return shadeWithoutReflection(s, toEye, sunVisibility(s.position, s.normal)) + reflectance(s, toEye) * environment;
}
