// State of the works behind the noise frame at one moment. GLSL and C++: render/glsl/std140.h.
#define NOISE_OCTAVES 11
#define SEA_WAVES 64
#define SEA_HIGHEST 4.5  // Standard deviations: exceeded at one place of 300,000, rays start there.
// Cells after which an octave of the field repeats, so that it fits in a small volume texture.
#define FIELD_REPEAT 16
#define FIELD_TEXELS 8    // Texels of that texture per cell.
#define FOAM_AGE 1.4      // Seconds for which foam is seen behind the crest that left it.
#define NOISE_PERIOD 256  // Cells after which the noise of foam and high clouds repeats.
#define CLOUD_REPEAT 5200.0      // Meters after which the clouds' noise repeats, ...
#define CLOUD_FINE_REPEAT 830.0  // ... and that of their edges.
#define WEATHER_SCALE 0.31       // Scale of the weather relative to the clouds' noise.
#define NOISE_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, sunDirection)      /* towards the sun, unit */ \
    FIELD(float, time)             /* seconds, within an hour: for the reference's shading, which has no period */ \
    FIELD(vec3, cloudShift)        /* displacement of the clouds, meters, within a period of their noise ... */ \
    FIELD(int, octaves)            /* octaves of the field: 1, or the parameter's number */ \
    FIELD(vec3, fineShift)         /* ... of the noise that erodes their edges ... */ \
    FIELD(float, amplitudes)       /* sum of the octaves' amplitudes */ \
    FIELD(vec3, weatherShift)      /* ... and of the weather */ \
    FIELD(float, foamTime)         /* time of the foam's noise in cells, within its period */ \
    FIELD(float, skyTime)          /* time of the high clouds' noise, likewise */ \
    FIELD(int, waves)              /* number of waves of the sea */ \
    FIELD(vec3, sunLight)          /* irradiance on a plane that faces the sun, at the ground ... */ \
    FIELD(float, foamBelow)        /* waves break where the water's area shrinks below this share; 0: nowhere */ \
    FIELD(vec3, sunOnClouds)       /* ... and at the height of cirrus */ \
    FIELD(vec3, skyAbove)          /* irradiance over pi of the sky on level ground */ \
    FIELD(float, foamDeviation)    /* standard deviation of the area of waves that break, at a chop of 1 */ \
    FIELD(vec3, skyAround)         /* mean radiance near the horizon */ \
    FIELD(float, skyScale)         /* exposure of the sky's table */ \
    FIELD(int, tallWaves)          /* number of the first waves that determine where a ray hits the water */ \
    FIELD(float, seaTop)           /* SEA_HIGHEST standard deviations of the height of these waves, meters */ \
    FIELD(float, hiddenSlopes)     /* mean square slope of waves finer than the last one */ \
    FIELD(float, sampleShift)      /* offset of the steps for this supersample, 0 to 1 */ \
    FIELD(vec4, halfFromTile)      /* from the tile to the picture of half the size, -1 to 1: factor, shift */ \
    FIELD(vec2, halfOrigin)        /* lower left corner of that picture in the tile, pixels of the tile */ \
    ARRAY(ivec4, cells, NOISE_OCTAVES)  /* origin in the lattice of each octave, the last for the warp: cell ... */ \
    ARRAY(vec4, places, NOISE_OCTAVES)  /* ... and place in it */ \
    ARRAY(vec4, wave, SEA_WAVES)        /* wave vector, radians per meter; amplitude, meters; phase, radians */ \
    ARRAY(vec4, breaking, SEA_WAVES)    /* share that can break, 0 to 1; its cosine and sine of the change of phase in FOAM_AGE */
BLOCK_STRUCT(NoiseBlock, NOISE_FIELDS)
