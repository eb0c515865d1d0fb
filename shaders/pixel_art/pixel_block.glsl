// The small picture: its lens, its light and how its depth is stored. GLSL and C++: render/glsl/std140.h.
#define PIXEL_FIELDS(FIELD, ARRAY) \
    FIELD(mat4, worldFromView)     /* of the small world, meters */ \
    FIELD(mat4, shadowFromView)    /* texture coordinates and depth of the shadow map */ \
    FIELD(vec3, sun)               /* towards it, view space */ \
    FIELD(vec3, up)                /* of the small world, view space */ \
    FIELD(vec2, halfExtent)        /* of the picture: meters, or tangents in perspective */ \
    FIELD(vec2, remainder)         /* what snapping left of the camera's place, texels */ \
    FIELD(ivec2, size)             /* texels */ \
    FIELD(float, nearPlane)        /* meters */ \
    FIELD(float, farPlane) \
    FIELD(bool, orthographic) \
    FIELD(bool, standardDepth)     /* near 0, far 1; else reversed */ \
    FIELD(float, depthLevels)      /* largest code of the depth buffer; 0: 32-bit floats */ \
    FIELD(int, divider)            /* first column of texels of the right half */ \
    FIELD(float, time)             /* seconds, in whole steps of the animation */
BLOCK_STRUCT(PixelBlock, PIXEL_FIELDS)
