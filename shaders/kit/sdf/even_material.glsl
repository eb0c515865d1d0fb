// Uniform material: that of SdfMaterialParameters.

FieldMaterial fieldMaterial(vec3 p)
{
    FieldMaterial m;
    m.baseColor = parameters.baseColor;
    m.metalness = parameters.metalness;
    m.roughness = parameters.roughness;
    m.specular = parameters.specular;
    m.refractiveIndex = parameters.refractiveIndex;
    return m;
}
