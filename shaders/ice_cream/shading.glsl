// Shading of the ice cream by the hall's light and a lamp of its own, or by the light of the reference.
#include "ice_cream/reference_light.glsl"

// Light of the lamp in front of the niche. It lights nothing else, so it costs other exhibits nothing.
vec3 exhibitLight(Surface s, Hit hit, vec3 toEye)
{
    if (parameters.lamp <= 0.0) return vec3(0.0);
    vec3 toLamp = normalize(parameters.lampDirection);
    vec3 world = worldDirection(toLamp);
    if (dot(s.normal, world) <= 0.0) return vec3(0.0);
    return lightReflected(s, toEye, world, parameters.lampColor * (parameters.lamp * selfVisibility(hit, toLamp)));
}

vec3 fieldRadiance(LocalRay ray, Hit hit, MarchSettings settings)
{
    if (parameters.lighting == lighting_hall) return shadeFound(ray, hit, settings);
    Surface s = bareSurface(hit, fieldMaterial(hit.local));
    s.normal = hit.localNormal;
    s.occlusion = referenceOcclusion(hit.local, hit.localNormal);
    return referenceFogged(referenceReflected(s, -ray.direction, selfVisibility(hit, referenceSun())), hit.traveled);
}
