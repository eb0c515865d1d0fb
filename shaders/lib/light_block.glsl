// The light of a place: sun, sky, shadow maps, reflection probe. GLSL and C++: render/glsl/std140.h.

// What lies beyond walls. Shaders are compiled for one, BACKGROUND, and for one SHADOW_FILTER: software renderers run
// what a branch leaves out.
#define BACKGROUND_SKY 0
#define BACKGROUND_PANORAMA 1
#define BACKGROUND_STUDIO 2

// Openings of a room through which the sun comes.
#define MOST_SUN_PASSAGES 2

// How a shadow map is looked up.
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
    FIELD(float, skyLightmapScale)       /* what the sky lightmap's 1 stands for */ \
    FIELD(vec3, lampsOnWalls)            /* what the 1 of its alpha stands for: the vault's lamps */ \
    FIELD(vec3, skyHorizon)              /* radiance */ \
    FIELD(float, environmentRotation)        /* rotation of the panorama, radians */ \
    FIELD(vec3, probePosition)           /* world space */ \
    FIELD(float, probeLastLevel)         /* mip level of the roughest mirror image */ \
    FIELD(vec3, probeLow)                /* box of the parallax correction, world space; none where high <= low */ \
    FIELD(float, bakedOcclusion)         /* how much baked light dims the probe's mirror image, 0 to 1 */ \
    FIELD(vec3, probeHigh) \
    FIELD(float, exposure)               /* radiance times this is what the film sees */ \
    FIELD(vec3, airLow)                  /* corners of the points in the air whose light is known, world space */ \
    FIELD(bool, hasAirLight)             /* it is */ \
    FIELD(vec3, airHigh) \
    FIELD(bool, hallCastsShadow)         /* the hall's shadow map is bound and up to date */ \
    FIELD(bool, exhibitsCastShadow)      /* the exhibits' shadow map is */ \
    FIELD(bool, hasProbe)                /* the probe is */ \
    FIELD(float, sunTanHalfWidth)        /* tangent of half the angle that the sun's disk takes */ \
    FIELD(int, sunDiskSamples)           /* comparisons over the sun's disk */ \
    FIELD(int, sampleIndex)              /* which supersample, from 0 */ \
    FIELD(vec3, skySunward)              /* radiance that the horizon has more below the sun */ \
    FIELD(vec3, roomLow)                 /* air between walls into which the sun comes by passages alone, world space; */ \
    FIELD(vec3, roomHigh)                /* none where high <= low */ \
    ARRAY(vec4, sunPassages, MOST_SUN_PASSAGES) /* low and high corner of each in the hall's shadow map; none as well */
BLOCK_STRUCT(LightBlock, LIGHT_FIELDS)
