// Color, opacity and emission of a glTF material, for every shader that draws models. Include it after a block with
// `SurfaceObject object`, before main. Permutations: BASE_COLOR_MAP, VERTEX_COLOR, EMISSIVE_MAP, SECOND_UV (some maps are
// read at the second texture coordinates).
layout(binding = UNIT_BASE_COLOR) uniform sampler2D baseColorMap;
layout(binding = UNIT_EMISSIVE) uniform sampler2D emissiveMap;
#ifdef VERTEX_COLOR
in vec4 vertexColor;  // linear Rec. 709; a: opacity
#endif

#ifdef SECOND_UV
in vec2 secondUv;
#endif

// Texture coordinates of a map, given by its bit; `uv` are the first ones.
vec2 mapUv(int map, vec2 uv)
{
#ifdef SECOND_UV
    if ((object.secondUv & map) != 0) return secondUv;
#endif
    return uv;
}

// Base color, linear Rec. 709; a: opacity.
vec4 materialColor(vec2 uv)
{
    vec4 base = object.baseColor;
#ifdef BASE_COLOR_MAP
    base *= texture(baseColorMap, mapUv(mapBaseColor, uv));
#endif
#ifdef VERTEX_COLOR
    base *= vertexColor;
#endif
    return base;
}

// Emitted radiance.
vec3 materialEmission(vec2 uv)
{
    vec3 emitted = object.emissive;
#ifdef EMISSIVE_MAP
    emitted *= texture(emissiveMap, mapUv(mapEmissive, uv)).rgb;
#endif
    return emitted;
}
