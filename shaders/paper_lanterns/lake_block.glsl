// A lake with its lanterns at one moment. Lengths in meters of the lake's own world: y up, calm water at y = 0.
// GLSL and C++: render/glsl/std140.h.
#define LAKE_WAVES 28      // that tilt the water; the first of them lift it, too
#define LAKE_TALL_WAVES 5
#define LAKE_LATTICE 256   // cells along each side of the lattice in which lanterns are told apart, at most

// What a ray has met of a lantern.
#define PART_NONE 0
#define PART_PAPER 1
#define PART_WOOD 2
#define PART_METAL 3

// Which lanterns a step of a ray looks at.
#define REPEAT_OWN_CELL 0
#define REPEAT_2X2 1
#define REPEAT_3X3 2
#define REPEAT_CELL_WALL 3

#define LAKE_FIELDS(FIELD, ARRAY) \
    FIELD(vec2, corner)          /* where the cell (0, 0) of the lattice begins */ \
    FIELD(float, cell)           /* width of a cell */ \
    FIELD(float, jitter)         /* by which a lantern is off the middle of its cell at most, along each axis */ \
    FIELD(ivec2, cells)          /* of the lattice: x to the right, y towards the back (-z) */ \
    FIELD(ivec2, firstCell)      /* who drifts keeps its number: that of the cell (0, 0) */ \
    FIELD(float, fill)           /* share of the cells that have a lantern */ \
    FIELD(uint, seed) \
    FIELD(float, turn)           /* share of a whole turn that lanterns are turned by at most */ \
    FIELD(float, variety)        /* of their colors, 0 to 1 */ \
    FIELD(float, paperRadius)    /* of the middle of the paper */ \
    FIELD(float, paperHeight)    /* of its upper edge over the middle of the base */ \
    FIELD(float, paperHalf)      /* half its thickness */ \
    FIELD(float, baseHalfWidth) \
    FIELD(float, baseHalfHeight) \
    FIELD(float, ringRadius)     /* of the wire of the two rings */ \
    FIELD(float, lowRing)        /* height of the lower one; the upper one lies on the paper's edge */ \
    FIELD(float, postRadius) \
    FIELD(float, blend)          /* of posts and rings */ \
    FIELD(float, reach)          /* no part of a lantern is farther from its axis, upright or tilted */ \
    FIELD(float, low)            /* below that and ... */ \
    FIELD(float, high)           /* ... above that is nothing of a lantern */ \
    FIELD(int, tallWaves)        /* that lift the water */ \
    FIELD(int, waves)            /* that tilt it */ \
    FIELD(int, rideWaves)        /* that lanterns ride */ \
    FIELD(float, waveTop)        /* sum of the amplitudes of the tall ones */ \
    FIELD(float, waveSlope)      /* the same of their slopes */ \
    FIELD(float, hiddenSlopes)   /* mean square slope, along each axis, of waves finer than the last one */ \
    FIELD(float, flickerTime)    /* seconds, within the flicker's period */ \
    FIELD(float, flickerDepth)   /* 0: even; 1: as the three cosines say */ \
    FIELD(float, flickerApart)   /* 1: each lantern has a phase of its own; 0: all have the same */ \
    FIELD(float, flameHeight)    /* over the middle of the base */ \
    FIELD(vec3, candle)          /* radiant intensity of a flame, before it flickers */ \
    FIELD(float, paperScatter)   /* of the paper: scattering times thickness */ \
    FIELD(vec3, paperAbsorb)     /* absorption times thickness */ \
    FIELD(int, rowLimit)         /* rows of cells that a ray looks for lanterns in */ \
    FIELD(int, looks)            /* cells in each: two hold all that a ray can touch, three what lights its air */ \
    FIELD(int, stepLimit)        /* steps in one lantern */ \
    FIELD(float, tolerance)      /* how near a ray must come, pixels */ \
    FIELD(float, pointWidth)     /* a lantern over which a pixel is wider than this is a glowing point, meters */ \
    FIELD(float, meanWidth)      /* lanterns along a cone that is wider than this count as their mean, meters */ \
    FIELD(vec3, towardsMoon)     /* unit */ \
    FIELD(float, moonTanRadius) \
    FIELD(vec3, moonLight)       /* irradiance on what faces it */ \
    FIELD(float, farRow)         /* lanterns beyond the lattice reach so far from the frame; 0: none */ \
    FIELD(vec4, released)        /* of the lantern that was set free: place, and its light; below 0: none */ \
    FIELD(vec4, releasedPose)    /* its tilt, turn and hue */ \
    FIELD(ivec2, freedCell)      /* number of the cell that it has left empty */ \
    FIELD(float, waterTime)      /* seconds, within an hour: for looks that know no period */ \
    ARRAY(vec4, wave, LAKE_WAVES)          /* wave vector, radians per meter; amplitude, meters; phase, radians */ \
    ARRAY(vec4, ride, LAKE_TALL_WAVES)     /* the same of the height that lanterns ride */ \
    ARRAY(vec4, rideTilt, LAKE_TALL_WAVES) /* x: amplitude by which the slope is told */
BLOCK_STRUCT(LakeBlock, LAKE_FIELDS)
