// What the works behind the noise frame are drawn from at one moment. GLSL and C++: render/glsl/std140.h.
#define NOISE_OCTAVES 11
#define SEA_WAVES 64
#define SEA_HIGHEST 4.5  // One place of 300,000 is higher: rays begin there.
#define FIELD_REPEAT 16   // Cells after which an octave of the field repeats, so that a small volume holds it, ...
#define FIELD_TEXELS 8   // ... with as many texels along a cell.
#define NOISE_PERIOD 256  // Cells after which the noise of foam and high clouds repeats.
#define CLOUD_REPEAT 5200.0      // Meters after which the clouds' noise repeats, ...
#define CLOUD_FINE_REPEAT 830.0  // ... and that of their edges.
#define WEATHER_SCALE 0.31       // Of the weather against the clouds' noise.
#define NOISE_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, sunDirection)      /* towards the sun, unit */ \
    FIELD(float, time)             /* seconds, within an hour: for the source's looks, which know no period */ \
    FIELD(vec3, cloudShift)        /* meters that the clouds have moved, within a repeat of their noise ... */ \
    FIELD(int, octaves)            /* of the field: 1, or the table's */ \
    FIELD(vec3, fineShift)         /* ... of what eats away their edges ... */ \
    FIELD(float, amplitudes)       /* of the octaves, summed */ \
    FIELD(vec3, weatherShift)      /* ... and of the weather */ \
    FIELD(float, foamTime)         /* cells of the foam's noise that have gone by, within its period */ \
    FIELD(float, skyTime)          /* the same of the high clouds */ \
    FIELD(int, waves)              /* of the sea */ \
    FIELD(int, tallWaves)          /* the first ones, which decide where a ray meets the water */ \
    FIELD(float, seaTop)           /* SEA_HIGHEST standard deviations of their height, meters */ \
    FIELD(float, hiddenSlopes)     /* mean square slope of what is finer than the last wave */ \
    FIELD(float, sampleShift)      /* by which the supersample shifts steps, 0 to 1 */ \
    ARRAY(ivec4, cells, NOISE_OCTAVES)  /* origin of the work in the lattice of each octave, the last for the warp: the cell ... */ \
    ARRAY(vec4, places, NOISE_OCTAVES)  /* ... and the place in it */ \
    ARRAY(vec4, wave, SEA_WAVES)        /* wave vector, radians per meter; amplitude, meters; phase, radians */
BLOCK_STRUCT(NoiseBlock, NOISE_FIELDS)
