// A lake with its lanterns at one moment. Lengths in meters of the lake's own world: y up, calm water at y = 0. GLSL
// and C++: render/glsl/std140.h.
#define LAKE_WAVES 28      // waves that tilt the water; the first of them also lift it
#define LAKE_TALL_WAVES 5
#define LAKE_LATTICE 256   // largest number of cells along a side of the lattice with individual lanterns

// Part of a lantern that a ray hit.
#define PART_NONE 0
#define PART_PAPER 1
#define PART_WOOD 2
#define PART_METAL 3

// Cells whose lanterns a step of a ray tests.
#define REPEAT_OWN_CELL 0
#define REPEAT_2X2 1
#define REPEAT_3X3 2
#define REPEAT_CELL_WALL 3

// Values of the permutation SHOW: the parameter "show".
#define SHOW_PICTURE 0
#define SHOW_HEIGHTS 1
#define SHOW_NORMALS 2
#define SHOW_PARTS 3

#define LAKE_FIELDS(FIELD, ARRAY) \
    FIELD(vec2, corner)          /* low corner of cell (0, 0) of the lattice */ \
    FIELD(float, cell)           /* width of a cell */ \
    FIELD(float, jitter)         /* largest offset of a lantern from the center of its cell, along each axis */ \
    FIELD(ivec2, cells)          /* size of the lattice: x to the right, y towards the back (-z) */ \
    FIELD(ivec2, firstCell)      /* number of cell (0, 0); lanterns keep their number when they drift */ \
    FIELD(float, fill)           /* share of cells with a lantern */ \
    FIELD(uint, seed) \
    FIELD(float, turn)           /* largest rotation of lanterns, as a share of a full turn */ \
    FIELD(float, variety)        /* variety of their colors, 0 to 1 */ \
    FIELD(float, paperRadius)    /* radius to the middle of the paper */ \
    FIELD(float, paperHeight)    /* height of its upper edge above the center of the base */ \
    FIELD(float, paperHalf)      /* half its thickness */ \
    FIELD(float, baseHalfWidth) \
    FIELD(float, baseHalfHeight) \
    FIELD(float, ringRadius)     /* radius of the wire of the two rings */ \
    FIELD(float, lowRing)        /* height of the lower one; the upper one is at the paper's edge */ \
    FIELD(float, postRadius) \
    FIELD(float, blend)          /* blend of posts and rings */ \
    FIELD(float, reach)          /* largest distance of any part from its axis, upright or tilted */ \
    FIELD(float, low)            /* bottom of the lanterns and ... */ \
    FIELD(float, high)           /* ... their top */ \
    FIELD(int, tallWaves)        /* number of waves that lift the water */ \
    FIELD(int, waves)            /* number of waves that tilt it */ \
    FIELD(int, rideWaves)        /* number of waves that move lanterns */ \
    FIELD(float, waveTop)        /* sum of the tall waves' amplitudes */ \
    FIELD(float, waveSlope)      /* sum of their slopes */ \
    FIELD(float, hiddenSlopes)   /* mean square slope along each axis of waves finer than the last one */ \
    FIELD(float, flickerTime)    /* seconds, within the flicker's period */ \
    FIELD(float, flickerDepth)   /* 0: constant; 1: the sum of three cosines */ \
    FIELD(float, flickerApart)   /* 1: each lantern has its own phase; 0: all have the same */ \
    FIELD(float, flameHeight)    /* above the center of the base */ \
    FIELD(vec3, candle)          /* radiant intensity of a flame without flicker */ \
    FIELD(float, paperScatter)   /* scattering coefficient of the paper times its thickness */ \
    FIELD(vec3, paperAbsorb)     /* absorption coefficient times thickness */ \
    FIELD(float, paperForward)   /* share of the transmitted light that paper of this thickness scatters forwards */ \
    FIELD(int, rowLimit)         /* largest number of rows of cells that a ray searches */ \
    FIELD(int, looks)            /* cells per row: two hold all that a ray can hit, three all that lights its air */ \
    FIELD(int, stepLimit)        /* step limit inside one lantern */ \
    FIELD(float, tolerance)      /* hit tolerance, pixels */ \
    FIELD(float, pointWidth)     /* a lantern is drawn as a point where a pixel is wider than this, meters */ \
    FIELD(float, meanWidth)      /* lanterns are replaced by their mean where a cone is wider than this, meters */ \
    FIELD(vec3, towardsMoon)     /* unit */ \
    FIELD(float, moonTanRadius) \
    FIELD(vec3, moonLight)       /* irradiance on a plane that faces it */ \
    FIELD(float, farRow)         /* distance of the farthest lanterns beyond the lattice from the frame; 0: none */ \
    FIELD(vec4, released)        /* released lantern: place, and its light; below 0: none */ \
    FIELD(vec4, releasedPose)    /* its tilt, turn and hue */ \
    FIELD(vec3, releasedGlow)    /* mean radiance of its paper and frame, seen from outside */ \
    FIELD(float, waterTime)      /* seconds, within an hour: for shading without a period */ \
    FIELD(vec3, farGlow)         /* the same of the lanterns beyond the lattice */ \
    FIELD(ivec2, freedCell)      /* number of the cell that the released lantern left */ \
    ARRAY(vec4, wave, LAKE_WAVES)          /* wave vector, radians per meter; amplitude, meters; phase, radians */ \
    ARRAY(vec4, ride, LAKE_TALL_WAVES)     /* the same for the height that moves lanterns */ \
    ARRAY(vec4, rideTilt, LAKE_TALL_WAVES) /* x: amplitude for the slope */
BLOCK_STRUCT(LakeBlock, LAKE_FIELDS)
