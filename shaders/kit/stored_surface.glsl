// The surface of each pixel between the two steps of deferred shading (FramePlan::withDeferredShading).
// Permutations: STORE_SURFACE (location of the first of four color outputs), LIGHT_STORED (reads them).
struct StoredSurface {
    Surface surface;   // all but the ambient light
    vec2 atlasUv;      // coordinates in the lightmaps
    float roomAmbient; // mean over the colors of the room's irradiance over pi
};

#ifdef STORE_SURFACE
layout(location = STORE_SURFACE) out vec4 storedPlace;
layout(location = STORE_SURFACE + 1) out vec4 storedNormal;
layout(location = STORE_SURFACE + 2) out vec4 storedColor;
layout(location = STORE_SURFACE + 3) out vec4 storedLight;

void storeSurface(StoredSurface s)
{
    storedPlace = vec4(s.surface.position, s.roomAmbient);
    storedNormal = vec4(s.surface.normal, s.surface.roughness);
    storedColor = vec4(s.surface.baseColor, s.surface.metalness);
    storedLight = vec4(s.atlasUv, s.surface.occlusion, s.surface.specular);
}
#endif

#ifdef LIGHT_STORED
layout(binding = UNIT_BASE_COLOR) uniform sampler2D storedPlace;
layout(binding = UNIT_NORMAL) uniform sampler2D storedNormal;
layout(binding = UNIT_ORM) uniform sampler2D storedColor;
layout(binding = UNIT_EMISSIVE) uniform sampler2D storedLight;

// Returns what is stored of this pixel. Its roughness is 0 where nothing was drawn.
StoredSurface storedSurface()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(storedPlace, pixel, 0);
    vec4 normal = texelFetch(storedNormal, pixel, 0);
    vec4 color = texelFetch(storedColor, pixel, 0);
    vec4 light = texelFetch(storedLight, pixel, 0);
    return StoredSurface(Surface(place.xyz, normal.xyz, color.rgb, color.a, normal.w, light.w, vec3(0.0), light.z),
                         light.xy, place.w);
}
#endif
