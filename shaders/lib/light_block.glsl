// Lighting of a place: sun, sky, shadow maps, reflection probe. GLSL and C++: render/glsl/std140.h.

// Kinds of background outside the walls. Shaders are compiled for one BACKGROUND and one SHADOW_FILTER, because
// software renderers execute skipped branches.
#define BACKGROUND_SKY 0
#define BACKGROUND_PANORAMA 1
#define BACKGROUND_STUDIO 2

// Openings of a room through which the sun shines.
#define MOST_SUN_PASSAGES 2

// Methods of filtering a shadow map.
#define SHADOW_FILTER_HARD 0
#define SHADOW_FILTER_TENT_3 1
#define SHADOW_FILTER_TENT_5 2
#define SHADOW_FILTER_SUN_DISK 3

#define LIGHT_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, hallShadowFromWorld)     /* xy: texture coordinates, z: reversed depth */ \
    FIELD(mat4, exhibitShadowFromWorld) \
    FIELD(vec3, sunDirection)            /* towards the sun, unit */ \
    FIELD(float, hallShadowTexel)        /* width of a texel of the hall's shadow map, meters */ \
    FIELD(vec3, sunIrradiance)           /* on a plane that faces the sun */ \
    FIELD(float, exhibitShadowTexel)     /* width of a texel of the exhibits' shadow map, meters */ \
    FIELD(vec3, skyZenith)               /* radiance */ \
    FIELD(float, skyLightmapScale)       /* share of the sky's radiance that a value of 1 in the sky lightmap stands for */ \
    FIELD(vec3, lampsOnWalls)            /* light of the vault's lamps that a value of 1 in its alpha stands for */ \
    FIELD(vec3, skyHorizon)              /* radiance */ \
    FIELD(float, environmentRotation)        /* rotation of the panorama, radians */ \
    FIELD(vec3, probePosition)           /* world space */ \
    FIELD(float, probeLastLevel)         /* mip level of the roughest mirror image */ \
    FIELD(vec3, probeLow)                /* box of the parallax correction, world space; none where high <= low */ \
    FIELD(float, bakedOcclusion)         /* how much baked light darkens the probe's reflection, 0 to 1 */ \
    FIELD(vec3, probeHigh) \
    FIELD(float, exposure)               /* factor from radiance to the tone mapper's input */ \
    FIELD(vec3, airLow)                  /* corners of the grid of light probes in the air, world space */ \
    FIELD(bool, hasAirLight)             /* the grid is bound */ \
    FIELD(vec3, airHigh) \
    FIELD(bool, hallCastsShadow)         /* the hall's shadow map is bound and up to date */ \
    FIELD(bool, exhibitsCastShadow)      /* the exhibits' shadow map is bound and up to date */ \
    FIELD(bool, hasProbe)                /* the reflection probe is bound and up to date */ \
    FIELD(float, sunTanHalfWidth)        /* tangent of half the sun's apparent angle */ \
    FIELD(int, sunDiskSamples)           /* number of shadow comparisons over the sun's disk */ \
    FIELD(int, sampleIndex)              /* index of the supersample, from 0 */ \
    FIELD(vec3, skySunward)              /* radiance added at the horizon below the sun */ \
    FIELD(vec3, roomLow)                 /* inside of a room that the sun enters only by passages, world space; */ \
    FIELD(vec3, roomHigh)                /* none where high <= low */ \
    ARRAY(vec4, sunPassages, MOST_SUN_PASSAGES) /* low and high corner of each in the hall's shadow map; none where high <= low */
BLOCK_STRUCT(LightBlock, LIGHT_FIELDS)
