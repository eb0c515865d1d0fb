// Bodies and their coats. Body space: meters, turns with the body. GLSL and C++: render/glsl/std140.h.
#define FUR_BODIES 3
#define FUR_PLANES 4

#define FUR_BODY_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromBody) \
    FIELD(mat4, bodyFromWorld) \
    FIELD(vec3, tipOffset)             /* where tips are drawn, strand lengths, body space */ \
    FIELD(float, skinScale)           /* drawn skin over skin at rest */ \
    FIELD(vec4, tipRotation)             /* what the tips lag behind the body's turning: quaternion, w last, body space */ \
    FIELD(vec3, wind)             /* strand lengths, body space */ \
    FIELD(float, gustPhase)       /* radians, wrapped */ \
    FIELD(float, strandLength)    /* meters */ \
    FIELD(float, cellSize)        /* meters */ \
    FIELD(float, strandRadius)    /* meters */ \
    FIELD(float, leastLength)     /* of a strand against the longest, 0 to 1 */ \
    FIELD(vec3, rootColor)        /* linear Rec. 709 */ \
    FIELD(int, number)            /* of the body, from 1 */ \
    FIELD(vec3, tipColor)         /* linear Rec. 709 */ \
    FIELD(int, planeCount) \
    ARRAY(vec4, planes, FUR_PLANES)  /* of what presses: xyz unit normal away from it, body space; w distance */ \
    FIELD(float, shellCount)      /* need not be whole */ \
    FIELD(int, samplesBetween)    /* two shells */ \
    FIELD(int, firstShell)        /* drawn by instance 0 */ \
    FIELD(bool, innerFirst)       /* inner shells are drawn first */ \
    FIELD(uint, seed) \
    FIELD(float, halfLength)      /* of the straight spine along x, meters */ \
    FIELD(float, ringRadius)      /* of the round spine about y, meters; 0: it is straight */ \
    FIELD(float, radius)          /* of the skin at rest around the spine, meters */
BLOCK_STRUCT(FurBody, FUR_BODY_FIELDS)

// All bodies at once, for what looks from one to another.
#define FUR_SCENE_FIELDS(FIELD, ARRAY) \
    ARRAY(FurBody, bodies, FUR_BODIES) \
    FIELD(mat4, worldFromPit) \
    FIELD(mat4, pitFromWorld) \
    FIELD(float, pitRadius)    /* meters */ \
    FIELD(float, pitRim)       /* height of its edge over its floor, meters */ \
    FIELD(vec3, boxCenter)     /* of the box that body 0 fills with its fur, body space */ \
    FIELD(vec3, boxHalfSize)
BLOCK_STRUCT(FurBodies, FUR_SCENE_FIELDS)
