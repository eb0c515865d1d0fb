// Shading by the hall's light only.

vec3 exhibitLight(Surface s, Hit hit, vec3 toEye)
{
    return vec3(0.0);
}

vec3 fieldRadiance(LocalRay ray, Hit hit, MarchSettings settings)
{
    return shadeFound(ray, hit, settings);
}
