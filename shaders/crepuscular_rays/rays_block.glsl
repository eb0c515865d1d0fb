// What the passes of the sunbeams share. GLSL and C++: render/glsl/std140.h.
#define MOST_BEAMS 2

// An opening that the sun shines through, and the box of air around its beam; world space.
#define BEAM_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, openingLow) \
    FIELD(int, axis)          /* across the opening */ \
    FIELD(vec3, openingHigh) \
    FIELD(float, plane)       /* of the opening, on that axis */ \
    FIELD(vec3, airLow) \
    FIELD(vec3, airHigh)
BLOCK_STRUCT(BeamBlock, BEAM_FIELDS)

#define RAYS_FIELDS(FIELD, ARRAY) \
    FIELD(vec2, sun)               /* in pixels of the mask */ \
    FIELD(float, exponent)         /* of the weight along the way to the sun */ \
    FIELD(float, gathered)         /* share of the way to the sun that is gathered */ \
    FIELD(vec3, strength)          /* what a white mean adds to the radiance */ \
    FIELD(float, inverseExposure)  /* 1 over the exposure of the picture */ \
    FIELD(int, samples)            /* or taps, of this pass */ \
    FIELD(float, ratio)            /* of neighbors: of weights in the plain sum, of places for taps */ \
    FIELD(bool, isFirstPass)       /* of several with taps */ \
    FIELD(bool, sunIsBeyondEdge)   /* the polar grid does not go around it */ \
    FIELD(float, firstAngle)       /* of the polar grid, radians */ \
    FIELD(float, angleSpan)        /* radians */ \
    FIELD(float, logFirstRadius)   /* natural logarithm, of pixels of the mask */ \
    FIELD(float, logRadiusSpan)    /* ln of the last radius over the first */ \
    FIELD(int, radii)              /* of the polar grid */ \
    FIELD(int, angles) \
    FIELD(float, keep)             /* what a cell of it keeps of the sum before it */ \
    FIELD(float, cellSize)         /* pixels along a cell of a coarser image */ \
    FIELD(vec2, firstCell)         /* of the tile, on the grid of the whole picture */ \
    FIELD(float, maskScale)        /* mask pixels per picture pixel */ \
    FIELD(int, technique)          /* bits: 1 screen space, 2 volume */ \
    FIELD(float, threshold)        /* of the sky's brightness in the finished picture; 0: none */ \
    FIELD(float, lightAngle)       /* sky this far from the sun does not shine, radians */ \
    FIELD(bool, skyColors)         /* the mask has the sky's colors, else it is white */ \
    FIELD(bool, shiftSamples)      /* by blue noise */ \
    FIELD(int, beamCount) \
    FIELD(vec3, airLow)            /* of the box of air that holds dust; world space */ \
    FIELD(vec3, airHigh) \
    FIELD(vec3, drift)             /* meters that the dust has moved */ \
    ARRAY(BeamBlock, beams, MOST_BEAMS)
BLOCK_STRUCT(RaysBlock, RAYS_FIELDS)
