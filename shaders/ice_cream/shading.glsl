// Shading of the ice cream by the hall's light and a lamp of its own, or with REFERENCE_LIGHT by the light of the
// reference.
#ifdef REFERENCE_LIGHT
#include "ice_cream/reference_light.glsl"
#endif

// Share of a light in the direction `l` (local) that passes through the cream to a point: its path there is found by
// two samples of the field, each for the part of the way around it.
float throughCream(vec3 p, vec3 l)
{
    float depth = parameters.subsurfaceDepth;
    float inside = 0.0;
    for (int i = 0; i < 2; ++i) {
        float along = depth * (0.6 + 1.6 * float(i));
        inside += 1.5 * clamp(-iceCreamLevel(p + l * along), 0.0, 0.6 * depth);
    }
    evaluations += 2;
    return exp(-2.6 * inside / depth);
}

// Light of the lamp that enters the cream and leaves it at this point: a wrapped cosine where the cream is thin. The
// longer the way, the more of its color it takes on.
vec3 scatteredInCream(Surface s, vec3 p, vec3 n, vec3 toLamp, vec3 irradiance)
{
    float through = throughCream(p, toLamp);
    float wrapped = clamp((dot(n, toLamp) + 0.4) / 1.4, 0.0, 1.0);
    vec3 color = exp(log(max(s.baseColor, vec3(1.0e-3))) * (1.0 + 2.2 * (1.0 - through)));
    return color * irradiance * (wrapped * wrapped * through * (1.0 - s.metalness) / PI);
}

// Light of the lamp in front of the niche, and that of the backdrop behind the ice cream. They light nothing else, so
// they cost other exhibits nothing.
vec3 exhibitLight(Surface s, Hit hit, vec3 toEye)
{
    float away = 0.5 - 0.5 * dot(hit.localNormal, shape.towardsHall);
    vec3 color = s.baseColor * ((1.0 - s.metalness) * s.occlusion * away * away) * parameters.backdropColor * (parameters.backdrop * 0.6);
    vec3 toLamp = normalize(parameters.lampDirection);
    vec3 world = worldDirection(toLamp);
    vec3 irradiance = parameters.lampColor * parameters.lamp;
    float share = isCream(shadedPart) ? parameters.subsurface : 0.0;
    if (share > 0.0 && parameters.lamp > 0.0)
        color += scatteredInCream(s, hit.local, hit.localNormal, toLamp, irradiance) * share;
    if (parameters.lamp <= 0.0 || dot(s.normal, world) <= 0.0) return color;
    // The light that enters the cream is missing from what its surface scatters, not from its gloss.
    s.baseColor *= 1.0 - share;
    return color + lightReflected(s, toEye, world, irradiance * selfVisibility(hit, toLamp));
}

vec3 fieldRadiance(LocalRay ray, Hit hit, MarchSettings settings)
{
#ifndef REFERENCE_LIGHT
    return shadeFound(ray, hit, settings);
#else
    Surface s = bareSurface(hit, fieldMaterial(hit.local));
    s.normal = hit.localNormal;
    s.occlusion = referenceOcclusion(hit.local, hit.localNormal);
    return referenceFogged(referenceReflected(s, -ray.direction, selfVisibility(hit, referenceSun())), hit.traveled);
#endif
}
