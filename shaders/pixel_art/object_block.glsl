// A part of the small world with its transform. GLSL and C++: render/glsl/std140.h.
#ifndef __cplusplus
#include "kit/surface_object_block.glsl"
#endif
#define PIXEL_OBJECT_FIELDS(FIELD, ARRAY) \
    FIELD(SurfaceObject, surface) \
    FIELD(float, id)      /* added to the vertices' id */ \
    FIELD(bool, painted)  /* tangents hold color and id, `extra` glow and pattern */
BLOCK_STRUCT(PixelObjectBlock, PIXEL_OBJECT_FIELDS)
