// The small picture: projection, light and format of its depth. GLSL and C++: render/glsl/std140.h.
#define PIXEL_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromView)     /* of the small world's camera, meters */ \
    FIELD(mat4, shadowFromView)    /* texture coordinates and depth of the shadow map */ \
    FIELD(vec3, sun)               /* direction towards the sun, view space */ \
    FIELD(vec3, up)                /* up direction of the small world, view space */ \
    FIELD(vec2, halfExtent)        /* half size of the picture: meters, or tangents in perspective */ \
    FIELD(vec2, remainder)         /* offset of the camera that snapping to texels removed, texels */ \
    FIELD(ivec2, size)             /* texels */ \
    FIELD(float, nearPlane)        /* meters */ \
    FIELD(float, farPlane) \
    FIELD(bool, orthographic) \
    FIELD(bool, standardDepth)     /* near 0, far 1; else reversed */ \
    FIELD(float, depthLevels)      /* largest code of the depth buffer; 0: 32-bit floats */ \
    FIELD(int, divider)            /* first column of texels of the right half */ \
    FIELD(float, time)             /* seconds, rounded down to steps of the animation */
BLOCK_STRUCT(PixelBlock, PIXEL_FIELDS)
