// Constants shared by the passes of the sunbeams. GLSL and C++: render/glsl/std140.h.
#define MOST_BEAMS 2

// An opening that the sun shines through, and the box of air around its beam; world space.
#define BEAM_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, openingLow) \
    FIELD(int, axis)          /* normal axis of the opening */ \
    FIELD(vec3, openingHigh) \
    FIELD(float, plane)       /* position of the opening on that axis */ \
    FIELD(vec3, airLow) \
    FIELD(vec3, airHigh)
BLOCK_STRUCT(BeamBlock, BEAM_FIELDS)

#define RAYS_FIELDS(FIELD, ARRAY) \
    FIELD(vec2, sun)               /* position in pixels of the mask */ \
    FIELD(float, exponent)         /* exponent of the weight along the way to the sun */ \
    FIELD(float, gathered)         /* share of the way to the sun that is gathered */ \
    FIELD(vec3, strength)          /* radiance added for a mask of 1 */ \
    FIELD(float, inverseExposure)  /* 1 over the exposure of the picture */ \
    FIELD(int, samples)            /* samples or taps of this pass */ \
    FIELD(float, ratio)            /* ratio of neighbors: weights in the plain sum, positions for taps */ \
    FIELD(bool, isFirstPass)       /* first of several passes with taps */ \
    FIELD(bool, sunIsBeyondEdge)   /* the polar grid does not extend around it */ \
    FIELD(float, firstAngle)       /* first angle of the polar grid, radians */ \
    FIELD(float, angleSpan)        /* radians */ \
    FIELD(float, logFirstRadius)   /* natural logarithm of the first radius, in pixels of the mask */ \
    FIELD(float, logRadiusSpan)    /* ln of the last radius over the first */ \
    FIELD(int, radii)              /* number of radii of the polar grid */ \
    FIELD(int, angles) \
    FIELD(float, keep)             /* share of the previous sum that a cell keeps */ \
    FIELD(float, cellSize)         /* side of a cell of a downsampled image, pixels */ \
    FIELD(vec2, firstCell)         /* first cell of the tile, on the grid of the whole picture */ \
    FIELD(float, maskScale)        /* mask pixels per picture pixel */ \
    FIELD(int, technique)          /* bits: 1 screen space, 2 volume */ \
    FIELD(float, threshold)        /* threshold of the sky's brightness in the finished picture; 0: none */ \
    FIELD(float, lightAngle)       /* radians: the sky farther from the sun is no light source */ \
    FIELD(bool, skyColors)         /* the mask has the sky's colors; otherwise it is white */ \
    FIELD(bool, shiftSamples)      /* dithers the samples by blue noise */ \
    FIELD(int, beamCount) \
    FIELD(vec3, airLow)            /* box of dusty air; world space */ \
    FIELD(vec3, airHigh) \
    FIELD(vec3, drift)             /* displacement of the dust, meters */ \
    ARRAY(BeamBlock, beams, MOST_BEAMS)
BLOCK_STRUCT(RaysBlock, RAYS_FIELDS)
