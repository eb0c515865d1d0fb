// Camera, picture and time of a pass. GLSL and C++: render/glsl/std140.h.
#define FRAME_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, clipFromView)   /* projection of the tile with jitter; reversed depth, near 1, infinitely far 0 */ \
    FIELD(mat4, clipFromWorld) \
    FIELD(mat4, worldFromView) \
    FIELD(vec3, eye)            /* world space, meters */ \
    FIELD(float, nearPlane)     /* meters from the eye */ \
    FIELD(vec2, size)           /* size of the whole picture, pixels */ \
    FIELD(vec2, inverseSize)    /* 1/width, 1/height */ \
    FIELD(vec2, tileOrigin)     /* lower left corner of the tile in the whole picture plus jitter, pixels */ \
    FIELD(vec2, tanHalfFov)     /* tangents of half the field of view, horizontal and vertical */ \
    FIELD(vec2, tanShift)       /* tangents of the direction at the picture's center, off the axis */ \
    FIELD(float, time)          /* seconds, wrapped to a day */ \
    FIELD(int, sampleIndex)     /* index of the supersample, from 0 */ \
    FIELD(uint, seed) \
    FIELD(float, pixelAngle)    /* angle of one pixel, radians */
BLOCK_STRUCT(FrameBlock, FRAME_FIELDS)
