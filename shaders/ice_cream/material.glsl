// Material of each part; fieldPart is the part that the ray hit.
#include "lib/hash.glsl"
#include "ice_cream/surface_detail.glsl"

vec3 sprinkleColor(int kind)
{
    // The candies come in five colors; the first five have one of each.
    return parameters.sprinkleColors == sprinkleColors_candies ? shape.candies[kind].color : parameters.sprinkleColor;
}

vec3 partColor(int part)
{
    // Hues a golden ratio apart, so that neighbors differ.
    float hue = fract(0.08 + 0.618034 * float(part));
    return clamp(abs(fract(hue + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0) * 0.7 + 0.1;
}

FieldMaterial fieldMaterial(vec3 p)
{
    int part = fieldPart;
    shadedPart = part;
    FieldMaterial m;
    m.refractiveIndex = parameters.refractiveIndex;
    m.specular = 0.5;
    m.metalness = 0.0;
    if (part >= PART_CANDY && part < PART_SPRINKLE) {
        m.baseColor = shape.candies[part - PART_CANDY].color;
        m.roughness = parameters.candyRoughness;
        m.metalness = parameters.metalness;
    } else if (part >= PART_SPRINKLE) {
        m.baseColor = sprinkleColor(part - PART_SPRINKLE);
        m.roughness = parameters.candyRoughness;
        m.metalness = parameters.metalness;
    } else if (part == PART_PLINTH) {
        m.baseColor = parameters.plinthColor;
        m.roughness = parameters.plinthRoughness;
    } else if (part >= PART_CREAM) {
        m.baseColor = part == PART_CREAM ? shape.layers[0].color : shape.layers[1].color;
        m.roughness = mix(parameters.creamRoughness, 0.14, meltedShare(p));
        m.metalness = parameters.metalness;
    } else {
        m.baseColor = bakedColor(p, part);
        m.roughness = parameters.waferRoughness;
        m.metalness = parameters.metalness;
    }
    if (shape.stage < STAGE_COLORS && part != PART_PLINTH) {
        m.baseColor = vec3(0.5);
        m.metalness = 0.0;
    }
    if (parameters.colorBy == colorBy_part) {
        m.baseColor = partColor(part);
        m.metalness = 0.0;
    }
    if (shape.stage < STAGE_SPECULAR) {
        m.roughness = 1.0;
        m.specular = 0.0;
    }
    if (parameters.material == material_glass && parameters.lighting == lighting_hall) m.baseColor = parameters.glassColor;
    return m;
}
