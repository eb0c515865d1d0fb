// The material of a generated scene, for the kit's march.

FieldMaterial fieldMaterial(vec3 p)
{
    SceneMaterial s = sceneSurface(p).material;
    FieldMaterial m;
    m.baseColor = s.color;
    m.metalness = s.metalness;
    m.roughness = s.roughness;
    m.specular = s.reflectance;
    m.refractiveIndex = s.refractiveIndex;
    return m;
}
