// The surface of each pixel between the two steps of deferred shading (FramePlan::withDeferredShading).
// Permutations: STORE_SURFACE (location of the first of three color outputs), LIGHT_STORED (reads them).
#include "lib/octahedron.glsl"

struct StoredSurface {
    Surface surface;   // all but the ambient light
    vec2 atlasUv;      // coordinates in the lightmaps
    float roomAmbient; // mean over the colors of the room's irradiance over pi
};

#ifdef STORE_SURFACE
layout(location = STORE_SURFACE) out vec4 storedPlace;
layout(location = STORE_SURFACE + 1) out vec4 storedColor;
layout(location = STORE_SURFACE + 2) out vec4 storedLight;

void storeSurface(StoredSurface s)
{
    storedPlace = vec4(octahedronPoint(s.surface.normal), 1.0 / gl_FragCoord.w, s.surface.roughness);
    storedColor = vec4(s.surface.baseColor, s.surface.metalness);
    // Specular in steps of 1/1000, occlusion in those of 1/8192.
    float both = floor(s.surface.specular * 1000.0 + 0.5) + 0.5 * s.surface.occlusion;
    storedLight = vec4(s.atlasUv, both, s.roomAmbient);
}
#endif

#ifdef LIGHT_STORED
layout(binding = UNIT_BASE_COLOR) uniform sampler2D storedPlace;
layout(binding = UNIT_NORMAL) uniform sampler2D storedColor;
layout(binding = UNIT_ORM) uniform sampler2D storedLight;

// Returns what is stored of this pixel. Its roughness is 0 where nothing was drawn.
StoredSurface storedSurface()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(storedPlace, pixel, 0);
    vec4 color = texelFetch(storedColor, pixel, 0);
    vec4 light = texelFetch(storedLight, pixel, 0);
    vec3 position = frame.eye + frameRay(gl_FragCoord.xy) * place.z;
    float specular = floor(light.z);
    return StoredSurface(Surface(position, octahedronDirection(place.xy), color.rgb, color.a, place.w,
                                 specular * 0.001, vec3(0.0), 2.0 * (light.z - specular)),
                         light.xy, light.w);
}
#endif
