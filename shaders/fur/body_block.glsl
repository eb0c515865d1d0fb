// Bodies and their coats. Body space: meters, turns with the body. GLSL and C++: render/glsl/std140.h.
#define FUR_BODIES 3
#define FUR_PLANES 4

// Values of `marking`.
#define MARKING_NONE 0
#define MARKING_TICKED 1
#define MARKING_STRIPES 2
#define MARKING_SPOTS 3

#define FUR_BODY_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromBody) \
    FIELD(mat4, bodyFromWorld) \
    FIELD(vec3, tipOffset)             /* offset of the drawn tips, strand lengths, body space */ \
    FIELD(float, skinScale)           /* size of the drawn skin relative to the skin at rest */ \
    FIELD(vec4, tipRotation)             /* lag of the tips behind the body: quaternion, w last, body space */ \
    FIELD(vec3, wind)             /* strand lengths, body space */ \
    FIELD(float, gustPhase)       /* radians, wrapped */ \
    FIELD(float, strandLength)    /* meters */ \
    FIELD(float, cellSize)        /* meters */ \
    FIELD(float, strandRadius)    /* meters */ \
    FIELD(float, leastLength)     /* shortest strand relative to the longest, 0 to 1 */ \
    FIELD(vec3, rootColor)        /* linear Rec. 709 */ \
    FIELD(int, number)            /* number of the body, from 1 */ \
    FIELD(vec3, tipColor)         /* linear Rec. 709 */ \
    FIELD(int, planeCount) \
    FIELD(vec3, markColor)        /* linear Rec. 709 */ \
    FIELD(float, markSize)        /* distance between two markings, meters */ \
    FIELD(int, marking) \
    ARRAY(vec4, planes, FUR_PLANES)  /* pressing planes: xyz unit normal to the free side, body space; w distance */ \
    FIELD(float, shellCount)      /* may be fractional */ \
    FIELD(int, samplesBetween)    /* samples between two shells */ \
    FIELD(int, firstShell)        /* shell drawn by instance 0 */ \
    FIELD(bool, innerFirst)       /* inner shells are drawn first */ \
    FIELD(uint, seed) \
    FIELD(float, halfLength)      /* half length of the straight spine along x, meters */ \
    FIELD(float, ringRadius)      /* radius of the ring-shaped spine around y, meters; 0: the spine is straight */ \
    FIELD(float, radius)          /* radius of the skin at rest around the spine, meters */
BLOCK_STRUCT(FurBody, FUR_BODY_FIELDS)

// All bodies, for occlusion of one by another.
#define FUR_SCENE_FIELDS(FIELD, ARRAY) \
    ARRAY(FurBody, bodies, FUR_BODIES) \
    FIELD(mat4, worldFromPit) \
    FIELD(mat4, pitFromWorld) \
    FIELD(float, pitRadius)    /* meters */ \
    FIELD(float, pitRim)       /* height of its edge above its floor, meters */ \
    FIELD(float, rugRadius)    /* meters; 0: no rug */ \
    FIELD(vec3, rugColor)      /* linear Rec. 709 */ \
    FIELD(vec3, boxCenter)     /* center of the box around body 0 and its fur, body space */ \
    FIELD(vec3, boxHalfSize)
BLOCK_STRUCT(FurBodies, FUR_SCENE_FIELDS)
